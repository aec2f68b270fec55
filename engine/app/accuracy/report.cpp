#include "app/accuracy/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/accuracy/picture_files.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

/// A setting over all scenes, or in one of them.
struct SettingSum {
    std::string name;
    double promise = 0;
    AccuracyErrors errors;  ///< means where they are means
    AccuracyPrice price;
    double rows = 0;

    double ratio() const { return (price.low_ratio + price.high_ratio) / 2; }
};

void add(const AccuracyRow& row, SettingSum& sum) {
    const AccuracyErrors& from = row.errors;
    AccuracyErrors& to = sum.errors;
    const double rows = sum.rows + 1;
    const auto mix = [&](double& mean, double value) { mean += (value - mean) / rows; };
    to.pixels += from.pixels;
    to.judged += from.judged;
    to.wrong_ids += from.wrong_ids;
    to.wrong_texels += from.wrong_texels;
    to.broken += from.broken;
    to.beyond += from.beyond;
    to.largest = std::max(to.largest, from.largest);
    to.per_mille = std::max(to.per_mille, from.per_mille);
    mix(to.mean, from.mean);
    mix(to.psnr, from.psnr);
    mix(to.ssim, from.ssim);
    mix(to.shimmer_turned, from.shimmer_turned);
    mix(to.shimmer_stepped, from.shimmer_stepped);
    mix(sum.price.low_ratio, row.price.low_ratio);
    mix(sum.price.high_ratio, row.price.high_ratio);
    if (sum.rows == 0) sum.price.instructions = row.price.instructions;
    if (sum.price.instructions && row.price.instructions)
        mix(*sum.price.instructions, *row.price.instructions);
    else
        sum.price.instructions = {};
    sum.rows = rows;
}

void add(const AccuracyScene& scene, std::vector<SettingSum>& sums) {
    for (const AccuracyRow& row : scene.rows) {
        auto sum = std::ranges::find(sums, name_of(row.setting), &SettingSum::name);
        if (sum == sums.end())
            sum = sums.insert(sums.end(), SettingSum{name_of(row.setting), row.setting.promise, {}, {}, 0});
        add(row, *sum);
    }
}

std::vector<SettingSum> sums_of(const std::vector<AccuracyScene>& scenes) {
    std::vector<SettingSum> sums;
    for (const AccuracyScene& scene : scenes) add(scene, sums);
    return sums;
}

