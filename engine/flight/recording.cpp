#include "flight/recording.h"

#include <filesystem>

#include "formats/text_parts.h"

namespace enfilade {
namespace {

std::string size_text(std::uint32_t width, std::uint32_t height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

/// Where the recording is of pictures that these can never be equal to.
Result<void> other_pictures(const FrameRecording& recording, const DrawPlan& plan, const std::string& script_path) {
    if (!recording.pictures) return {};
    const RecordedPictures& pictures = *recording.pictures;
    const std::string recorded = size_text(pictures.width, pictures.height),
                      drawn = size_text(std::uint32_t(plan.width), std::uint32_t(plan.height));
    if (recorded != drawn)
        return Error{script_path, "the recording has pictures of " + recorded + " pixels, and these have " + drawn +
                                      "; check with --size " + recorded + ", or record it again with --record"};
    if (pictures.renderer == name_of(plan.renderer)) return {};
    return Error{script_path, "the recording was drawn by the " + pictures.renderer +
                                  " renderer, and these pictures are by " + name_of(plan.renderer) +
                                  "; check with --renderer " + pictures.renderer +
                                  ", or compare the two with --check --against " + pictures.renderer};
}

/// Where the recording does not cover exactly the frames of the flight.
Result<void> other_frames(const std::vector<FrameHash>& recorded, int frames, const std::string& script_path) {
    bool same = recorded.size() == std::size_t(frames);
    for (std::size_t i = 0; same && i < recorded.size(); ++i) same = recorded[i].frame == i;
    if (same) return {};
    return Error{script_path, "the flight has " + counted(std::size_t(frames), "frame") + ", but " +
                                  std::to_string(recorded.size()) +
                                  " others were recorded; record it again with --record if that is meant"};
}

}  // namespace

std::string hashes_path(const std::string& script_path) {
    return std::filesystem::path(script_path).replace_extension(".hashes").string();
}

Result<FrameRecording> read_recording(const std::string& script_path, const FileReader& read) {
    const std::string path = hashes_path(script_path);
    const auto bytes = read(path);
    if (!bytes.ok()) return Error{path, bytes.error().what + "; `enfilade fly --record` makes it"};
    auto recording = read_frame_hashes(as_text(bytes.value()));
    if (!recording.ok()) return Error{path + ":" + recording.error().where, recording.error().what};
    return recording;
}

Result<void> refuse_recording(const FrameRecording& recording, const DrawPlan& plan, int flight_frames,
                              const std::string& script_path) {
    if (const Result<void> valid = other_pictures(recording, plan, script_path); !valid.ok()) return valid.error();
    return other_frames(recording.frames, flight_frames, script_path);
}

Result<std::vector<std::uint64_t>> hash_frames(const FlightScene& scene, const DrawPlan& plan, const FrameTaker& also) {
    std::vector<std::uint64_t> hashes(frames_of(plan));
    const Result<void> drawn =
        draw_frames(scene, plan, [&](int number, const Frame& frame, std::size_t worker) -> Result<void> {
            hashes[std::size_t(number - plan.first)] = hash_of(frame);
            return also ? also(number, frame, worker) : Result<void>{};
        });
    if (!drawn.ok()) return drawn.error();
    return hashes;
}

}  // namespace enfilade
