#include "formats/toml_tree.h"

#include <array>
#include <string>

#include "base/text.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

/// Said of a text that is small enough but for the library.
constexpr std::string_view kPlainHasMore =
    "; only a file without escapes, dates, keys with dots and other rare notations may have more";

/// One pass over the text that knows just enough of TOML: strings, comments, brackets, keys and headers. On a text
/// that is not TOML it may count wrongly, but never too little before the place where the library stops.
class Scanner {
public:
    Scanner(std::string_view text, const TomlLimits& limits, bool is_for_library)
        : text_(text), limits_(limits), is_for_library_(is_for_library) {}

    std::optional<Finding> run() {
        if (text_.starts_with(kByteOrderMark)) at_ = line_start_ = kByteOrderMark.size();
        while (at_ < text_.size() && !problem_) step(text_[at_]);
        return std::move(problem_);
    }

private:
    struct Open {
        int depth;  ///< of the container around this one
        bool array;
    };

    void step(char c) {
        if (c == '\n') return end_line();
        if (c == '#') return skip_comment();
        if (c == '"' || c == '\'') return is_behind_bare_letter() ? refuse_quote_in_word() : skip_string(c);
        if (static_cast<unsigned char>(c) >= 0x80) return refuse_bare_non_ascii();
        if (c != ' ' && c != '\t' && c != '\r') structure(c);
        ++at_;
    }

    void structure(char c) {
        const bool starts_line = line_is_empty_;
        line_is_empty_ = false;
        if (c == '[' && starts_line && open_count_ == 0) {
            header_ = true;
            base_ = 0;
            return count_value(kTableWeight);
        }
        if (header_) return header_part(c);
        switch (c) {
            case '[':
            case '{': return open(c == '[');
            case ']':
            case '}': return close();
            case ',': return next_member();
            case '=': in_value_ = true; return count_value(kKeyWeight);
            case '.': return dot();
            default: return;
        }
    }

    void header_part(char c) {
        if (c == '[') count_value();
        if (c != '.') return;
        deepen(++key_dots_);
        if (++dotted_headers_ > kMaxDottedHeaders && is_for_library_) too_many("headers with a dot", kMaxDottedHeaders);
    }

    void dot() {
        if (in_value_) return;
        deepen(++key_dots_);
        count_value(kTableWeight);
        if (++dotted_keys_ > kMaxDottedKeys && is_for_library_)
            too_many("keys with a dot (write tables, as in 'floor = { z = 0 }')", kMaxDottedKeys);
    }

    void open(bool array) {
        deepen(key_dots_ + 1);
        count_value(array ? 1 : kTableWeight);
        if (problem_) return;
        open_[static_cast<std::size_t>(open_count_++)] = {base_, array};
        base_ += key_dots_ + 1;
        key_dots_ = 0;
        in_value_ = array;
    }

    void close() {
        if (open_count_ == 0) return;
        base_ = open_[static_cast<std::size_t>(--open_count_)].depth;
        in_value_ = true;
        key_dots_ = 0;
    }

    void next_member() {
        count_value();
        key_dots_ = 0;
        in_value_ = open_count_ > 0 && open_[static_cast<std::size_t>(open_count_ - 1)].array;
    }

    void end_line() {
        ++at_;
        ++line_;
        line_start_ = at_;
        line_is_empty_ = true;
        if (open_count_ > 0) return;
        if (header_) base_ = key_dots_ + 2;  // an array of tables and its table
        header_ = false;
        in_value_ = false;
        key_dots_ = 0;
    }

    void skip_comment() {
        while (at_ < text_.size() && text_[at_] != '\n' && !problem_) skip_character();
    }

    /// Whether the text before here is the letter of a bare key or value: no string may begin there.
    bool is_behind_bare_letter() const {
        constexpr std::string_view kOtherLetters = "_-+:";
        const char before = at_ == 0 ? '\n' : text_[at_ - 1];
        return (before >= 'a' && before <= 'z') || (before >= 'A' && before <= 'Z') ||
               (before >= '0' && before <= '9') || kOtherLetters.find(before) != std::string_view::npos;
    }

