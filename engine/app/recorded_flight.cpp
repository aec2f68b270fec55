// Recording a flythrough: the pictures that are kept beside the hashes, and recordings whose frames were drawn in
// parts, perhaps on several machines, put together.
#include "app/recorded_flight.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "app/pictures.h"
#include "base/file_name.h"
#include "base/files.h"
#include "base/owned_folder.h"
#include "flight/comparison.h"
#include "formats/png.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

/// "tour.frames".
std::string full_size_folder(const std::string& script_path) {
    return fs::path(script_path).replace_extension(".frames").string();
}

/// Numbers of the pictures in the folder, sorted.
std::vector<int> kept_numbers(const std::string& folder) {
    std::vector<int> numbers;
    for (const std::string& name : list_folder(folder)) {
        int number = 0;
        const bool is_numbered = std::from_chars(name.data(), name.data() + name.size(), number).ec == std::errc();
        if (is_numbered && number >= 0 && fs::path(folder) / name == numbered_picture(folder, std::size_t(number)))
            numbers.push_back(number);
    }
    std::ranges::sort(numbers);
    return numbers;
}

bool is_whole(const DrawPlan& plan, int flight_frames) { return plan.first == 0 && plan.last == flight_frames - 1; }

/// Those in the folder that a recording of the plan replaces: of the whole flight, all there are.
std::vector<int> replaced_numbers(const std::string& folder, const DrawPlan& plan, int flight_frames) {
    std::vector<int> numbers = kept_numbers(folder);
    if (!is_whole(plan, flight_frames))
        std::erase_if(numbers, [&](int number) { return number < plan.first || number > plan.last; });
    return numbers;
}

/// Which frames of the plan to keep in full size, sorted.
std::vector<int> choose_full_size(const std::vector<int>& before, const DrawPlan& plan, const PictureKeeping& keeping) {
    std::vector<int> chosen;
    const int every = keeping.full_size_every;
    for (int number = plan.first; number <= plan.last && !keeping.no_pictures; ++number)
        if (every > 0 ? number % every == 0 : std::ranges::binary_search(before, number)) chosen.push_back(number);
    return chosen;
}

Result<Frame> read_picture(const std::string& path) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) return bytes.error();
    auto image = read_png(bytes.value());
    if (!image.ok()) return Error{path, image.error().what};
    return frame_of(image.value());
}

}  // namespace

std::string sheet_path(const std::string& script_path) {
    return fs::path(script_path).replace_extension(".sheet.png").string();
}

std::string part_path(const std::string& script_path, int first, int last, const std::string& ending) {
    return fs::path(script_path).replace_extension(fmt::format(".part-{:06}-{:06}{}", first, last, ending)).string();
}

Result<ContactSheet> read_sheet(const std::string& path, const std::optional<std::uint64_t>& recorded,
                                ContactSheet empty) {
    if (!recorded) return Error{"", "The recording has no small pictures of its frames."};
    auto image = read_picture(path);
    if (!image.ok()) return Error{"", "The recording's small pictures cannot be read: " + image.error().text() + "."};
    if (hash_of(image.value()) != *recorded || !empty.take(std::move(image).value()))
        return Error{"", "The small pictures in " + path + " are of another recording."};
    return empty;
}

PictureKeeper::PictureKeeper(const std::string& script_path, const DrawPlan& plan, int flight_frames,
                             const PictureKeeping& keeping)
    : sheet_(is_whole(plan, flight_frames) ? sheet_path(script_path)
                                           : part_path(script_path, plan.first, plan.last, ".sheet.png")),
      folder_(full_size_folder(script_path)),
      keeping_(keeping),
      before_(replaced_numbers(folder_, plan, flight_frames)),
      full_size_(choose_full_size(before_, plan, keeping)),
      contact_sheet_(flight_frames, plan.width, plan.height) {}

Result<void> PictureKeeper::start() const { return full_size_.empty() ? Result<void>() : make_folder(folder_); }

Result<void> PictureKeeper::take(int number, const Frame& frame) {
    if (!keeping_.no_pictures) contact_sheet_.put(number, frame);
    if (!std::ranges::binary_search(full_size_, number)) return {};
    return write_picture(numbered_picture(folder_, std::size_t(number)), image_of(frame));
}

