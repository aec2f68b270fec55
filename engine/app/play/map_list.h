// Which maps there are to play, and a small picture of each.
#pragma once
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "render/frame.h"

namespace enfilade {

enum class MapOrigin : std::uint8_t { shipped, own, converted, wad };

struct ListedMap {
    std::string path, name;
    MapOrigin origin = MapOrigin::shipped;
};

/// In the order in which they are shown: those that come with Enfilade; the player's own, in the folder maps of the
/// user's folder for data; levels that were converted; and the WADs that are installed, converted before or not: to
/// tell, all of each would have to be read. Cost: a look into each folder and map.
std::vector<ListedMap> find_maps();

/// What a map's picture is like [px].
inline constexpr int kPictureWidth = 192, kPictureHeight = 120;

/// Draws pictures of maps in a thread of its own, one after the other, and keeps them in the user's cache.
class MapPictures {
public:
    MapPictures();
    ~MapPictures();
    MapPictures(const MapPictures&) = delete;
    MapPictures& operator=(const MapPictures&) = delete;

    /// The picture, or none: it will be there later; empty where the map cannot be drawn.
    std::optional<Frame> find(const std::string& map_path);

    /// How many there are; grows when one comes.
    std::size_t count();

private:
    void work();

    std::mutex mutex_;
    std::condition_variable wanted_;
    std::map<std::string, Frame> pictures_;
    std::deque<std::string> queue_;
    bool ends_ = false;
    std::thread worker_;
};

}  // namespace enfilade
