// A text, line by line.
#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

namespace enfilade {

struct TextLine {
    std::string_view text;     ///< without its end
    std::uint32_t number = 0;  ///< from 1
};

/// Hands out one line after the other. Lines end with LF or CR LF; an end at the very end of the text starts no line.
class LineReader {
public:
    explicit LineReader(std::string_view text) : rest_(text) {}

    /// The next line, or none.
    std::optional<TextLine> next() {
        if (rest_.empty()) return {};
        const std::size_t end = rest_.find('\n');
        std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        return TextLine{line, ++number_};
    }

private:
    std::string_view rest_;
    std::uint32_t number_ = 0;
};

}  // namespace enfilade
