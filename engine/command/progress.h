// A line on the terminal that says how far a long job is.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

namespace enfilade {

/// How much a command says beside what it was asked for: usually also warnings, notes and how far it is.
enum class Talk { usual, errors_only };

/// Shows nothing where stderr is not a terminal, and nothing for jobs that are done in an instant.
class Progress {
public:
    /// total: how many steps, of which step() tells; noun: what is counted, e.g. "pictures".
    Progress(std::size_t total, std::string noun, Talk talk = Talk::usual);
    /// Wipes the line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// One step is done. May be called from any thread; only worker 0 draws.
    void step(std::size_t worker) { show(done_.fetch_add(1) + 1, total_, worker); }

    /// The same for a job that counts its own steps.
    void show(std::size_t done, std::size_t total, std::size_t worker);

private:
    void draw(std::size_t done, std::size_t total) const;

    std::atomic<std::size_t> done_{0};
    std::size_t total_;
    std::string noun_;
    std::int64_t started_ns_, last_drawn_ns_;
    bool on_terminal_;
};

}  // namespace enfilade
