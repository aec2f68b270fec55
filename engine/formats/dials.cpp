#include "formats/dials.h"

#include <algorithm>
#include <array>
#include <optional>

#include "formats/text_parts.h"
#include "formats/words.h"

namespace enfilade {
namespace {

struct NamedPromise {
    std::string_view name;
    double texel_error;
};
constexpr std::array kPromises{NamedPromise{"exact", 0}, NamedPromise{"fine", 0.25}, NamedPromise{"fast", 1}};

/// A dial: how it is set from a text, and told as one; both by its value.
struct DialKind {
    std::string_view name;
    std::string values;  ///< as a message lists them
    bool (*set)(Dials& dials, std::string_view value);
    std::string (*tell)(const Dials& dials);
};

template <auto member, int low, int high>
DialKind number_dial(std::string_view name) {
    return {name, "a whole number from " + std::to_string(low) + " to " + std::to_string(high),
            [](Dials& dials, std::string_view value) {
                const auto number = parse_number(value);
                if (!number || *number < low || *number > high || *number != static_cast<int>(*number)) return false;
                dials.*member = static_cast<int>(*number);
                return true;
            },
            [](const Dials& dials) { return std::to_string(dials.*member); }};
}

template <Word W>
std::string words_of() {
    std::string all;
    for (const std::string_view word : kWords<W>) all += (all.empty() ? "" : ", ") + std::string(word);
    return all;
}

template <auto member>
DialKind word_dial(std::string_view name) {
    using W = std::remove_cvref_t<decltype(Dials{}.*member)>;
    return {name, words_of<W>(),
            [](Dials& dials, std::string_view value) {
                const auto found = std::ranges::find(kWords<W>, value);
                if (found == kWords<W>.end()) return false;
                dials.*member = static_cast<W>(found - kWords<W>.begin());
                return true;
            },
            [](const Dials& dials) { return std::string(to_word(dials.*member)); }};
}

std::array<DialKind, 11> all_dials() {
    return {number_dial<&Dials::span, 1, kMostSpan>("span"),
            word_dial<&Dials::number>("number"),
            word_dial<&Dials::sampling>("sampling"),
            number_dial<&Dials::samples, 1, kMostSamples>("samples"),
            word_dial<&Dials::light>("light"),
            word_dial<&Dials::fog>("fog"),
            number_dial<&Dials::light_grid, 1, kMostLightPoints>("light_grid"),
            word_dial<&Dials::portals>("portals"),
            number_dial<&Dials::links, 0, kMostLinks>("links"),
            word_dial<&Dials::tick_rate>("tick_rate"),
            word_dial<&Dials::crossing>("crossing")};
}

}  // namespace

Result<void> set_accuracy(Dials& dials, std::string_view text) {
    std::optional<double> promised = parse_number(text);
    for (const NamedPromise& promise : kPromises)
        if (promise.name == text) promised = promise.texel_error;
    if (text == to_word(NumberKind::vanilla))
        dials.number = NumberKind::vanilla;
    else if (promised && *promised >= 0 && *promised <= kMostTexelError)
        dials.texel_error = *promised;
    else
        return Error{"", "expected exact, fine, fast, vanilla, or how many texels anything may be off, from 0 to " +
                             number_text(kMostTexelError) + "; found " + in_quotes(text)};
    return {};
}

Result<void> set_dial(Dials& dials, std::string_view text) {
    const std::size_t equals = text.find('=');
    const std::string_view name = text.substr(0, equals);
    const std::string_view value = equals == text.npos ? std::string_view() : text.substr(equals + 1);
    std::vector<std::string_view> names;
    const auto all = all_dials();
    for (const DialKind& dial : all) {
        names.push_back(dial.name);
        if (dial.name != name) continue;
        if (dial.set(dials, value)) return {};
        return Error{"", "expected " + std::string(name) + "=" + dial.values + "; found " + in_quotes(text)};
    }
    return Error{"", "expected NAME=VALUE, as in span=8; found " + in_quotes(text) + suggestion(name, names)};
}

std::string to_text(const Dials& dials) {
    const Dials exact;
    std::string text;
    if (dials.texel_error != exact.texel_error) text += " accuracy=" + number_text(dials.texel_error);
    for (const DialKind& dial : all_dials())
        if (dial.tell(dials) != dial.tell(exact)) text += " " + std::string(dial.name) + "=" + dial.tell(dials);
    return text.empty() ? "exact" : text.substr(1);
}

}  // namespace enfilade
