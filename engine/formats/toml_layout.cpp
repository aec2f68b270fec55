#include <algorithm>
#include <vector>

#include "base/text.h"
#include "formats/map_toml.h"
#include "formats/toml.h"

namespace enfilade {
namespace {

constexpr std::size_t kIndent = 2;    ///< [blanks]
constexpr std::size_t kWidest = 100;  ///< of a line whose comment is set below those of its neighbours [characters]

enum class TokenKind { line_end, comment, mark, word };

/// A piece of the text. Words are keys, numbers, and strings with their quotes.
struct Token {
    TokenKind kind;
    std::string_view text;

    bool is(std::string_view mark) const { return kind == TokenKind::mark && text == mark; }
};

/// Cuts a text that is known to be TOML into tokens.
class Tokens {
public:
    explicit Tokens(std::string_view text) : text_(text) {
        if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
        while (at_ < text_.size()) next();
    }

    std::vector<Token> take() { return std::move(tokens_); }

private:
    void add(TokenKind kind, std::size_t length) {
        tokens_.push_back({kind, text_.substr(at_, length)});
        at_ += length;
    }

    void next() {
        const char c = text_[at_];
        if (c == ' ' || c == '\t' || c == '\r')
            ++at_;
        else if (c == '\n')
            add(TokenKind::line_end, 1);
        else if (c == '#')
            add(TokenKind::comment, std::min(text_.find_first_of("\r\n", at_), text_.size()) - at_);
        else if (std::string_view("[]{},=").find(c) != std::string_view::npos)
            add(TokenKind::mark, 1);
        else
            add(TokenKind::word, c == '"' || c == '\'' ? string_length() : word_length());
    }

    std::size_t string_length() const {
        const char quote = text_[at_];
        const std::string three(3, quote);
        const bool is_long = text_.substr(at_, 3) == three;
        for (std::size_t i = at_ + (is_long ? 3 : 1); i < text_.size(); ++i) {
            if (quote == '"' && text_[i] == '\\')
                ++i;
            else if (is_long && text_.substr(i, 3) == three) {
                std::size_t end = i + 3;
                while (end < text_.size() && text_[end] == quote) ++end;  // quotes right before the end belong to it
                return end - at_;
            } else if (!is_long && text_[i] == quote)
                return i + 1 - at_;
        }
        return text_.size() - at_;
    }

