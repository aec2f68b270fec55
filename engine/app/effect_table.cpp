// Prices of effects as tables.
#include <fmt/format.h>

#include "app/effect_prices.h"
#include "formats/number_text.h"

namespace enfilade {
namespace {

std::string ms_text(const std::optional<double>& ms) { return ms ? fmt::format("{:+.3f} ms", *ms) : "-"; }

/// What is counted, as it follows the number.
std::string noun_for(const EffectUse& use) { return std::string(use.effect->counted) + (use.count == 1 ? "" : "s"); }

std::string footnote(const Prices& prices) {
    return fmt::format(
        "a frame with everything: {:.3f} ms of processor time (column, {}x{}, one thread, mean of {} looks)\n",
        prices.frame_ms, prices.width, prices.height, prices.looks);
}

}  // namespace

std::string to_text(const Prices& prices) {
    if (prices.effects.empty()) return "  nothing beyond plain rooms\n";
    std::string text = fmt::format("  {:<17}{:>16}{:>14}{:>14}\n", "", "", "where seen", "elsewhere");
    for (const auto& [use, price] : prices.effects)
        text += fmt::format("  {:<17}{:>6} {:<9}{:>14}{:>14}  {}\n", use.effect->name, use.count, noun_for(use),
                            ms_text(price ? price->seen : std::nullopt), ms_text(price ? price->unseen : std::nullopt),
                            use.effect->cost);
    if (prices.frame_ms > 0) text += "  " + footnote(prices);
    return text;
}

std::string to_markdown(const Prices& prices) {
    std::string text = "| effect | in the map | where it is seen | elsewhere | what is paid |\n|---|---|---|---|---|\n";
    for (const auto& [use, price] : prices.effects)
        text += fmt::format("| {} | {} | {} | {} | {} |\n", use.effect->name, counted(use.count, use.effect->counted),
                            ms_text(price ? price->seen : std::nullopt), ms_text(price ? price->unseen : std::nullopt),
                            use.effect->cost);
    if (prices.frame_ms > 0) text += "\n" + footnote(prices);
    return text;
}

}  // namespace enfilade