double percent(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string instructions_text(const AccuracyPrice& price) {
    return price.instructions ? fmt::format("{:.2f}", *price.instructions) : "not counted";
}

/// "0.81 (0.79 to 0.83)"; between them lie half of the rounds.
std::string time_text(const SettingSum& sum) {
    return fmt::format("{:.2f} ({:.2f} to {:.2f})", sum.ratio(), sum.price.low_ratio, sum.price.high_ratio);
}

std::string promise_line(const SettingSum& sum) {
    const AccuracyErrors& e = sum.errors;
    return fmt::format("| {} | {:.1e} | {} | {:.2f} | {} | {} |\n",
                       sum.promise > 0 ? number_text(sum.promise) : "exact", e.largest, e.broken,
                       percent(e.wrong_texels, e.judged), instructions_text(sum.price), time_text(sum));
}

std::string dial_line(const SettingSum& sum) {
    const AccuracyErrors& e = sum.errors;
    return fmt::format("| `{}` | {:.1e} | {:.1e} | {:.1e} | {:.2f} | {:.1f} | {:.3f} | {:.2f} | {:.2f} | {} | {} |\n",
                       sum.name, e.mean, e.per_mille, e.largest, percent(e.wrong_texels, e.judged), e.psnr, e.ssim,
                       e.shimmer_turned, e.shimmer_stepped, instructions_text(sum.price), time_text(sum));
}

bool is_promise(const SettingSum& sum) { return sum.name == "exact" || sum.promise > 0; }

/// The scene in which a setting saves most, and its time there.
std::string best_scene(const std::vector<AccuracyScene>& scenes, const std::string& name) {
    std::string best;
    double least = 1;
    for (const AccuracyScene& scene : scenes)
        for (const SettingSum& sum : sums_of({scene})) {
            if (sum.name != name || sum.ratio() >= least) continue;
            least = sum.ratio();
            best = fmt::format(", and {:.0f} % in {}, where it saves most", 100 * least, scene.name);
        }
    return best;
}

/// What somebody who reads no further should know.
std::string summary_of(const std::vector<AccuracyScene>& scenes, const std::vector<SettingSum>& sums) {
    const SettingSum &exact = sums.front(), *cheapest = &exact;
    for (const SettingSum& sum : sums)
        if (is_promise(sum) && sum.promise <= 1 && sum.ratio() < cheapest->ratio()) cheapest = &sum;
    std::string text = fmt::format(
        "**Drawn exactly, no texel is off by more than {:.0e} of a texel. The cheapest picture that may be off by up "
        "to "
        "a whole texel takes {:.0f} % of the time of the exact one in the mean{}.** Where lamps light a surface, "
        "nothing "
        "is saved.",
        exact.errors.largest, 100 * cheapest->ratio(), best_scene(scenes, cheapest->name));
    if (exact.price.instructions && cheapest->price.instructions)
        text += fmt::format(" A pixel takes {:.1f} instructions in the exact picture, {:.1f} in the cheapest.",
                            *exact.price.instructions, *cheapest->price.instructions);
    const auto vanilla = std::ranges::find(sums, "--dial number=vanilla", &SettingSum::name);
    if (vanilla != sums.end())
        text +=
            fmt::format(" By the formulas of Doom, texels are off by up to {:.0f}, and {:.0f} % of them are others.",
                        vanilla->errors.largest, percent(vanilla->errors.wrong_texels, vanilla->errors.judged));
    return text + "\n";
}

std::string totals_of(const std::vector<AccuracyScene>& scenes) {
    std::uint64_t pixels = 0, beyond = 0, judged = 0, wrong = 0;
    for (const AccuracyScene& scene : scenes)
        for (const AccuracyRow& row : scene.rows) {
            pixels += row.errors.pixels;
            judged += row.errors.judged;
            beyond += row.errors.beyond;
            if (row.setting.dials.links == kMostLinks) wrong += row.errors.wrong_ids;
        }
    return fmt::format(
        "{} pixels, of which {} were judged; {} show another surface than the reference; {} are farther off than is "
        "promised where exact pictures are, too.\n",
        pixels, judged, wrong, beyond);
}

constexpr std::string_view kMeasures = R"(
## What is measured, and by which code

- **Texels**: how far the place on its picture that a pixel shows is from the true one, in texels, along the longer
  side. The truth is worked out anew from the map and the view in numbers of 113 bits; it shares with the renderer which
  wall a ray meets, which the reference renderer decides in whole numbers, and the tie rule for rows. The last step,
  rounding to 2^-32 of a picture, is part of the error.
- **Surfaces**: against the reference renderer, ray by ray. It shares the map, the transforms of links and the tie
  rule.
- **Noise** (peak signal to noise, the higher the better) and **likeness** (structural similarity, at most 1) of
  colours, against 64 rays for each pixel, mixed in linear light. The rays are the column renderer's own.
- **Flicker**: how much a picture changes when the eye turns by 1/64 pixel, and when it goes 2 cm, in parts of what
  those 64 rays change. 1 is right.
- **Time**: the median ratio to exact of rounds taken in turn on one thread, and between which ratios half of the rounds
  lie. A promise is a looser one where intervals part.
- **Instructions** of a pixel, counted by callgrind while pictures are drawn that were drawn once before, uncounted:
  loading and memory that grows are no part of it. They repeat within 0.1 %.
- Poses are anywhere in a room and any look; and on half metres, along axes and diagonals, where ties happen. The rows
  of each are in accuracy.csv and report.json, which `enfilade accuracy --verify report.json` finds again.
)";

// The picture.

/// Whether a setting has anything to do with where texels are.
bool is_of_texels(const SettingSum& sum) {
    return is_promise(sum) || sum.name.find("span=") != sum.name.npos || sum.name.find("number=") != sum.name.npos;
}

/// "span=8" of "--dial span=8".
std::string short_name(const SettingSum& sum) { return sum.name.substr(sum.name.rfind(' ') + 1); }

