#include "app/mismatch_report.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/pictures.h"

namespace enfilade {
namespace {

/// Writes one picture into the folder; gives its name there.
Result<std::string> add_picture(const std::string& folder, int frame, const char* what, const Frame& picture) {
    const std::string name = fmt::format("{:06}-{}.png", frame, what);
    if (Status failed = write_picture((std::filesystem::path(folder) / name).string(), image_of(picture)))
        return *failed;
    return name;
}

Status add_difference(const std::string& folder, const BadFrame& bad, MismatchRow& row) {
    auto expected = add_picture(folder, bad.mismatch.frame, "expected", bad.expected);
    if (!expected.ok()) return expected.error();
    row.expected_picture = expected.value();
    if (bad.expected.width != bad.actual.width || bad.expected.height != bad.actual.height) return {};
    const Difference difference = difference_of(bad.expected, bad.actual);
    auto picture = add_picture(folder, bad.mismatch.frame, "difference", difference.picture);
    if (!picture.ok()) return picture.error();
    row.difference_picture = picture.value();
    row.pixels = difference.pixels;
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
    if (bad.expected.width > 0)
        if (Status failed = add_difference(folder, bad, row)) return *failed;
    return row;
}

}  // namespace

Status write_report(const std::string& folder, const std::string& title, const std::vector<BadFrame>& frames,
                    std::size_t total) {
    if (Status failed = make_folder(folder)) return failed;
    std::vector<MismatchRow> rows;
    for (const BadFrame& bad : frames) {
        auto row = add_row(folder, bad);
        if (!row.ok()) return row.error();
        rows.push_back(std::move(row).value());
    }
    return write_file((std::filesystem::path(folder) / "index.html").string(), mismatch_page(title, rows, total));
}

}  // namespace enfilade
