// What a tilted picture is planned in: the surroundings of the eye as four pictures that are not tilted, each a quarter
// of a turn wide, whose columns and rows stand for all rays in them.
#pragma once
#include "render/pose.h"
#include "render/stencil/ray_field.h"
#include "render/stencil/screen.h"
#include "render/stencil/window.h"

namespace enfilade::stencil {

inline constexpr std::size_t kFaces = 4;

/// One of the four; they are alike.
Screen panorama_screen();

/// The eye turned to the right by so many quarters.
Pose face_of(const Pose& pose, std::size_t quarters);

/// What of that face the picture shows.
Window panorama_window(const Screen& face, const RayField& rays, std::size_t quarters);

}  // namespace enfilade::stencil
