// What SDL says when it fails. Included by the files of platform/ only.
#pragma once
#include <SDL.h>
#include <string>

#include "base/result.h"

namespace enfilade {

/// "WHERE: cannot DOING: REASON", with SDL's newest reason.
inline Error sdl_error(const char* where, const std::string& doing) {
    return {where, "cannot " + doing + ": " + SDL_GetError()};
}

}  // namespace enfilade