Result<std::optional<std::uint64_t>> PictureKeeper::finish() const {
    if (keeping_.no_pictures) return std::optional<std::uint64_t>();
    const Image image = image_of(contact_sheet_.image());
    if (const Result<void> done = write_file(sheet_, write_png(image, PngEffort::smallest)); !done.ok())
        return done.error();
    return std::optional(hash_of(contact_sheet_.image()));
}

Result<void> PictureKeeper::remove_surplus(const std::string& hashes) const {
    std::vector<std::string> surplus;
    for (const int number : before_)
        if (!std::ranges::binary_search(full_size_, number))
            surplus.push_back(numbered_picture(folder_, std::size_t(number)));
    if (full_size_.empty() && !before_.empty()) surplus.push_back(folder_);
    if (keeping_.no_pictures) surplus.push_back(sheet_);
    return remove_superseded(surplus, hashes);
}

KeptPictures::KeptPictures(const std::string& script_path, const FrameRecording& recording, const DrawPlan& plan)
    : folder_(full_size_folder(script_path)),
      reduction_(reduction_of(plan.width, plan.height)),
      sheet_(static_cast<int>(recording.frames.size()), plan.width, plan.height) {
    auto sheet = read_sheet(sheet_path(script_path), recording.sheet, sheet_);
    if (sheet.ok())
        sheet_ = std::move(sheet).value();
    else
        missing_ = sheet.error().what;
}

std::optional<KeptPicture> KeptPictures::of(const FrameHash& recorded) const {
    auto full_size = read_picture(numbered_picture(folder_, recorded.frame));
    if (full_size.ok() && hash_of(full_size.value()) == recorded.hash)
        return KeptPicture{std::move(full_size).value(), 1};
    auto small = missing_.empty() ? sheet_.picture_of(static_cast<int>(recorded.frame)) : std::nullopt;
    if (!small) return {};
    return KeptPicture{std::move(*small), reduction_};
}

// The recording.

Result<void> record_flight(const FlightScene& scene, const DrawPlan& plan, const std::string& script_path,
                           const PictureKeeping& keeping, Talk talk) {
    PictureKeeper keeper(script_path, plan, scene.flight.frames(), keeping);
    if (const Result<void> done = keeper.start(); !done.ok()) return done.error();
    Progress progress(frames_of(plan), "frames", talk);
    const auto hashes = hash_frames(scene, plan, [&](int number, const Frame& frame, std::size_t worker) {
        progress.step(worker);
        return keeper.take(number, frame);
    });
    if (!hashes.ok()) return hashes.error();
    const auto sheet = keeper.finish();
    if (!sheet.ok()) return sheet.error();
    FrameRecording recording{
        RecordedPictures{std::uint32_t(plan.width), std::uint32_t(plan.height), name_of(plan.renderer)},
        sheet.value(),
        {}};
    for (const std::uint64_t hash : hashes.value())
        recording.frames.push_back(
            {static_cast<std::uint32_t>(plan.first) + std::uint32_t(recording.frames.size()), hash});
    const bool is_whole = frames_of(plan) == std::size_t(scene.flight.frames());
    const std::string path =
        is_whole ? hashes_path(script_path) : part_path(script_path, plan.first, plan.last, ".hashes");
    if (const Result<void> done = write_file(path, write_frame_hashes(recording)); !done.ok()) return done.error();
    return keeper.remove_surplus(path);
}

// Its parts.

