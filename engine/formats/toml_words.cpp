// The sentences of toml++ 3.3 and ours. It tells what its parser was doing; ours tell an author what to write.
#include "formats/toml_tree.h"

#include <algorithm>
#include <optional>

#include "formats/text_parts.h"

namespace enfilade {
namespace {

/// How one kind of the library's reasons is said. `found` stands where its sentence does not quote what it saw.
struct Wording {
    std::string_view scope;   ///< what it was parsing; empty: whatever
    std::string_view reason;  ///< a part of its sentence that no earlier entry's is
    std::string_view expected;
    std::string_view found;
    std::string_view mend;
};

constexpr std::string_view kEndOfFile = "the end of the file";
constexpr std::string_view kNumber = "a number like 12, -0.5 or 1e-3";
constexpr std::string_view kQuoteIt = "if it is no number, put it into quotes";
constexpr std::string_view kEscape = "an escape that TOML knows, like \\n, \\t, \\\", \\\\ or \\u00e9";
constexpr std::string_view kSingleQuotes = "write each backslash twice, or put the string into single quotes";
constexpr std::string_view kDate = "a date like 1979-05-27, a time like 07:32:00, or both with a T between";
constexpr std::string_view kBraces = "braces end on the line they begin on, with no comma before the last one";
constexpr std::string_view kBrackets = "put a comma between members, and a ']' behind the last";

/// The first that fits counts.
constexpr Wording kWordings[] = {
    {"string", "encountered end-of-file", "the quote that ends the string", kEndOfFile, "add the quote"},
    {"literal string", "encountered end-of-file", "the quote that ends the string", kEndOfFile, "add the quote"},
    {"array", "encountered end-of-file", "a ']' that ends the array", kEndOfFile, "add the bracket"},
    {"inline table", "encountered end-of-file", "a '}' that ends the table", kEndOfFile, "add the brace"},
    {"table header", "encountered end-of-file", "a ']' that ends the table's name", kEndOfFile, "add the bracket"},
    {"key-value pair", "encountered end-of-file", "a '=' and a value behind the key", kEndOfFile, "write key = value"},
    {"key", "encountered end-of-file", "the rest of a key", kEndOfFile, "write key = value"},
    {"", "encountered end-of-file", "the rest of the value", kEndOfFile, "write it to its end"},

    {"key-value pair", "expected '='", "a '=' behind the key", "", "write key = value, and strings in quotes"},
    {"key-value pair", "expected value, saw", "a value behind the '='", "",
     "write a number, true, false, or a string in quotes"},
    {"", "expected keys, tables, whitespace or comments", "a key, a [table] or a comment with #", "",
     "keys have letters, digits, '_' and '-', or stand in quotes"},
    {"table header", "expected a comment or whitespace", "the end of the line behind the header", "",
     "put what follows onto a line of its own"},
    {"", "expected a comment or whitespace, saw ','", "the end of the line behind the value", "','",
     "decimal numbers have a point, as in 2.5; put each key onto a line of its own"},
    {"", "expected a comment or whitespace", "the end of the line behind the value", "",
     "put each key onto a line of its own; strings stand in quotes, comments begin with #"},
    {"", "brackets must be contiguous", "[[ without a blank between the brackets", "[ [", "write [[name]]"},
    {"", "blank bare keys", "a name between the brackets", "none", "name the table"},
    {"", "expected ']'", "a ']' behind the table's name", "", "write [name], or [[name]] with two on either side"},
    {"", "existing inline table", "a table that may be added to", "one that is written in braces",
     "add its keys between the braces"},
    {"", "cannot redefine existing table", "a table that is not there yet", "it again",
     "put its keys together, or write [[name]] for one more of many"},
    {"", "as dotted key-value pair", "a table before the dot of the key", "something else of that name",
     "give each key once"},
    {"table header", "cannot redefine existing array", "[[name]], as where the name stands before", "[name]",
     "double the brackets: each [[name]] is one more of many"},
    {"", "cannot redefine existing", "a key that is not there yet", "it again", "give each key once"},
    {"", "multi-line strings are prohibited", "a key on one line", "a string in three quotes",
     "use single quotation marks"},
    {"", "expected bare key starting character", "a key", "",
     "keys have letters, digits, '_' and '-', or stand in quotes"},

    {"", "expected hex digit", "a hexadecimal digit, 0 to 9 or a to f, in the escape", "",
     "\\u takes four of them and \\U eight; for a plain backslash write two"},
    {"", "values greater than U+10FFFF", "the number of a letter, at most 10ffff", "a larger one",
     "look up the letter's number"},
    {"", "surrogates", "the number of a letter", "half of one, d800 to dfff", "write the letter itself"},
    {"", "line-ending backslashes", "the end of the line behind the backslash", "something else", kSingleQuotes},
    {"", "unknown escape sequence", kEscape, "another", kSingleQuotes},
    {"", "escape sequence '\\", kEscape, "one of later versions of TOML", kSingleQuotes},
    {"", "prohibited in comments", "letters in the comment", "a control character", "take it away"},
    {"", "control character", "a letter", "a control character", "take it away, or write \\u0007 and the like"},
    {"", "vertical tabs", "the end of the line", "a vertical tab or form feed", "take it away"},
    {"", "expected '\\n' after '\\r'", "the end of the line", "a carriage return alone", "end lines with a line feed"},
    {"", "expected space or tab", "a blank", "", "use plain blanks between keys and values"},

    {"boolean", "expected '", "true or false", "", "write it in small letters, or put a string into quotes"},
    {"", "expected value-terminator", "the end of the value", "",
     "strings stand in quotes, members have commas between"},
    {"", "fractional component exceeds", kDate, "too many digits of a second", "nine are enough"},
    {"date", "expected", kDate, "", kQuoteIt},
    {"time", "expected", kDate, "", kQuoteIt},
    {"date-time", "expected", kDate, "", kQuoteIt},
    {"date-time offset", "expected", "an offset like +01:00", "", kQuoteIt},

    {"", "underscores", "a digit before and behind each '_' of a number", "none", kQuoteIt},
    {"", "leading zeroes", "a number without a zero before it", "one", "take the zero away, or use quotes"},
    {"", "not representable in 64 bits", "a number of at most 64 bits", "a larger one", "write a smaller one"},
    {"", "exceeds length limit", kNumber, "more digits than anybody needs", "write fewer"},
    {"", "fragment exceeeds", kNumber, "more digits than anybody needs", "write fewer"},
    {"", "numeric value too long", kNumber, "more digits than anybody needs", "write fewer"},
    {"", "hexadecimal floating-point values", kNumber, "a hexadecimal one with a point",
     "write it with decimal digits"},
    {"", "missing exponent", kNumber, "no exponent", kQuoteIt},
    {"array", "saw comma", "a value or ']'", "a comma without a value before it", "take the comma away"},
    {"inline table", "saw comma", "a key or '}'", "a comma without a key before it", "take the comma away"},
    {"", "dangling comma", "a key behind the last comma", "'}'",
     "take the comma away: TOML allows none at the end of { }, though it does in [ ]"},
    {"", "expected comma or closing ']'", "a comma or ']'", "", kBrackets},
    {"", "expected comma or closing '}'", "a comma or '}'", "",
     "put a comma between members, and a '}' behind the last one, all on one line"},
    {"", "expected key or closing '}'", "a key or '}'", "", kBraces},
    {"", "could not be interpreted", kNumber, "something else", kQuoteIt},
    {"", "an unspecified error", kNumber, "something else", kQuoteIt},
    {"", "values may not begin with underscores", "a value", "'_'", "put a string into quotes"},
    {"", "could not determine value type", "a value", "a word without quotes", "put a string into quotes"},
    {"", "maximum nested value depth", "fewer arrays within arrays", "more than can be read", "nest them less"},
    {"", "'0', saw", kNumber, "", kQuoteIt},
    {"", "digit", kNumber, "", kQuoteIt},
    {"floating-point", "expected '", kNumber, "", kQuoteIt},
    {"binary integer", "expected '", kNumber, "", kQuoteIt},
    {"octal integer", "expected '", kNumber, "", kQuoteIt},
    {"hexadecimal integer", "expected '", kNumber, "", kQuoteIt},
    {"", "expected 'x' or 'X'", kNumber, "", kQuoteIt},
};

const Wording* wording_of(std::string_view scope, std::string_view reason) {
    const auto fits = [&](const Wording& w) {
        return (w.scope.empty() || w.scope == scope) && reason.find(w.reason) != std::string_view::npos;
    };
    const auto it = std::ranges::find_if(kWordings, fits);
    return it == std::end(kWordings) ? nullptr : it;
}

/// What the library says it saw, as it quotes it.
std::string seen_in(std::string_view reason) {
    constexpr std::string_view kSaw = ", saw ";
    const auto at = reason.rfind(kSaw);
    if (at == std::string_view::npos) return "something else";
    const std::string_view seen = reason.substr(at + kSaw.size());
    if (seen == "'\\n'" || seen == "'\\r'") return "the end of the line";
    return seen == "''" || seen == "EOF" ? std::string(kEndOfFile) : std::string(seen);
}

/// A string that is not ended reads on to the control character that ends its line.
constexpr Wording kOpenString{"", "", "the quote that ends the string", "the end of the line",
                              "add the quote; a text of several lines stands in three quotes"};

std::string say(const Wording& wording, std::string_view reason) {
    const std::string found = wording.found.empty() ? seen_in(reason) : std::string(wording.found);
    return "expected " + std::string(wording.expected) + ", found " + found + "; " + std::string(wording.mend);
}

}  // namespace

std::string toml_words(std::string_view description, bool is_line_end) {
    constexpr std::string_view kBefore = "Error while parsing ", kBehindScope = ": ";
    const auto colon = description.find(kBehindScope);
    if (!description.starts_with(kBefore) || colon == std::string_view::npos) return std::string(description);
    const std::string_view scope = description.substr(kBefore.size(), colon - kBefore.size());
    const std::string_view reason = description.substr(colon + kBehindScope.size());
    const bool in_string = scope == "string" || scope == "literal string";
    if (in_string && is_line_end && reason.find("control characters") != std::string_view::npos)
        return say(kOpenString, reason);
    const Wording* wording = wording_of(scope, reason);
    return wording ? say(*wording, reason) : std::string(description);
}

bool has_toml_words(std::string_view scope, std::string_view reason) { return wording_of(scope, reason) != nullptr; }

}  // namespace enfilade
