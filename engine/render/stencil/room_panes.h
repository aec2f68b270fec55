// What stands in a room, in the order in which each column meets it.
#pragma once
#include <cstdint>
#include <vector>

#include "render/stencil/plan.h"
#include "render/stencil/room_look.h"

namespace enfilade::stencil {

/// Finds the things and panels of one visit at a time. A room without them costs a look at two empty lists.
class RoomPanes {
public:
    RoomPanes(const FrameInput& input, const Screen& screen) : input_(input), screen_(screen) {}

    /// For a new frame: nothing is passed yet.
    void start() { passed_.assign(static_cast<std::size_t>(screen_.width), 0); }

    /// Adds what stands in the room that is looked into, and is seen, to the layer's panes: for every run of columns
    /// that meet the same pictures in the same order these pictures, the nearest first;
    /// of a thing and a panel at one depth, in steps (render/sprite.h), the thing.
    /// Those beyond kMostPictures in a column, the farthest, are left out: of two rooms the nearer is to be noted
    /// first.
    void note(Layer& layer, const RoomLook& room);

    /// One more in column x, of a portal. False: it is left out.
    bool pass(int x) { return !is_full(x) && ++passed_[static_cast<std::size_t>(x)] > 0; }

private:
    struct PaneBoard {
        Pane pane;
        Segment facing{{}, {}};  ///< panels only
        PanelId panel;           ///< none: a thing
        double depth = 0;        ///< things only [m]
    };

    bool is_full(int x) const { return passed_[static_cast<std::size_t>(x)] >= kMostPictures; }
    void add_met(std::size_t board, int x);
    void find_boards(const Pose& pose, const RoomLook& room);
    void add_panel(const Pose& pose, const RoomLook& room, PanelId id);
    void meet(const Pose& pose, const RoomLook& room, int x);
    bool is_met(const Pose& pose, const RoomLook& room, const PaneBoard& thing, int x) const;
    void meet_panels(const RoomLook& room, int x);
    bool is_before(const PaneBoard& a, const PaneBoard& b) const;
    bool is_before_wall(const RoomLook& room, const PaneBoard& panel, int x) const;
    void add_run(Layer& layer, int begin, int end, int rank);

    const FrameInput& input_;
    const Screen& screen_;
    std::vector<PaneBoard> boards_;        ///< things first, the nearest of them first; then panels
    std::size_t things_ = 0;               ///< how many of them are things
    std::vector<std::size_t> met_, run_;   ///< by the present column, and by those before it: numbers of boards
    std::vector<std::size_t> met_panels_;  ///< by the present column
    std::vector<std::uint32_t> passed_;    ///< pictures, by column
};

}  // namespace enfilade::stencil