    void skip_string(char quote) {
        line_is_empty_ = false;
        count_value(kStringWeight);
        const std::string_view rest = text_.substr(at_);
        const bool long_string = rest.size() >= 3 && rest[1] == quote && rest[2] == quote;
        at_ += long_string ? 3 : 1;
        while (at_ < text_.size() && !problem_) {
            const char c = text_[at_];
            if (c == '\n' && !long_string) return;
            if (c == quote && (!long_string || text_.substr(at_, 3) == rest.substr(0, 3)))
                return end_string(quote, long_string);
            if (c == '\\' && quote == '"') ++at_;
            if (at_ < text_.size()) skip_character();
        }
    }

    /// A long string may end in up to five quotes, of which the last three close it.
    void end_string(char quote, bool long_string) {
        at_ += long_string ? 3 : 1;
        for (int extra = 0; long_string && extra < 2 && at_ < text_.size() && text_[at_] == quote; ++extra) ++at_;
    }

    void skip_character() {
        const unsigned char c = static_cast<unsigned char>(text_[at_]);
        if (c >= 0x80) {
            const std::size_t length = utf8_length(text_.substr(at_));
            if (length == 0) return refuse_not_utf8();
            at_ += length;
            return;
        }
        ++at_;
        if (c == '\n') {
            ++line_;
            line_start_ = at_;
        }
    }

    void refuse_not_utf8() {
        constexpr std::string_view kDigits = "0123456789ABCDEF";
        const auto byte = static_cast<unsigned char>(text_[at_]);
        refuse("not-utf8", std::string("expected UTF-8, found the byte 0x") + kDigits[byte >> 4] + kDigits[byte & 15] +
                               "; save the file as UTF-8");
    }

    void refuse_quote_in_word() {
        refuse("bad-toml", "expected the end of a key or a value, found a quote; is the quote at its start missing?");
    }

    void refuse_bare_non_ascii() {
        const std::size_t length = utf8_length(text_.substr(at_));
        if (length == 0) return refuse_not_utf8();
        refuse("bad-toml",
               "expected a key or a value, found " + in_quotes(text_.substr(at_, length)) +
                   "; letters beyond ASCII may only stand in quotes and comments: is the quote before it missing?");
    }

    void deepen(int levels) {
        if (base_ + levels > kMaxTomlDepth)
            refuse("too-deep", "tables and arrays are nested deeper than " + std::to_string(kMaxTomlDepth));
    }

    void count_value(std::size_t weight = 1) {
        values_ += weight;
        if (values_ > limits_.values) too_many("values", limits_.values);
    }

    void too_many(std::string_view what, std::size_t limit) {
        refuse("too-large", "the file has more than " + std::to_string(limit) + " " + std::string(what) +
                                (is_for_library_ ? std::string(kPlainHasMore) : ""));
    }

    void refuse(const char* code, std::string sentence) {
        const auto column = characters_in(text_.substr(line_start_, at_ - line_start_)) + 1;
        problem_ = Finding{{line_, static_cast<std::uint32_t>(column)}, Severity::error, code, std::move(sentence)};
    }

    std::string_view text_;
    TomlLimits limits_;
    bool is_for_library_;
    std::size_t at_ = 0, line_start_ = 0;
    std::uint32_t line_ = 1;
    bool line_is_empty_ = true;  ///< nothing but white space so far
    bool header_ = false;        ///< inside [header]
    bool in_value_ = false;      ///< right of a '=', or inside an array: a dot belongs to a number
    int base_ = 0;               ///< depth of the container we are in
    int key_dots_ = 0;           ///< dots of the key we are in
    std::array<Open, kMaxTomlDepth> open_{};
    int open_count_ = 0;
    std::size_t values_ = 0, dotted_keys_ = 0, dotted_headers_ = 0;
    std::optional<Finding> problem_;
};

std::optional<Finding> scan(std::string_view text, const TomlLimits& limits, bool is_for_library) {
    if (text.size() > limits.bytes)
        return Finding{{},
                       Severity::error,
                       "too-large",
                       "the file has " + std::to_string(text.size()) + " bytes; at most " +
                           std::to_string(limits.bytes) + " are read" +
                           (is_for_library ? std::string(kPlainHasMore) : "")};
    return Scanner(text, limits, is_for_library).run();
}

}  // namespace

std::optional<Finding> scan_toml(std::string_view text, const TomlLimits& limits) { return scan(text, limits, false); }

std::optional<Finding> scan_for_library(std::string_view text) { return scan(text, kLibraryLimits, true); }

}  // namespace enfilade
