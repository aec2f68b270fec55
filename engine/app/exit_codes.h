// How every command ends: the exit status, and the one sentence on stderr that explains it.
#pragma once
#include "base/result.h"

namespace enfilade {

inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;  ///< a map with errors, a file that cannot be read or written, frames that differ
inline constexpr int kUsage = 2;   ///< the command line itself makes no sense

/// Prints "enfilade: error" and gives kFailed.
int fail(const Error& error);

/// Prints "enfilade: error" and gives kUsage.
int refuse_usage(const Error& error);

}  // namespace enfilade
