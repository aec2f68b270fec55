// Many views of one map to picture files, on several threads.
#pragma once
#include <string>
#include <vector>

#include "app/messages.h"
#include "app/open_map.h"
#include "app/options.h"
#include "base/result.h"
#include "render/choice/renderer.h"
#include "render/outside/outside_camera.h"
#include "render/view.h"
#include "world/snapshot.h"

namespace enfilade {

/// What to draw, and where to put it. Empty paths: not wanted.
struct PictureJob {
    std::vector<View> views;
    PictureSize size;
    RendererKind renderer = RendererKind::column;
    Dials dials;
    double time_s = 0;  ///< the moment that is shown
    LeftOut left_out;
    std::size_t threads = 1;  ///< >= 1
    Talk talk = Talk::usual;
    std::string out;               ///< a .png file for the one view, or a folder for 000000.png onward
    std::string ids;               ///< the same for pictures of surface ids
    std::string id_list;           ///< a CSV file of what the ids stand for
    std::string timing;            ///< a CSV file `view,ns`
    std::string from_above;        ///< the same as `out` for pictures of the view from outside
    std::string from_behind;       ///< and for those
    std::vector<PixelPlace> at;    ///< what these pixels of each view show is told on standard output
    double reach_m = kUsualReach;  ///< of both (render/outside/outside_camera.h) [m]
};

/// An error where a path names one picture file but there are several views.
Result<void> check_outputs(const PictureJob& job);

/// Draws and writes everything. With timing, views are drawn one after another, each by all threads, so that nothing
/// disturbs the clock; else several views are drawn at a time.
Result<void> draw_pictures(const OpenMap& map, const PictureJob& job);

}  // namespace enfilade