/// Whether two points are so near that their names would lie over each other.
bool are_side_by_side(const SettingSum& a, const SettingSum& b, bool is_counted) {
    constexpr double kInstructions = 2, kRatio = 0.05, kError = 1.5;
    const double apart =
        is_counted ? (*a.price.instructions - *b.price.instructions) / kInstructions : (a.ratio() - b.ratio()) / kRatio;
    const double error = a.errors.largest / std::max(b.errors.largest, 1e-30);
    return std::fabs(apart) < 1 && error < kError && error > 1 / kError;
}

/// Price, largest error, promise or -1, and name, where there is room for it.
std::string plot_points(const std::string& name, const std::vector<SettingSum>& sums, bool is_counted) {
    std::string text = "$" + name + " << END\n";
    const SettingSum* before = nullptr;
    for (const SettingSum& sum : sums) {
        constexpr double kLeast = 1e-9;  // of the axis
        if (!is_of_texels(sum)) continue;
        const bool has_room = sum.promise > 0 || !before || !are_side_by_side(sum, *before, is_counted);
        before = &sum;
        text += fmt::format("{:.4f} {:.4e} {} \"{}\"\n", is_counted ? *sum.price.instructions : sum.ratio(),
                            std::max(sum.errors.largest, kLeast), sum.promise > 0 ? number_text(sum.promise) : "-1",
                            has_room ? short_name(sum) : "");
    }
    return text + "END\n";
}

std::string plot_of(const std::string& name) {
    return fmt::format(
        "plot 1.0/512 with lines dt 2 lc rgb '#808080' title 'Direct3D: 8 bits of a texel', "
        "0.01 with lines dt 3 lc rgb '#808080' title 'Vulkan, OpenGL ES: 1e-5 of 1024 texels', "
        "${0} using 1:($3 > 0 ? $3 : NaN) with points pt 6 ps 1.2 lc rgb '#c03030' title 'promised: no texel is off by "
        "more', "
        "${0} using 1:2 with points pt 7 ps 0.8 lc rgb '#204a87' title 'measured: the worst texel', "
        "${0} using 1:($3 > 0 ? $3 : $2):4 with labels left offset 0.9,0 font 'sans,9' notitle\n",
        name);
}

std::string plot_name(std::size_t scene) { return "scene_" + std::to_string(scene); }

}  // namespace

std::string accuracy_csv(const std::vector<AccuracyScene>& scenes) {
    std::string text =
        "scene,poses,setting,promise,pixels,wrong_ids,unwritten,written_more,judged,mean,per_mille,largest,"
        "wrong_texels,broken,beyond,psnr_db,ssim,shimmer_turned,shimmer_stepped,minimum_ns,median_ns,low_ratio,"
        "high_ratio,instructions\n";
    for (const AccuracyScene& scene : scenes)
        for (const auto& [poses, setting, e, price] : scene.rows)
            text += fmt::format(
                "{},{},{},{},{},{},{},{},{},{:.6e},{:.6e},{:.6e},{},{},{},{:.4f},{:.6f},{:.6f},{:.6f},{:.4f},{:.4f},"
                "{:.4f},{:.4f},{}\n",
                scene.name, name_of(poses), name_of(setting), number_text(setting.promise), e.pixels, e.wrong_ids,
                e.unwritten, e.written_more, e.judged, e.mean, e.per_mille, e.largest, e.wrong_texels, e.broken,
                e.beyond, e.psnr, e.ssim, e.shimmer_turned, e.shimmer_stepped, price.minimum_ns, price.median_ns,
                price.low_ratio, price.high_ratio,
                price.instructions ? fmt::format("{:.3f}", *price.instructions) : "");
    return text;
}

