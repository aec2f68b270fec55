#include "wadconv/next_maps.h"

#include <array>

namespace enfilade::wadconv {
namespace {

/// Where one comes back to from an episode's ninth level, by episode; later ones as the fourth.
constexpr std::array kAfterNinth = {'4', '6', '7', '3'};

std::string next_of_episode(std::string_view map, bool by_secret_exit) {
    std::string next(map);
    if (map[3] == '9')
        next[3] = kAfterNinth[map[1] >= '1' && map[1] <= '4' ? static_cast<std::size_t>(map[1] - '1') : 3];
    else if (by_secret_exit)
        next[3] = '9';
    else if (map[3] == '8')
        return {};
    else
        ++next[3];
    return next;
}

std::string numbered(int number) {
    return std::string("MAP") + static_cast<char>('0' + number / 10) + static_cast<char>('0' + number % 10);
}

}  // namespace

std::string next_map(std::string_view map, bool by_secret_exit) {
    if (map.starts_with('E')) return next_of_episode(map, by_secret_exit);
    const int number = (map[3] - '0') * 10 + (map[4] - '0');
    if (by_secret_exit && number == 15) return numbered(31);
    if (by_secret_exit && number == 31) return numbered(32);
    if (number == 31 || number == 32) return numbered(16);
    if (number == 30 || number == 99) return {};
    return numbered(number + 1);
}

}  // namespace enfilade::wadconv
