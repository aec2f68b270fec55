// The heart of the project: sectors and portals drawn one screen column at a time.
//
// A frame is a stack of viewports. Drawing one: project its sector's walls, find in each open column the nearest wall
// beyond the portal looked through, draw ceiling, wall or steps, and floor, and hand what is still open behind a portal
// to a new viewport with tightened bounds. Where to read: column_renderer.cpp (the stack, and the strips that threads
// share), viewport_drawer.h (one viewport; where are its things and panels?), sector_projection.h (where is this wall
// on screen?), viewport.h (which wall does a column see, and which rows are what?), painters.h (which texel?),
// flat_rows.h (how far away and how dark is a row of a floor?), kernels.h (the inner loops).
#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/parallel.h"
#include "formats/dials.h"
#include "map/map.h"
#include "map/textures.h"
#include "render/frame.h"
#include "render/lighting.h"
#include "render/sampling.h"
#include "render/view.h"
#include "world/snapshot.h"

namespace enfilade {

namespace column {
struct TexelDials;
}  // namespace column

/// Columns [begin, end) of a picture.
struct ColumnRange {
    int begin = 0;
    int end = 0;
    bool operator==(const ColumnRange&) const = default;
};

/// Outline of one viewport of the last frame, for overlays.
struct ViewportOutline {
    SectorId sector;
    int depth = 0;                 ///< portals looked through
    int begin = 0, end = 0;        ///< columns
    std::vector<int> top, bottom;  ///< open rows by column when it was drawn [end - begin]
    std::vector<double> boundary;  ///< by column: 1 / depth of the portal looked through; infinite in the eye's sector
};

/// Work done for the last frame.
struct ColumnCounts {
    std::size_t viewports = 0;  ///< drawn
    int deepest = 0;            ///< portals looked through in the longest chain
    std::size_t cut = 0;        ///< viewports not drawn because a limit was reached
    bool is_cut_short = false;  ///< that was kLookBudget for at least one of them (render/openings.h)
};

/// Draws pictures of one map. Keeps its scratch memory from frame to frame: once the hardest view has been drawn,
/// drawing allocates nothing. One renderer draws one picture at a time; different renderers may draw different columns
/// of the same frame at the same time.
class ColumnRenderer {
public:
    /// map, textures: outlive it.
    ColumnRenderer(const Map& map, const TextureSet& textures);
    /// What several renderers that draw parts of the same pictures share; outlives them.
    struct Shared {
        LightGrids& lights;                         ///< of the map
        const column::TexelDials* dials = nullptr;  ///< null: texels are exact
    };
    ColumnRenderer(const Map& map, const TextureSet& textures, const Shared& shared);
    ~ColumnRenderer();
    ColumnRenderer(ColumnRenderer&&) noexcept;
    ColumnRenderer& operator=(ColumnRenderer&&) noexcept;

    /// Draws the whole picture. Every pixel is written exactly once.
    ///
    /// frame    : its size is the picture's; every pixel is set
    /// facts    : null, or what each pixel shows, of the same size after reset(); noted at some cost in time
    /// snapshot : heights and lights of the moment, one for each sector of the map
    /// view     : view.sector contains view.eye under the tie rule; not tilted
    void render(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view);

    /// The same for some columns only; they are bit-equal to those of the whole picture. Frame::is_cut_short is not
    /// set, for that is about all columns.
    void render_columns(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view,
                        ColumnRange columns);

    ColumnCounts counts() const;

    /// The last frame's viewports in the order they were begun. Allocates; for overlays and tests.
    std::vector<ViewportOutline> viewports() const;

private:
    friend class ColumnStrips;

    /// Memory that a picture is drawn by way of, and what is known of the picture so far. Renderers that draw parts of
    /// it one after another may share one: then rays and walls are worked out once for all of them.
    class Workspace;

    /// The same in a shared workspace. picture: a number from 1 on that the parts of this picture have, and no other
    /// picture that is drawn in that workspace.
    void render_columns(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view,
                        ColumnRange columns, Workspace& workspace, std::uint64_t picture);

    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// One picture drawn by several threads, each a strip of columns at a time.

/// Pixels of a cache line.
inline constexpr int kLinePixels = kCacheLineBytes / sizeof(std::uint32_t);

/// Columns that one thread draws at a time, and to whose share of the picture they belong, [0, threads).
struct Strip {
    ColumnRange columns;
    std::size_t share;

    bool operator==(const Strip&) const = default;
};

/// Cuts the columns [0, width) of a picture into strips, left to right, none of them empty and none wider than `widest`
/// (>= kLinePixels), but where a picture is narrower than there are threads (>= 1) some get no share. Shares are even.
/// One thread's strips are even, too; those of several grow narrower to the right of each share, down to kLinePixels:
/// whoever is done first goes on with another's share, and nobody waits long for whoever draws the last, narrow one.
/// Strips meet where a row has a cache line's end, so that no two threads write to one line: in every row, where the
/// width is a multiple of kLinePixels; otherwise no cut spares all rows. The list is overwritten: it keeps its memory.
void cut_into_strips(int width, std::size_t threads, int widest, std::vector<Strip>& strips);

/// Column renderers and threads that share a picture. There are more strips than threads. Each thread draws its own,
/// the same ones frame after frame, whose memory is in its core's cache, and then what others have not begun yet: one
/// that meets simple rooms draws more of them. A large picture is cut for one thread, too, so that what is drawn stays
/// in cache. The picture is the same, bit for bit, for any number of threads, because every pixel is computed from its
/// own column and row.
class ColumnStrips {
public:
    /// map, textures: outlive it. threads >= 1: they end with this. dials: only those of texels and light_grid
    /// count here.
    ColumnStrips(const Map& map, const TextureSet& textures, std::size_t threads, const Dials& dials = {});
    ~ColumnStrips();

    /// As ColumnRenderer::render.
    void render(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view);

    /// The viewports of each strip of the last frame, left to right. Allocates; for overlays and tests.
    std::vector<std::vector<ViewportOutline>> viewports() const;

private:
    const Map& map_;
    const TextureSet& textures_;
    std::size_t threads_;
    std::unique_ptr<LightGrids> lights_;
    std::unique_ptr<MipChains> mips_;            ///< where dials ask for them
    std::unique_ptr<column::TexelDials> dials_;  ///< null: texels are exact
    std::vector<ColumnRenderer> renderers_;      ///< by strip: each remembers its viewports
    std::vector<Strip> strips_;                  ///< of the last frame
    std::vector<std::atomic_flag> is_taken_;     ///< by strip: some thread draws it, or has
    /// By thread: it draws strip after strip in memory that stays in cache.
    std::vector<std::unique_ptr<ColumnRenderer::Workspace>> workspaces_;
    std::uint64_t pictures_ = 0;  ///< drawn
    ThreadPool pool_;
};

}  // namespace enfilade