namespace {

struct RecordedPart {
    std::string hashes, sheet;  ///< paths
    FrameRecording recording;   ///< of at least one frame
};

Result<RecordedPart> read_part(const fs::path& path) {
    const auto bytes = read_file(path.string());
    if (!bytes.ok()) return bytes.error();
    auto recording = read_frame_hashes(as_text(bytes.value()));
    if (!recording.ok()) return Error{path.string() + ":" + recording.error().where, recording.error().what};
    if (recording.value().frames.empty() || !recording.value().pictures)
        return Error{path.string(), "expected the frames of a part, found none; record it again"};
    return RecordedPart{path.string(), fs::path(path).replace_extension(".sheet.png").string(),
                        std::move(recording).value()};
}

/// All parts that lie beside the script, in the order of their frames.
Result<std::vector<RecordedPart>> read_parts(const fs::path& script_path) {
    const fs::path folder = script_path.parent_path();
    const std::string beginning = file_stem_of(script_path) + ".part-";
    std::vector<RecordedPart> parts;
    for (const std::string& name : list_folder(folder.empty() ? "." : folder.string())) {
        if (!name.starts_with(beginning) || !name.ends_with(".hashes")) continue;
        auto part = read_part(folder / name);
        if (!part.ok()) return part.error();
        parts.push_back(std::move(part).value());
    }
    std::ranges::sort(parts, {}, [](const RecordedPart& part) { return part.recording.frames.front().frame; });
    return parts;
}

/// The frames of all parts; an error where one is missing or there twice.
Result<std::vector<FrameHash>> frames_in(const std::vector<RecordedPart>& parts, int frames,
                                         const std::string& script_path) {
    std::vector<FrameHash> all;
    const auto missing = [&](std::uint32_t last) {
        return Error{script_path, fmt::format("the parts lack the frames {0}..{1}; draw them with --record --frames "
                                              "{0}..{1}",
                                              all.size(), last)};
    };
    for (const RecordedPart& part : parts)
        for (const FrameHash& frame : part.recording.frames) {
            if (frame.frame > all.size()) return missing(frame.frame - 1);
            if (frame.frame < all.size())
                return Error{part.hashes,
                             fmt::format("another part has frame {}, too; remove the one that is older", frame.frame)};
            all.push_back(frame);
        }
    if (all.size() < std::size_t(frames)) return missing(static_cast<std::uint32_t>(frames - 1));
    if (all.size() == std::size_t(frames)) return all;
    return Error{script_path,
                 fmt::format("the flight has {} frames, but its parts have {}; remove those that are older", frames,
                             all.size())};
}

/// An error where the parts are not of one recording.
Result<void> check_alike(const std::vector<RecordedPart>& parts) {
    for (const RecordedPart& part : parts) {
        if (part.recording.pictures != parts.front().recording.pictures)
            return Error{part.hashes, "its pictures have another size or are by another renderer than those of " +
                                          parts.front().hashes + "; draw it with the same options"};
        if (part.recording.sheet.has_value() != parts.front().recording.sheet.has_value())
            return Error{part.hashes, "of it and " + parts.front().hashes +
                                          " only one has small pictures; record both with or without --no-pictures"};
    }
    return {};
}

/// The sheet of the whole flight.
Result<ContactSheet> sheet_of(const std::vector<RecordedPart>& parts, const ContactSheet& empty) {
    ContactSheet sheet = empty;
    for (const RecordedPart& part : parts) {
        const auto drawn = read_sheet(part.sheet, part.recording.sheet, empty);
        if (!drawn.ok()) return Error{part.hashes, drawn.error().what + " Record it again."};
        for (const FrameHash& frame : part.recording.frames)
            if (const auto small = drawn.value().picture_of(int(frame.frame)))
                sheet.put_small(int(frame.frame), *small);
    }
    return sheet;
}

/// Writes the sheet where the parts have one.
Result<void> write_sheet(const std::vector<RecordedPart>& parts, const std::string& path, FrameRecording& whole) {
    if (!parts.front().recording.sheet) return {};
    const auto sheet = sheet_of(
        parts, ContactSheet(int(whole.frames.size()), int(whole.pictures->width), int(whole.pictures->height)));
    if (!sheet.ok()) return sheet.error();
    whole.sheet = hash_of(sheet.value().image());
    return write_file(path, write_png(image_of(sheet.value().image()), PngEffort::smallest));
}

}  // namespace

Result<void> merge_parts(const std::string& script_path, int frames) {
    const auto parts = read_parts(script_path);
    if (!parts.ok()) return parts.error();
    auto all = frames_in(parts.value(), frames, script_path);
    if (!all.ok()) return all.error();
    if (const Result<void> valid = check_alike(parts.value()); !valid.ok()) return valid.error();
    FrameRecording whole{parts.value().front().recording.pictures, {}, std::move(all).value()};
    if (const Result<void> done = write_sheet(parts.value(), sheet_path(script_path), whole); !done.ok())
        return done.error();
    if (const Result<void> done = write_file(hashes_path(script_path), write_frame_hashes(whole)); !done.ok())
        return done.error();
    std::vector<std::string> surplus;
    for (const RecordedPart& part : parts.value()) surplus.insert(surplus.end(), {part.hashes, part.sheet});
    if (!whole.sheet) surplus.push_back(sheet_path(script_path));
    return remove_superseded(surplus, hashes_path(script_path));
}

}  // namespace enfilade
