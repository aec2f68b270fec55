// What the program can do without: a picture by this renderer, the sound, a map that is loaded while another is played.
#pragma once
#include <functional>
#include <string>

#include "base/result.h"

namespace enfilade {

/// Does the work; an error where it could not be finished, because a contract was broken in it, memory could not be
/// had, or a library threw. What it was working on is then to be thrown away: its objects are sound to destroy, and not
/// more.
///
/// Unwinds the stack, with parallel_for's threads, up to here. Nothing else may throw or catch: errors are Results.
/// Where the engine is built without exceptions, a broken contract stops the program as it does outside of attempts.
Result<void> attempt(const std::function<void()>& work);

/// Ends what is being done as `new` does where it gets no memory: for libraries that get none and say so otherwise.
[[noreturn]] void out_of_memory();

/// Whether an attempt is under way in this thread.
bool is_attempting();

/// For threads that work for another: as long as this lives, an attempt is under way in this thread, or none. Its owner
/// catches what ends the attempt and hands it to the other thread.
class Attempting {
public:
    explicit Attempting(bool is_attempting);
    Attempting(const Attempting&) = delete;
    Attempting& operator=(const Attempting&) = delete;
    ~Attempting();

private:
    bool before_;
};

/// From here on the program ends as run_program() says where an exception cannot be thrown, or nobody catches it. For a
/// function that is called before all others ([[gnu::constructor]] of the first priority): libraries take memory for
/// constants of their own before main(). name: of the program; lives as long.
void end_in_a_sentence(const char* name);
inline constexpr int kBeforeAllConstants = 101;  ///< that priority: those below it are the compiler's

/// Runs a program: `work`'s exit status, or, where memory cannot be had or something else was thrown, 1, after one
/// sentence on stderr that begins with the program's name and takes no memory itself. Temporary files are removed. A
/// limit of the size of files (ulimit -f) does not end the program, and closed standard streams harm no file: writing
/// fails.
int run_program(const char* name, const std::function<int()>& work);

}  // namespace enfilade
