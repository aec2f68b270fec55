#include "base/attempt.h"

#include <sys/uio.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>

#include "base/files.h"

namespace enfilade {
namespace {

thread_local bool attempt_is_under_way = false;

/// Thrown by broken contracts, inside attempts only.
class BrokenContract : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

constexpr const char* kNoMemory = "there is not enough memory for this";

/// What was thrown, as a sentence without an end.
Error what_was_thrown() {
    try {
        throw;
    } catch (const BrokenContract& broken) {
        return {"", std::string("a fault in this program, please report it: ") + broken.what()};
    } catch (const std::bad_alloc&) {
        return {"", kNoMemory};
    } catch (const std::exception& other) {
        return {"", std::string("a fault in a library: ") + other.what()};
    } catch (...) {
        return {"", "a fault in a library"};
    }
}

iovec piece(const char* text) { return {const_cast<char*>(text), std::strlen(text)}; }

/// "NAME: what" on stderr, without taking memory, and in one piece, whoever else writes there.
void say_last_words(const char* name, const char* what) {
    const iovec pieces[] = {piece(name), piece(": "), piece(what), piece("\n")};
    if (writev(STDERR_FILENO, pieces, 4) < 0) return;  // nobody is left to be told
}

const char* program_name = "";  // a terminate handler gets no arguments

/// An exception for which there is no memory is none.
bool is_memory_short() {
    constexpr std::size_t kSome = std::size_t{1} << 20;
    void* const some = std::malloc(kSome);
    std::free(some);
    return some == nullptr;
}

/// Where an exception cannot get through: the same last words as elsewhere.
[[noreturn]] void end_the_program() {
    remove_temporary_files();
    const char* what = is_memory_short() ? kNoMemory : "it had to end";
    try {
        if (std::current_exception()) throw;
    } catch (const std::bad_alloc&) {
        what = kNoMemory;
    } catch (...) {
        what = "a fault in a library";
    }
    say_last_words(program_name, what);
    std::_Exit(EXIT_FAILURE);
}

}  // namespace

bool is_attempting() { return attempt_is_under_way; }

Attempting::Attempting(bool is_attempting) : before_(attempt_is_under_way) { attempt_is_under_way = is_attempting; }
Attempting::~Attempting() { attempt_is_under_way = before_; }

void out_of_memory() { throw std::bad_alloc(); }

void contract_broken(const char* file, int line, const char* text) {
    if (is_attempting())
        throw BrokenContract(std::string(file) + ":" + std::to_string(line) + ": broken contract: " + text);
    remove_temporary_files();
    std::fprintf(stderr, "%s:%d: broken contract: %s\n", file, line, text);
    std::abort();
}

Result<void> attempt(const std::function<void()>& work) {
    try {
        const Attempting here(true);
        work();
        return {};
    } catch (...) {
        return what_was_thrown();
    }
}

void end_in_a_sentence(const char* name) {
    program_name = name;
    std::set_terminate(end_the_program);
}

int run_program(const char* name, const std::function<int()>& work) {
    end_in_a_sentence(name);
    guard_standard_streams();
    std::signal(SIGXFSZ, SIG_IGN);  // a file that would become too long is an error of the write, as a full disk is
    try {
        return work();
    } catch (const std::bad_alloc&) {
        say_last_words(name, kNoMemory);
    } catch (const std::exception& other) {
        say_last_words(name, other.what());
    }
    return EXIT_FAILURE;
}

}  // namespace enfilade
