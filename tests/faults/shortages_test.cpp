// Memory that cannot be had, disks that are full: every call fails once, and each time the work ends in a sentence, or
// well, and every file is the old one or the new one.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include "faults/injected.h"
#include "faults/work.h"

namespace enfilade::test {
namespace {

using ::testing::AnyOf;
using ::testing::Eq;
using ::testing::IsEmpty;

/// The last line of a text, without its end.
std::string last_line(std::string text) {
    if (text.ends_with('\n')) text.pop_back();
    const std::size_t start = text.rfind('\n');
    return start == std::string::npos ? text : text.substr(start + 1);
}

class Shortage : public ::testing::Test {
protected:
    void expect_well_ended(const Workshop::Work& work, const Outcome& outcome, std::size_t nth) {
        SCOPED_TRACE(work.name + ", call " + std::to_string(nth) + ": " + outcome.err);
        EXPECT_THAT(outcome.status, AnyOf(Eq(0), Eq(1)));
        if (outcome.status == 1) {
            const bool is_finding = (outcome.out + outcome.err).find("map.toml: error: ") != std::string::npos;
            EXPECT_TRUE(is_finding || last_line(outcome.err).starts_with("enfilade: "));
        }
        EXPECT_THAT(shop_.broken_files(work, outcome.status == 0), IsEmpty());
        EXPECT_THAT(shop_.left_behind(), IsEmpty());
        shop_.clean_up();
    }

    /// How many such calls the work makes when all goes well.
    std::size_t count(const Workshop::Work& work, Call call) {
        const Workshop::Work counting{work.name,
                                      [&] {
                                          const int status = work.run();
                                          std::fprintf(stderr, "\n%zu\n", calls_since());
                                          return status;
                                      },
                                      work.files};
        return std::stoul(last_line(shop_.run(counting, [&] { fail_call(call, 0); }).err));
    }

    /// Lets every `step`-th of all calls fail, the first `each` all.
    void fail_each(const Workshop::Work& work, Call call, std::size_t each, std::size_t step, bool all_after) {
        const std::size_t calls = count(work, call);
        std::size_t tried = 0;
        for (std::size_t nth = 1; nth <= calls && !HasFatalFailure(); nth += nth < each ? 1 : step, ++tried)
            expect_well_ended(work, shop_.run(work, [&] { fail_call(call, nth, all_after); }), nth);
        std::printf("%-9s %6zu calls, %6zu failed one at a time\n", work.name.c_str(), calls, tried);
    }

    Workshop shop_;
};

// Every allocation with ENFILADE_LONG, else the first hundred and one in every 23, a number that shares no rhythm with
// the code's.
TEST_F(Shortage, OfMemoryOnceEndsInASentence) {
    for (const Workshop::Work& work : shop_.works())
        fail_each(work, Call::allocate, trials(100, ~std::size_t{0}), 23, false);
}

TEST_F(Shortage, OfMemoryForGoodEndsInASentence) {
    for (const Workshop::Work& work : shop_.works())
        fail_each(work, Call::allocate, trials(50, ~std::size_t{0}), 101, true);
}

TEST_F(Shortage, OfDiskEndsInASentence) {
    for (const Call call : {Call::open, Call::write, Call::flush, Call::rename})
        for (const Workshop::Work& work : shop_.works())
            for (const bool all_after : {false, true}) fail_each(work, call, trials(8, ~std::size_t{0}), 7, all_after);
}

// As a full disk, but told by a signal to whoever does not ignore it.
TEST_F(Shortage, OfTheSizeOfFilesEndsInASentence) {
    std::size_t failed = 0;
    for (const Workshop::Work& work : shop_.works())
        for (rlim_t most = 128; most <= 16384; most *= 2) {
            const Outcome outcome = shop_.run(work, [&] {
                const rlimit limit{most, most};
                ENFILADE_CHECK(setrlimit(RLIMIT_FSIZE, &limit) == 0);
            });
            failed += outcome.status == 1;
            expect_well_ended(work, outcome, most);
        }
    EXPECT_GT(failed, shop_.works().size());
}

}  // namespace
}  // namespace enfilade::test
