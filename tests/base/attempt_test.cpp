// Work that may fail and be left: broken contracts, shortages of memory and threads.
#include "base/attempt.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <new>
#include <stdexcept>
#include <vector>

#include "base/parallel.h"
#include "base/result.h"

namespace enfilade {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

std::string fault_of(const std::function<void()>& work) {
    const Result<void> result = attempt(work);
    return result.ok() ? "none" : result.error().text();
}

TEST(Attempt, OfWhatGoesWellHasNoFault) {
    EXPECT_EQ(fault_of([] {}), "none");
}

TEST(Attempt, TellsOfABrokenContract) {
    EXPECT_THAT(fault_of([] { ENFILADE_CHECK(1 == 2); }), EndsWith("broken contract: 1 == 2"));
}

TEST(Attempt, TellsOfMemoryThatCannotBeHad) {
    EXPECT_EQ(fault_of([] { throw std::bad_alloc(); }), "there is not enough memory for this");
}

TEST(Attempt, TellsWhatALibraryThrew) {
    EXPECT_EQ(fault_of([] { throw std::runtime_error("no luck"); }), "a fault in a library: no luck");
}

TEST(Attempt, EndsInEveryThreadThatWorksForIt) {
    for (const std::size_t workers : {1u, 2u, 8u}) {
        const auto work = [&] {
            parallel_for(1000, workers, [](std::size_t i, std::size_t) { ENFILADE_CHECK(i != 500); });
        };
        EXPECT_THAT(fault_of(work), HasSubstr("i != 500")) << workers;
    }
}

TEST(Attempt, DestroysWhatItLeaves) {
    struct Counted {
        explicit Counted(int& count) : count_(count) { ++count_; }
        ~Counted() { --count_; }
        int& count_;
    };
    int alive = 0;
    fault_of([&] {
        const Counted object(alive);
        ENFILADE_CHECK(alive == 0);
    });
    EXPECT_EQ(alive, 0);
}

TEST(AttemptDeathTest, IsOverWhenItHasEnded) {
    fault_of([] { ENFILADE_CHECK(false); });
    fault_of([] {});
    EXPECT_FALSE(is_attempting());
    EXPECT_DEATH(ENFILADE_CHECK(1 == 3), "attempt_test.cpp:[0-9]+: broken contract: 1 == 3");
}

TEST(AttemptDeathTest, IsNotUnderWayInOtherThreads) {
    EXPECT_DEATH(parallel_for(8, 4, [](std::size_t i, std::size_t) { ENFILADE_CHECK(i != 5); }), "i != 5");
}

/// How a process ends that runs the work as a program, and what it says.
std::pair<int, std::string> run_as_program(const std::function<int()>& work) {
    int pipe_ends[2];
    if (::pipe(pipe_ends) != 0) return {-1, ""};
    const pid_t child = fork();
    if (child == 0) {
        ::dup2(pipe_ends[1], STDERR_FILENO);
        _exit(run_program("prog", work));
    }
    ::close(pipe_ends[1]);
    std::string said;
    char part[100];
    for (ssize_t length; (length = ::read(pipe_ends[0], part, sizeof part)) > 0;)
        said.append(part, std::size_t(length));
    ::close(pipe_ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), said};
}

const std::string kNoMemory = "prog: there is not enough memory for this\n";

TEST(RunProgram, GivesTheStatusOfItsWork) {
    EXPECT_EQ(run_as_program([] { return 2; }), std::pair(2, std::string()));
}

TEST(RunProgram, EndsWithASentenceWhereMemoryCannotBeHad) {
    EXPECT_EQ(run_as_program([]() -> int { throw std::bad_alloc(); }), std::pair(1, kNoMemory));
}

TEST(RunProgram, EndsWithASentenceWhereAnExceptionCannotGetThrough) {
    const auto fail = [] { throw std::bad_alloc(); };
    const auto work = [&]() noexcept -> int { return fail(), 0; };
    EXPECT_EQ(run_as_program(work), std::pair(1, kNoMemory));
}

TEST(RunProgram, EndsWithASentenceInAThreadToo) {
    const auto work = [] {
        parallel_for(100, 4, [](std::size_t i, std::size_t) {
            if (i == 50) throw std::bad_alloc();
        });
        return 0;
    };
    EXPECT_EQ(run_as_program(work), std::pair(1, kNoMemory));
}

TEST(ParallelFor, DoesAllWithTheThreadsThatThereAre) {
    const auto work = [] {
        constexpr uid_t kNobody = 65534;
        if (::geteuid() == 0 && ::setuid(kNobody) != 0) return 3;  // root may have as many as it likes
        const rlimit none{1, 1};
        if (::setrlimit(RLIMIT_NPROC, &none) != 0) return 3;
        std::vector<int> done(1000, 0);
        parallel_for(done.size(), 64, [&](std::size_t i, std::size_t) { ++done[i]; });
        for (const int times : done)
            if (times != 1) return 1;
        return 0;
    };
    EXPECT_EQ(run_as_program(work), std::pair(0, std::string()));
}

}  // namespace
}  // namespace enfilade
