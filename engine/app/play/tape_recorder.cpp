#include "app/play/tape_recorder.h"

namespace enfilade {

Result<TapeRecorder> TapeRecorder::begin(const std::string& path, const Tape& tape) {
    auto file = OutputFile::open(path);
    if (!file.ok()) return file.error();
    const Bytes beginning = tape_beginning(tape);
    if (Status failed = file.value().write(beginning)) return *failed;
    if (Status failed = file.value().put_in_place()) return *failed;
    return TapeRecorder(std::move(file).value(), beginning.size());
}

Status TapeRecorder::add(const InputRecord& tick) { return file_.write(tape_tick(tick)); }

Status TapeRecorder::cut_to(std::size_t ticks) { return file_.cut_to(beginning_bytes_ + ticks * kTapeTickBytes); }

Status TapeRecorder::finish(std::uint64_t final_hash) {
    if (Status failed = file_.write(tape_end(final_hash))) return failed;
    return file_.commit();
}

}  // namespace enfilade
