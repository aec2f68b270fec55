// A recording whose frames were drawn in parts, perhaps on several machines, put together.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/recorded_flight.h"
#include "base/files.h"
#include "formats/png.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

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
    const std::string beginning = script_path.stem().string() + ".part-";
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

/// Writes the sheet, or removes one that is there where the parts have none.
Result<void> write_sheet(const std::vector<RecordedPart>& parts, const std::string& path, FrameRecording& whole) {
    std::error_code unremovable;
    if (!parts.front().recording.sheet) {
        fs::remove(path, unremovable);
        return {};
    }
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
    std::error_code unremovable;
    for (const RecordedPart& part : parts.value()) {
        fs::remove(part.hashes, unremovable);
        fs::remove(part.sheet, unremovable);
    }
    return {};
}

}  // namespace enfilade
