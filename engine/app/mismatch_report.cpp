#include "app/recorded_flight.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/pictures.h"
#include "base/files.h"
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
        int number = -1;
        const bool is_numbered = std::sscanf(name.c_str(), "%d", &number) == 1 && number >= 0;
        if (is_numbered && fs::path(folder) / name == numbered_picture(folder, std::size_t(number)))
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

Result<void> PictureKeeper::start() const {
    std::error_code unremovable;
    for (const int number : before_)
        if (!std::ranges::binary_search(full_size_, number))
            fs::remove(numbered_picture(folder_, std::size_t(number)), unremovable);
    if (full_size_.empty() && !before_.empty()) fs::remove(folder_, unremovable);  // where nothing else is in it
    if (full_size_.empty()) return {};
    return make_folder(folder_);
}

Result<void> PictureKeeper::take(int number, const Frame& frame) {
    if (!keeping_.no_pictures) contact_sheet_.put(number, frame);
    if (!std::ranges::binary_search(full_size_, number)) return {};
    return write_picture(numbered_picture(folder_, std::size_t(number)), image_of(frame));
}

Result<std::optional<std::uint64_t>> PictureKeeper::finish() const {
    std::error_code unremovable;
    if (keeping_.no_pictures) {
        fs::remove(sheet_, unremovable);
        if (unremovable) return Error{sheet_, "cannot remove it: " + unremovable.message()};
        return std::optional<std::uint64_t>();
    }
    const Image image = image_of(contact_sheet_.image());
    if (const Result<void> done = write_file(sheet_, write_png(image, PngEffort::smallest)); !done.ok())
        return done.error();
    return std::optional(hash_of(contact_sheet_.image()));
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

namespace {

/// Writes one picture into the folder; gives its name there.
Result<std::string> add_picture(const std::string& folder, int frame, const char* what, const Frame& picture) {
    const std::string name = fmt::format("{:06}-{}.png", frame, what);
    if (const Result<void> done = write_picture((std::filesystem::path(folder) / name).string(), image_of(picture));
        !done.ok())
        return done.error();
    return name;
}

Result<void> add_difference(const std::string& folder, const BadFrame& bad, MismatchRow& row) {
    auto expected = add_picture(folder, bad.mismatch.frame, "expected", *bad.expected);
    if (!expected.ok()) return expected.error();
    row.expected_picture = expected.value();
    const Difference difference = difference_of(*bad.expected, reduced(bad.actual, bad.reduction));
    auto picture = add_picture(folder, bad.mismatch.frame, "difference", difference.picture);
    if (!picture.ok()) return picture.error();
    row.difference_picture = picture.value();
    row.reduction = bad.reduction;
    row.pixels = difference.pixels;
    row.of_pixels = difference.picture.pixels.size();
    row.largest = difference.largest;
    return {};
}

Result<MismatchRow> add_row(const std::string& folder, const BadFrame& bad) {
    MismatchRow row;
    row.mismatch = bad.mismatch;
    row.expected_origin = bad.expected_origin;
    auto actual = add_picture(folder, bad.mismatch.frame, "actual", bad.actual);
    if (!actual.ok()) return actual.error();
    row.actual_picture = actual.value();
    if (bad.expected)
        if (const Result<void> done = add_difference(folder, bad, row); !done.ok()) return done.error();
    return row;
}

/// Whether a report names its pictures so: 000012-actual.png.
bool is_picture(std::string_view name) {
    const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
    const std::string_view rest = name.substr(digits);
    return digits >= 6 && (rest == "-actual.png" || rest == "-expected.png" || rest == "-difference.png");
}

}  // namespace

void remove_report(const std::string& folder) {
    bool is_report = false;
    std::error_code unremovable;
    for (const std::string& name : list_folder(folder)) {
        if (!is_picture(name)) continue;
        is_report = true;
        std::filesystem::remove(std::filesystem::path(folder) / name, unremovable);
    }
    if (!is_report) return;
    std::filesystem::remove(std::filesystem::path(folder) / "index.html", unremovable);
    std::filesystem::remove(folder, unremovable);  // where it is empty
}

Result<void> write_report(const std::string& folder, const ReportText& text, const std::vector<BadFrame>& frames) {
    remove_report(folder);
    if (const Result<void> done = make_folder(folder); !done.ok()) return done.error();
    std::vector<MismatchRow> rows;
    for (const BadFrame& bad : frames) {
        auto row = add_row(folder, bad);
        if (!row.ok()) return row.error();
        rows.push_back(std::move(row).value());
    }
    return write_file((std::filesystem::path(folder) / "index.html").string(), mismatch_page(text, rows));
}

}  // namespace enfilade
