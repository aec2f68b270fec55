// Short messages on the screen: "saved enfilade-0003.png", or what is wrong with a map that was just saved.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "app/draw/overlay.h"

namespace enfilade {

class Notices {
public:
    /// Shown at the top until `seconds` after now [s].
    void say(std::string text, double now_s, double seconds = 3);

    /// The same, instead of the one before about the same: of something that changes step by step.
    void update(std::string_view about, std::string text, double now_s, double seconds = 3);

    /// A panel that stays until it is replaced; empty lines take it away.
    void pin(std::vector<std::string> lines) { pinned_ = std::move(lines); }

    void draw(Overlay& overlay, double now_s);

private:
    struct Notice {
        std::string text;
        double until_s;
        std::string about{};  ///< may be empty
    };
    std::vector<Notice> notices_;
    std::vector<std::string> pinned_;
};

}  // namespace enfilade
