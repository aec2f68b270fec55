#include "app/mismatch_report.h"

#include <fmt/format.h>

#include <filesystem>
#include <regex>

#include "app/pictures.h"
#include "base/files.h"
#include "flight/contact_sheet.h"

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
        if (Status failed = add_difference(folder, bad, row)) return *failed;
    return row;
}

}  // namespace

void remove_report(const std::string& folder) {
    const std::regex picture("[0-9]{6,}-(actual|expected|difference)\\.png");
    bool is_report = false;
    std::error_code unremovable;
    for (const std::string& name : list_folder(folder)) {
        if (!std::regex_match(name, picture)) continue;
        is_report = true;
        std::filesystem::remove(std::filesystem::path(folder) / name, unremovable);
    }
    if (!is_report) return;
    std::filesystem::remove(std::filesystem::path(folder) / "index.html", unremovable);
    std::filesystem::remove(folder, unremovable);  // where it is empty
}

Status write_report(const std::string& folder, const ReportText& text, const std::vector<BadFrame>& frames) {
    remove_report(folder);
    if (Status failed = make_folder(folder)) return failed;
    std::vector<MismatchRow> rows;
    for (const BadFrame& bad : frames) {
        auto row = add_row(folder, bad);
        if (!row.ok()) return row.error();
        rows.push_back(std::move(row).value());
    }
    return write_file((std::filesystem::path(folder) / "index.html").string(), mismatch_page(text, rows));
}

}  // namespace enfilade