    /// A day may have its time behind one blank.
    std::size_t word_length() const {
        std::size_t end = std::min(text_.find_first_of(" \t\r\n#[]{},=\"'", at_), text_.size());
        const auto is_digit = [&](std::size_t i) { return i < text_.size() && text_[i] >= '0' && text_[i] <= '9'; };
        const bool is_day = end - at_ == 10 && is_digit(at_) && text_[at_ + 4] == '-' && text_[at_ + 7] == '-';
        if (is_day && end + 3 < text_.size() && text_[end] == ' ' && is_digit(end + 1) && text_[end + 3] == ':')
            end = std::min(text_.find_first_of(" \t\r\n#]},", end + 1), text_.size());
        return end - at_;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::vector<Token> tokens_;
};

struct Line {
    std::string text;
    std::string_view comment;
};

/// Puts tokens into lines.
class Layout {
public:
    explicit Layout(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

    std::string run() {
        while (at_ < tokens_.size()) statement();
        while (!lines_.empty() && is_empty(lines_.back())) lines_.pop_back();
        return joined();
    }

private:
    static bool is_empty(const Line& line) { return line.text.empty() && line.comment.empty(); }
    bool is_end() const { return at_ == tokens_.size(); }
    const Token& now() const { return tokens_[at_]; }
    bool is_now(std::string_view mark) const { return !is_end() && now().is(mark); }
    void append(std::string_view text) { lines_.back().text += text; }
    void begin_line() { lines_.push_back({std::string(depth_ * kIndent, ' '), {}}); }

    /// What the author separated stays separated, by one line.
    void empty_line() {
        if (!lines_.empty() && !is_empty(lines_.back())) lines_.push_back({});
    }

    void statement() {
        std::size_t ends = 0;
        for (; !is_end() && now().kind == TokenKind::line_end; ++at_) ++ends;
        if (ends > 1) empty_line();
        if (is_end()) return;
        if (is_now("[")) empty_line_above_header();
        begin_line();
        if (is_now("["))
            header();
        else if (now().kind != TokenKind::comment)
            key_and_value();
        comment();
    }

    /// Comments right above a header are about it, unless they stand at the very top of the file.
    void empty_line_above_header() {
        std::size_t first = lines_.size();
        while (first > 0 && lines_[first - 1].text.empty() && !lines_[first - 1].comment.empty()) --first;
        if (first > 0 && !is_empty(lines_[first - 1])) lines_.insert(lines_.begin() + std::ptrdiff_t(first), Line{});
    }

    void comment() {
        if (is_end() || now().kind != TokenKind::comment) return;
        std::string_view text = now().text;
        text = text.substr(0, text.find_last_not_of(" \t") + 1);
        lines_.back().comment = text;
        ++at_;
    }

    void header() {
        for (; !is_end() && now().kind != TokenKind::line_end && now().kind != TokenKind::comment; ++at_)
            append(now().text);
    }

    void key_and_value() {
        std::string key;
        for (; !is_now("="); ++at_) key += now().text;
        append(key + " = ");
        ++at_;
        value(key);
    }

    void value(std::string_view key) {
        if (is_now("["))
            array(key == "v" || key == "rect");
        else if (is_now("{"))
            braces();
        else
            append(tokens_[at_++].text);
    }

    void braces() {
        append("{");
        for (++at_; !is_now("}");) {
            append(" ");
            key_and_value();
            if (is_now(",")) append(tokens_[at_++].text);
        }
        append(tokens_[at_ - 1].is("{") ? "}" : " }");
        ++at_;
    }

    /// Whether the author broke this array, not one inside of it, into lines.
    bool has_lines() const {
        std::size_t open = 0;
        for (std::size_t i = at_; i < tokens_.size(); ++i) {
            if (tokens_[i].is("[") || tokens_[i].is("{")) ++open;
            if (tokens_[i].kind == TokenKind::line_end && open == 1) return true;
            if ((tokens_[i].is("]") || tokens_[i].is("}")) && --open == 0) return false;
        }
        return false;
    }

    /// are_pairs : of numbers that belong together by two
    void array(bool are_pairs) {
        const bool is_broken = has_lines();
        append("[");
        ++at_;
        depth_ += is_broken;
        std::size_t count = 0, ends = 0;
        for (bool is_behind_value = false; !is_now("]");) {
            if (now().kind == TokenKind::line_end) {
                ++ends;
                ++at_;
            } else if (is_now(",")) {
                ++at_;
            } else {
                item(is_broken, ends, count, is_behind_value, are_pairs);
                is_behind_value = true;
            }
        }
        depth_ -= is_broken;
        if (is_broken) begin_line();
        append("]");
        ++at_;
    }

    /// One value of an array, or a comment in it. ends : of lines that came before it
    void item(bool is_broken, std::size_t& ends, std::size_t& count, bool is_behind_value, bool are_pairs) {
        if (is_broken && ends > 1 && count > 0) lines_.push_back({});
        if (is_broken && ends > 0) begin_line();
        const bool begins_line = ends > 0;
        ends = 0;
        if (now().kind == TokenKind::comment) return comment();
        if (is_behind_value && !is_broken) append(",");
        if (is_behind_value && !begins_line) append(are_pairs && count % 2 == 0 ? "  " : " ");
        value("");
        if (is_broken) append(",");
        ++count;
    }

    /// How far a line reaches where there is a comment behind it [characters]; none where there is not.
    static std::size_t width(const Line& line) {
        if (line.comment.empty() || line.text.find_first_not_of(' ') == std::string::npos) return 0;
        return characters_in(std::string_view(line.text).substr(line.text.rfind('\n') + 1));
    }

    /// Where the comments of the lines from this one on begin, as far as there is one behind each. Very long lines have
    /// theirs right behind them.
    std::size_t widest_from(std::size_t first) const {
        std::size_t widest = 0;
        for (std::size_t i = first; i < lines_.size() && width(lines_[i]) > 0; ++i)
            if (width(lines_[i]) <= kWidest) widest = std::max(widest, width(lines_[i]));
        return widest;
    }

    std::string joined() const {
        std::string text;
        std::size_t widest = 0;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const std::size_t own = width(lines_[i]);
            if (own > 0 && (i == 0 || width(lines_[i - 1]) == 0)) widest = widest_from(i);
            text += lines_[i].text;
            if (own > 0) text += std::string(std::max(widest, own) - own + 2, ' ');
            text += lines_[i].comment;
            text += '\n';
        }
        return text;
    }

    std::vector<Token> tokens_;
    std::vector<Line> lines_;
    std::size_t at_ = 0, depth_ = 0;
};

bool are_same(TomlNode a, TomlNode b) {
    if (a.kind() != b.kind()) return false;
    switch (a.kind()) {
        case TomlKind::absent:
        case TomlKind::date: return true;  // its text is copied
        case TomlKind::string: return a.text() == b.text();
        case TomlKind::integer: return a.integer() == b.integer();
        case TomlKind::real: return a.number() == b.number() || (a.number() != a.number() && b.number() != b.number());
        case TomlKind::boolean: return a.boolean() == b.boolean();
        case TomlKind::array: {
            bool all = a.size() == b.size();
            for (std::size_t i = 0; all && i < a.size(); ++i) all = are_same(a.at(i), b.at(i));
            return all;
        }
        case TomlKind::table: break;
    }
    const auto as = a.entries(), bs = b.entries();
    return std::ranges::equal(
        as, bs, [](const TomlEntry& x, const TomlEntry& y) { return x.key == y.key && are_same(x.value, y.value); });
}

}  // namespace

Result<std::string> lay_out_toml(std::string_view text) {
    constexpr TomlLimits kLimits{kMaxMapBytes, kMaxMapValues};
    Findings findings;
    const auto before = TomlDocument::parse(text, kLimits, findings);
    if (!before) return Error{"", to_text("", findings.front()).substr(1)};
    std::string laid_out = Layout(Tokens(text).take()).run();
    const auto after = TomlDocument::parse(laid_out, kLimits, findings);
    if (!after || !are_same(before->root(), after->root()))
        return Error{"", "this text would not say the same laid out anew, so it stays as it is; please report it"};
    return laid_out;
}

}  // namespace enfilade