std::string accuracy_page(const std::vector<AccuracyScene>& scenes, const std::string& command) {
    const std::vector<SettingSum> sums = sums_of(scenes);
    std::string text = "# What accuracy costs in time\n\n" + summary_of(scenes, sums) +
                       "\n![The largest texel error over the instructions of a pixel](accuracy.svg)\n\n"
                       "## What one more digit costs\n\nNo texel is off by more than is promised.\n\n"
                       "| promise [texels] | largest measured | broken | other texels [%] | instructions a pixel | "
                       "time, exact = 1 |\n|---|---|---|---|---|---|\n";
    for (const SettingSum& sum : sums)
        if (is_promise(sum)) text += promise_line(sum);
    text +=
        "\n## What single dials do\n\n| dial | mean [texels] | 99.9 % | largest | other texels [%] | noise [dB] | "
        "likeness | flicker, turning | flicker, going | instructions a pixel | time, exact = 1 |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const SettingSum& sum : sums)
        if (sum.name == "exact" || !is_promise(sum)) text += dial_line(sum);
    text +=
        "\n## What it looks like\n\nA part of the first map, enlarged, and how far each texel of it is off: black up "
        "to "
        "1e-6, blue from 1e-4, red from 0.01, yellow from 0.3, white from 10 texels on; green where there is none to "
        "tell.\n\n| setting | |\n|---|---|\n";
    for (const AccuracySetting& setting : crop_settings())
        text += fmt::format("| `{}` | ![{}](crops/{}.png) |\n", name_of(setting), name_of(setting), crop_name(setting));
    text += "\n" + totals_of(scenes) + std::string(kMeasures) +
            "\n## Scenes\n\n![Each scene](scenes.svg)\n\nWritten by `" + command + "`, on " +
            std::to_string(scenes.size()) + " maps:";
    for (const AccuracyScene& scene : scenes) text += " " + scene.name;
    return text + ".\n";
}

std::string accuracy_plot(const std::vector<AccuracyScene>& scenes, const std::string& folder) {
    const std::vector<SettingSum> sums = sums_of(scenes);
    const bool is_counted =
        std::ranges::all_of(sums, [](const auto& sum) { return sum.price.instructions.has_value(); });
    const char* const price = is_counted ? "instructions of a pixel" : "time of a frame, exact = 1";
    std::string text = fmt::format(
        "set terminal svg size 900,560 font 'sans,12' background 'white'\nset output '{}/accuracy.svg'\nset logscale "
        "y\n"
        "set xlabel '{}'\nset ylabel 'largest texel error [texels]'\nset format y '10^{{%T}}'\nset "
        "grid\n"
        "set key outside below left Left reverse\nset offsets graph 0.05, graph 0.15, graph 0.05, graph 0.05\n",
        folder, price);
    text += plot_points("all", sums, is_counted) + plot_of("all");
    const std::size_t rows = (scenes.size() + 1) / 2;
    text += fmt::format(
        "set terminal svg size 1100,{} font 'sans,10' background 'white'\nset output '{}/scenes.svg'\nunset key\n",
        360 * rows, folder);
    for (std::size_t i = 0; i < scenes.size(); ++i) text += plot_points(plot_name(i), sums_of({scenes[i]}), is_counted);
    text += fmt::format("set multiplot layout {},2\n", rows);
    for (std::size_t i = 0; i < scenes.size(); ++i)
        text += fmt::format("set title '{}' noenhanced\n", scenes[i].name) + plot_of(plot_name(i));
    return text + "unset multiplot\n";
}

Result<void> check_promises(const std::vector<AccuracyScene>& scenes) {
    for (const AccuracyScene& scene : scenes)
        for (const AccuracyRow& row : scene.rows) {
            const AccuracyErrors& e = row.errors;
            const std::string where =
                fmt::format("{}, {} poses, {}", scene.name, name_of(row.poses), name_of(row.setting));
            if (e.unwritten + e.written_more > 0)
                return Error{where, fmt::format("expected every pixel to be written once; {} are not",
                                                e.unwritten + e.written_more)};
            if (e.broken > 0)
                return Error{where, fmt::format("expected no texel to be off by more than {}; {} are, by up to {}",
                                                number_text(row.setting.promise), e.broken, e.largest)};
            if (e.wrong_ids > 0 && row.setting.dials.links == kMostLinks)
                return Error{where,
                             fmt::format("expected the surfaces that the reference sees; {} of {} pixels show others",
                                         e.wrong_ids, e.pixels)};
        }
    return {};
}

}  // namespace enfilade
