#include "formats/views_csv.h"

#include <array>

#include "base/text.h"
#include "formats/map_keys.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

constexpr std::string_view kNumbersHeader = "x,y,z,yaw,pitch";
constexpr std::string_view kSectorHeader = "x,y,z,yaw,pitch,sector";

/// A column of numbers.
struct CsvColumn {
    std::string_view name;
    double ViewRow::* field;
    Range range;
};
constexpr std::array kColumns{
    CsvColumn{"x", &ViewRow::x, kPositions},
    CsvColumn{"y", &ViewRow::y, kPositions},
    CsvColumn{"z", &ViewRow::z, kHeights},
    CsvColumn{"yaw", &ViewRow::yaw_degrees, kAngles},
    CsvColumn{"pitch", &ViewRow::pitch_degrees, kPitches},
};

/// A field of a row and where it starts in the line [bytes].
struct CsvField {
    std::string text;
    std::size_t at = 0;
    bool closed = true;  ///< false: its quotes are not closed, or something follows them
};

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// Reads the quoted field that starts at `at`, which moves behind it and the blanks after it.
CsvField take_quoted(std::string_view line, std::size_t& at) {
    CsvField field{"", at, false};
    for (++at; at < line.size(); ++at) {
        if (line[at] != '"') {
            field.text += line[at];
        } else if (line.substr(at, 2) == "\"\"") {
            field.text += '"';
            ++at;
        } else {
            field.closed = true;
            break;
        }
    }
    if (field.closed) ++at;
    while (at < line.size() && is_blank(line[at])) ++at;
    field.closed = field.closed && (at == line.size() || line[at] == ',');
    return field;
}

/// Reads the field that starts at `at`, which moves to the comma behind it or to the line's end.
CsvField take_field(std::string_view line, std::size_t& at) {
    while (at < line.size() && is_blank(line[at])) ++at;
    if (at < line.size() && line[at] == '"') return take_quoted(line, at);
    const std::size_t start = at;
    at = std::min(line.find(',', at), line.size());
    return {std::string(trimmed(line.substr(start, at - start))), start, true};
}

std::vector<CsvField> fields_of(std::string_view line) {
    std::vector<CsvField> fields;
    for (std::size_t at = 0;; ++at) {
        fields.push_back(take_field(line, at));
        if (at >= line.size() || !fields.back().closed || fields.size() > kColumns.size() + 1) return fields;
    }
}

/// Reads the rows of one text and notes what is wrong with them.
class RowReader {
public:
    explicit RowReader(Findings& findings) : reading_{findings} {}

    /// Whether the header is one of the two, so that rows can be understood.
    bool read_header(const TextLine& line) {
        std::string header;
        for (const CsvField& field : fields_of(line.text)) header += (header.empty() ? "" : ",") + field.text;
        column_count_ = header == kSectorHeader ? kColumns.size() + 1 : kColumns.size();
        if (header == kNumbersHeader || header == kSectorHeader) return true;
        reading_.error({line.number, 1}, "bad-header",
                       "expected the header '" + std::string(kSectorHeader) + "' (sector is optional), found " +
                           in_quotes(line.text));
        return false;
    }

    std::optional<ViewRow> read_row(const TextLine& line) {
        const std::vector<CsvField> fields = fields_of(line.text);
        if (!has_right_shape(line, fields)) return {};
        const std::size_t findings_before = reading_.findings.size();
        ViewRow row;
        row.line = line.number;
        for (std::size_t i = 0; i < kColumns.size(); ++i) read_number(line, fields[i], kColumns[i], row);
        if (column_count_ > kColumns.size()) row.sector = fields.back().text;
        if (reading_.findings.size() != findings_before) return {};
        return row;
    }

private:
    TextPlace place(const TextLine& line, std::size_t at) const {
        return {line.number, static_cast<std::uint32_t>(characters_in(line.text.substr(0, at)) + 1)};
    }

    bool has_right_shape(const TextLine& line, const std::vector<CsvField>& fields) {
        if (!fields.back().closed) {
            reading_.error(place(line, fields.back().at), "bad-row", "a quoted field must end in a quote and a comma");
            return false;
        }
        if (fields.size() == column_count_) return true;
        reading_.error(place(line, 0), "bad-row",
                       "expected " + std::to_string(column_count_) + " fields, found " +
                           (fields.size() > kColumns.size() + 1 ? "more" : std::to_string(fields.size())));
        return false;
    }

    void read_number(const TextLine& line, const CsvField& field, const CsvColumn& column, ViewRow& row) {
        const auto number = parse_number(field.text);
        if (!number)
            return reading_.error(place(line, field.at), "bad-number",
                                  in_quotes(column.name) + " must be a number, found " + in_quotes(field.text));
        if (*number < column.range.low || *number > column.range.high)
            return reading_.error(
                place(line, field.at), "out-of-range",
                in_quotes(column.name) + " must be " + range_text(column.range) + ", found " + number_text(*number));
        row.*column.field = *number;
    }

    Reading reading_;
    std::size_t column_count_ = kColumns.size();
};

/// The first line with bytes that are not UTF-8 is the only thing said about a text that is none.
bool refuse_not_utf8(std::string_view text, Findings& findings) {
    for (LineReader lines(text); const auto line = lines.next();)
        for (std::size_t at = 0; at < line->text.size();) {
            const std::size_t length = utf8_length(line->text.substr(at));
            if (length == 0) {
                const auto column = static_cast<std::uint32_t>(characters_in(line->text.substr(0, at)) + 1);
                findings.push_back(
                    {{line->number, column}, Severity::error, "not-utf8", "expected UTF-8; save the file as UTF-8"});
                return true;
            }
            at += length;
        }
    return false;
}

bool refuse_too_large(std::string_view text, Findings& findings) {
    if (text.size() <= kMaxViewsBytes) return false;
    findings.push_back({{},
                        Severity::error,
                        "too-large",
                        "the file has " + std::to_string(text.size()) + " bytes; at most " +
                            std::to_string(kMaxViewsBytes) + " are read"});
    return true;
}

}  // namespace

ViewsReading read_views(std::string_view text) {
    ViewsReading result;
    if (refuse_too_large(text, result.findings) || refuse_not_utf8(text, result.findings)) return result;
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    RowReader rows(result.findings);
    LineReader lines(text);
    if (!rows.read_header(lines.next().value_or(TextLine{"", 1}))) return result;
    while (const auto line = lines.next()) {
        if (trimmed(line->text).empty()) continue;
        if (auto row = rows.read_row(*line)) result.views.push_back(std::move(*row));
    }
    return result;
}

Result<ViewRow> parse_view(std::string_view text) {
    Findings findings;
    auto row = RowReader(findings).read_row({text, 0});
    if (row) return *std::move(row);
    return Error{"", "expected a view as X,Y,Z,YAW,PITCH: " + findings.front().sentence};
}

}  // namespace enfilade
