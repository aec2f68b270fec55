// The column renderer held against the reference, pixel by pixel.
#pragma once
#include <cstdint>
#include <string>

#include "hard_cases/poses.h"
#include "map/textures.h"
#include "render/frame.h"
#include "world/snapshot.h"

namespace enfilade::test {

/// How two pictures of the same view, or of many views, differ [px].
struct Comparison {
    std::uint64_t pixels = 0;
    std::uint64_t unwritten = 0;      ///< by the column renderer
    std::uint64_t written_twice = 0;  ///< or more often
    std::uint64_t wrong = 0;          ///< shows another surface than the reference
    std::uint64_t other_texel =
        0;  ///< same surface, another colour, but on a texel's edge or a step of light: rounding decides
    std::uint64_t wrong_color = 0;  ///< same surface, another colour, and no such excuse
    std::string first_fault;        ///< what and where the first pixel that is wrong is; empty: none

    bool is_faultless() const { return unwritten == 0 && written_twice == 0 && wrong == 0 && wrong_color == 0; }
    Comparison& operator+=(const Comparison& other);
};

/// What there is to look at, and what it is called in reports.
struct Subject {
    std::string name;  ///< the map's file, for the command line that shows the pixel
    const Map& map;
    const TextureSet& textures;
};

/// One view by both renderers.
struct BothPictures {
    Frame column, reference;
    FrameFacts column_facts, reference_facts;
};

BothPictures draw_by_both(const Subject& subject, const Snapshot& snapshot, const View& view, PictureSize size);

/// How they differ, and in one pixel, by row; without a first fault.
Comparison differences(const Subject& subject, const BothPictures& both);
Comparison difference_at(const Subject& subject, const BothPictures& both, std::size_t pixel);

/// "lower step of wall 5 (0,0 -> 1,0) of 'hall'"
std::string surface_text(const Map& map, PixelSurface id);

/// Draws one view with both renderers.
Comparison compare(const Subject& subject, const Snapshot& snapshot, const View& view, PictureSize size);

/// What the player sees at the start, by rays through the middles and through the corners of pixels.
Comparison compare_at_start(const Subject& subject, PictureSize size);

enum class PoseKind { random, lattice };

/// Draws `count` views of the map at rest with both renderers, on two threads. The same seed gives the same views.
Comparison compare_poses(const Subject& subject, PoseKind kind, int count, PictureSize size, std::uint64_t seed);

/// The counts and the first fault.
std::string describe(const Comparison& comparison);

/// The command line that draws the view.
std::string command_line(const std::string& map_name, const Map& map, const View& view, PictureSize size);

}  // namespace enfilade::test
