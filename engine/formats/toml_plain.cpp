// The quick parser for plain TOML. It gives up at whatever it does not know for sure.
#include <algorithm>
#include <charconv>

#include "formats/toml_tree.h"

namespace enfilade {
namespace {

/// A table with more members is left to the library, which finds a key that is given twice without comparing all with
/// all.
constexpr std::size_t kMostMembers = 64;

/// Digits that fit a whole number for sure.
constexpr std::size_t kMostDigits = 18;

/// The library refuses numbers from some length on; any double can be written with 24 characters.
constexpr std::size_t kLongestNumber = 32;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_key_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_' || c == '-';
}
bool is_control(char c) { return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7F; }

/// Every function that returns bool says whether it could go on.
class PlainParser {
public:
    explicit PlainParser(std::string_view text) {
        tree_.text = std::make_unique<std::string>(text);
        text_ = *tree_.text;
    }

    std::optional<TomlTree> run() {
        tree_.root = tree_.new_table({1, 1});
        table_ = tree_.root.members;
        while (skip_lines() && at_ < text_.size())
            if (!(peek() == '[' ? header() : key_and_value(*table_)) || !end_of_line()) return {};
        if (at_ < text_.size()) return {};
        return std::move(tree_);
    }

private:
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    bool take(char c) {
        if (peek() != c || at_ == text_.size()) return false;
        ++at_;
        return true;
    }
    void skip_blanks() {
        while (peek() == ' ' || peek() == '\t') ++at_;
    }
    TextPlace place() const { return {line_, static_cast<std::uint32_t>(at_ - line_start_ - behind_ + 1)}; }

