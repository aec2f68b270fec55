// What is done while things go wrong: a check, a load, a frame, a save, a recording, a film, a conversion.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "support/temp_dir.h"

namespace enfilade::test {

/// How a process ended that did some work, and what it said.
struct Outcome {
    int status = -1;  ///< exit status; 128 + signal where it was killed
    std::string out, err;
};

/// A folder with a map, a script, a saved game and a WAD, and the work that can be done in it. Whatever the work writes
/// is one of the two versions that the folder knows of each file: as it was before, and as it is when all goes well.
class Workshop {
public:
    Workshop();

    /// A piece of work, whose return value is an exit status, and the files that it writes.
    struct Work {
        std::string name;
        std::function<int()> run;
        std::vector<std::string> files;
    };
    const std::vector<Work>& works() const { return works_; }

    std::string path(const std::string& name = "") const { return dir_.path(name); }

    /// Does the work in a process of its own, after `prepare` there; the files are the old ones when it begins.
    Outcome run(const Work& work, const std::function<void()>& prepare) const;

    /// The same, killed (SIGKILL) when `wait` has returned; the status is that of a killed process, or of one that was
    /// faster.
    Outcome run_and_kill(const Work& work, const std::function<void()>& wait) const;

    /// The names of those of the work's files that are neither as they were nor as they should become; with
    /// `must_be_new`, that are not as they should become.
    std::vector<std::string> broken_files(const Work& work, bool must_be_new) const;

    /// Temporary files that were left behind.
    std::vector<std::string> left_behind() const;
    void clean_up() const;

private:
    void add_command(std::string name, std::vector<std::string> arguments, std::vector<std::string> files);
    void add_save();
    void add_conversion();
    void learn_files();
    void put_old_files(const Work& work) const;
    int start(const Work& work, const std::function<void()>& prepare) const;
    Outcome outcome_of(int process) const;

    /// A file that is missing has no text.
    struct Versions {
        std::string file;
        std::string before, after;
    };
    const Versions& versions_of(const std::string& file) const;

    test::TempDir dir_;
    std::vector<Work> works_;
    std::vector<Versions> versions_;
};

/// How often something is tried: `usual` times, and with ENFILADE_LONG set `thorough` times.
std::size_t trials(std::size_t usual, std::size_t thorough);

}  // namespace enfilade::test
