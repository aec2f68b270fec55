// The title screen's page of maps: a picture and a name for each, in rows.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/draw/overlay.h"
#include "app/play/map_list.h"
#include "platform/input_event.h"

namespace enfilade {

/// What choosing on the page asks for.
enum class MapPageAction : std::uint8_t { none, leave, choose };

class MapPage {
public:
    bool is_open() const { return is_open_; }
    void open() { is_open_ = true; }
    void close() { is_open_ = false; }
    void set_maps(std::vector<ListedMap> maps);
    /// Goes to the map of that path, if there is one.
    void choose(const std::string& path);

    /// Ignores everything while closed.
    MapPageAction handle(const InputEvent& event);
    /// The one that was chosen; there is one after `choose`.
    const ListedMap& chosen() const { return maps_[static_cast<std::size_t>(chosen_)]; }

    /// note : below the maps, instead of what is said about the chosen one; may be empty. Draws nothing while closed.
    void draw(Overlay& overlay, MapPictures& pictures, const std::string& note);

private:
    struct MapBox {
        Rect area;
        int map;
    };
    MapPageAction press(KeyCode key);
    MapPageAction press(GamepadButton button);
    MapPageAction choose() const { return maps_.empty() ? MapPageAction::none : MapPageAction::choose; }
    void move(int steps);
    int map_at(double x, double y) const;
    void draw_map(Overlay& overlay, const ListedMap& map, const Rect& area, bool is_chosen, MapPictures& pictures);

    std::vector<ListedMap> maps_;
    std::vector<MapBox> boxes_;  ///< of the maps that were drawn last
    int chosen_ = 0, columns_ = 1;
    bool is_open_ = false;
};

}  // namespace enfilade
