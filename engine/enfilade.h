// The engine for programs of others: how a frame is drawn, from a map's file to a buffer of pixels. It brings what the
// steps need; every header it includes says more, and may be included alone.
//
// - map file → LoadedMap, load_map(): map and pictures, or findings that say what is wrong and where
// - LoadedMap → Renderer, make_renderer(): column (software), stencil (OpenGL) or reference; one for each map
// - map, time → Snapshot, snapshot_at(): heights, lights and things at a moment when nobody has done anything
// - map, place → View, view_at_start() and view_from(): where the eye is and how it looks
// - Snapshot, View → Frame, Renderer::render(): 0xAABBGGRR by row, row 0 at the top
//
// Somebody who walks through the map is a World: start_of() begins it, step() lets a tick pass, show()
// makes a Snapshot that of the moment now(), and eye_between_ticks() is where the View comes from. A scripted camera is
// a Flight (flight/flight.h). What is drawn depends on what is handed in and on nothing else: the same arguments give
// the same bytes, with any compiler and any number of threads.
//
// Nothing throws. What can fail is a Result<T>, or a Result<void>, whose error() is a sentence for people
// (base/result.h). The programs in engine/examples/ are the shortest that do something.
#pragma once
#include "base/files.h"
#include "base/finding.h"
#include "base/result.h"
#include "flight/flight.h"
#include "formats/map_toml.h"
#include "formats/png.h"
#include "map/load.h"
#include "render/choice/renderer.h"
#include "render/frame.h"
#include "render/view.h"
#include "world/snapshot.h"
#include "world/step.h"
