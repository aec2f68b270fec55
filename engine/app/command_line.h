// The whole command line, as a function.
#pragma once

namespace enfilade {

/// Runs `enfilade` with these arguments and returns its exit code (app/exit_codes.h).
int run_command_line(int argc, const char* const* argv);

}  // namespace enfilade