    /// Blanks, comments and ends of lines; false at what may not stand in a comment.
    bool skip_lines() {
        for (;; next_line()) {
            skip_blanks();
            if (peek() == '#' && !skip_comment()) return false;
            if (peek() == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++at_;
            if (peek() != '\n') return true;
        }
    }

    bool skip_comment() {
        while (at_ < text_.size() && peek() != '\n' && peek() != '\r') {
            if (is_control(peek())) return false;
            ++at_;
        }
        return true;
    }

    void next_line() {
        ++at_;
        ++line_;
        line_start_ = at_;
        behind_ = 0;
    }

    /// Behind a header or a value, nothing else stands in its line.
    bool end_of_line() {
        skip_blanks();
        if (peek() == '#' && !skip_comment()) return false;
        return at_ == text_.size() || peek() == '\n' || peek() == '\r';
    }

    bool key(TomlMember& member) {
        const std::size_t begin = at_;
        member.key_place = place();
        while (is_key_letter(peek())) ++at_;
        member.key = text_.substr(begin, at_ - begin);
        return !member.key.empty();
    }

    static TomlMember* find(std::vector<TomlMember>& table, std::string_view key) {
        const auto found = std::ranges::find(table, key, &TomlMember::key);
        return found == table.end() ? nullptr : &*found;
    }

    bool key_and_value(std::vector<TomlMember>& table) {
        TomlMember member;
        if (!key(member)) return false;
        skip_blanks();
        if (!take('=') || table.size() == kMostMembers || find(table, member.key)) return false;
        skip_blanks();
        if (!value(member.value)) return false;
        table.push_back(member);
        return true;
    }

    bool header() {
        const TextPlace begin = place();
        ++at_;
        const bool is_array = take('[');
        std::vector<TomlMember>* table = tree_.root.members;
        TomlMember member;
        for (bool is_last = false; !is_last;) {
            skip_blanks();
            if (!key(member)) return false;
            skip_blanks();
            is_last = !take('.');
            if (!is_last && !(table = table_below(*table, member.key))) return false;
        }
        if (!take(']') || (is_array && !take(']'))) return false;
        return is_array ? begin_in_array(*table, member, begin) : begin_table(*table, member, begin);
    }

    /// The table that a header's key leads into, for an array of tables the last; null where there is none yet.
    static std::vector<TomlMember>* table_below(std::vector<TomlMember>& table, std::string_view key) {
        const TomlMember* const member = find(table, key);
        if (!member || !member->value.has_header) return nullptr;
        return member->value.kind == TomlKind::table ? member->value.members : member->value.items->back().members;
    }

    bool begin_table(std::vector<TomlMember>& parent, TomlMember member, TextPlace begin) {
        if (parent.size() == kMostMembers || find(parent, member.key)) return false;
        member.value = tree_.new_table(begin);
        member.value.has_header = true;
        parent.push_back(member);
        table_ = member.value.members;
        return true;
    }

    bool begin_in_array(std::vector<TomlMember>& parent, TomlMember member, TextPlace begin) {
        TomlMember* array = find(parent, member.key);
        if (array && (array->value.kind != TomlKind::array || !array->value.has_header)) return false;
        if (!array) {
            if (parent.size() == kMostMembers) return false;
            member.value = tree_.new_array(begin);
            member.value.has_header = true;
            parent.push_back(member);
            array = &parent.back();
        }
        array->value.items->push_back(tree_.new_table(begin));
        table_ = array->value.items->back().members;
        return true;
    }

    bool value(TomlValue& value) {
        value.place = place();
        switch (peek()) {
            case '"':
            case '\'': return string(value);
            case '[': return array(value);
            case '{': return braces(value);
            case 't': return word(value, "true", true);
            case 'f': return word(value, "false", false);
            default: return number(value);
        }
    }

    bool is_end_of_value() const {
        const char c = peek();
        return c == ' ' || c == ',' || c == '\n' || c == ']' || c == '}' || c == '\t' || c == '\r' || c == '#' ||
               at_ == text_.size();
    }

    bool word(TomlValue& value, std::string_view word, bool boolean) {
        if (text_.substr(at_, word.size()) != word) return false;
        at_ += word.size();
        value.kind = TomlKind::boolean;
        value.boolean = boolean;
        return is_end_of_value();
    }

    bool string(TomlValue& value) {
        const char quote = text_[at_++];
        const std::size_t begin = at_;
        while (at_ < text_.size() && text_[at_] != quote) {
            const char c = text_[at_++];
            if (is_control(c) || (c == '\\' && quote == '"')) return false;
            behind_ += (static_cast<unsigned char>(c) & 0xC0) == 0x80;  // places count characters
        }
        value.kind = TomlKind::string;
        value.text = text_.data() + begin;
        value.length = static_cast<std::uint32_t>(at_ - begin);
        return take(quote) && is_end_of_value();  // a third quote begins a long string
    }

    /// "-12", "0.5", "1e-09"; no leading zeros, signs other than '-', underscores, or other notations.
    bool number(TomlValue& value) {
        const std::size_t begin = at_;
        take('-');
        const std::size_t first = at_;
        skip_digits();
        const std::size_t digits = at_ - first;
        if (digits == 0 || digits > kMostDigits || (digits > 1 && text_[first] == '0')) return false;
        const bool has_fraction = take('.');
        if (has_fraction && !skip_digits()) return false;
        const bool has_exponent = take('e') || take('E');
        if (has_exponent && !take('-')) take('+');
        if (has_exponent && !skip_digits()) return false;
        if (!is_end_of_value() || at_ - begin > kLongestNumber) return false;
        const char *const from = text_.data() + begin, *const to = text_.data() + at_;
        value.kind = has_fraction || has_exponent ? TomlKind::real : TomlKind::integer;
        const auto read = value.kind == TomlKind::real ? std::from_chars(from, to, value.real)
                                                       : std::from_chars(from, to, value.integer);
        return read.ec == std::errc() && read.ptr == to;
    }

    /// False where there is none.
    bool skip_digits() {
        const std::size_t begin = at_;
        while (is_digit(peek())) ++at_;
        return at_ > begin;
    }

    bool array(TomlValue& value) {
        value = tree_.new_array(value.place);
        ++at_;
        while (skip_lines() && peek() != ']') {
            TomlValue item;
            if (!this->value(item)) return false;
            value.items->push_back(item);
            if (!skip_lines()) return false;
            if (!take(',') && peek() != ']') return false;
        }
        return take(']');
    }

    bool braces(TomlValue& value) {
        value = tree_.new_table(value.place);
        ++at_;
        skip_blanks();
        if (take('}')) return true;
        do {
            skip_blanks();
            if (!key_and_value(*value.members)) return false;
            skip_blanks();
        } while (take(','));
        return take('}');
    }

    TomlTree tree_;
    std::string_view text_;
    std::vector<TomlMember>* table_ = nullptr;  ///< of the last header
    std::size_t at_ = 0, line_start_ = 0;
    std::size_t behind_ = 0;  ///< bytes of this line that are not the first of their character
    std::uint32_t line_ = 1;
};

}  // namespace

std::optional<TomlTree> parse_plain_toml(std::string_view text) { return PlainParser(text).run(); }

}  // namespace enfilade
