#include "app/accuracy/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/text_parts.h"

namespace enfilade {
namespace {

constexpr std::string_view kColumns =
    "scene,poses,setting,promise,pixels,wrong_ids,unwritten,written_more,judged,mean,per_mille,largest,wrong_texels,"
    "broken,beyond,psnr_db,minimum_ns,median_ns,low_ratio,high_ratio,instructions";

/// The part of a line that another run has to repeat.
std::string errors_text(AccuracyRow& row) {
    AccuracyErrors& e = row.errors;
    return fmt::format("{},{},{},{},{},{},{},{},{},{:.6e},{:.6e},{:.6e},{},{},{},{:.4f}", row.scene, name_of(row.poses),
                       name_of(row.setting), number_text(row.setting.promise), e.pixels, e.wrong_ids, e.unwritten,
                       e.written_more, e.texel_errors.size(), e.mean(), e.per_mille(), e.largest(), e.wrong_texels,
                       e.broken, e.beyond, std::min(e.psnr(), 999.0));
}

std::string price_text(const AccuracyPrice& price) {
    return fmt::format("{:.4f},{:.4f},{:.4f},{:.4f},{}", price.minimum_ns, price.median_ns, price.low_ratio,
                       price.high_ratio, price.instructions ? fmt::format("{:.3f}", *price.instructions) : "");
}

/// A setting over all scenes.
struct SettingSum {
    std::string name;
    double promise = 0;
    AccuracyErrors errors;
    double ratio = 0, instructions = 0;  ///< sums over `priced` rows
    std::size_t priced = 0;
    bool is_counted = true;
};

void add(const AccuracyErrors& from, AccuracyErrors& to) {
    to.pixels += from.pixels;
    to.wrong_ids += from.wrong_ids;
    to.unwritten += from.unwritten;
    to.written_more += from.written_more;
    to.wrong_texels += from.wrong_texels;
    to.broken += from.broken;
    to.beyond += from.beyond;
    to.squared_color += from.squared_color;
    to.texel_errors.insert(to.texel_errors.end(), from.texel_errors.begin(), from.texel_errors.end());
}

std::vector<SettingSum> sums_of(const std::vector<AccuracyRow>& rows) {
    std::vector<SettingSum> sums;
    for (const AccuracyRow& row : rows) {
        auto sum = std::ranges::find(sums, name_of(row.setting), &SettingSum::name);
        if (sum == sums.end())
            sum = sums.insert(sums.end(), SettingSum{name_of(row.setting), row.setting.promise, {}, 0, 0, 0, true});
        add(row.errors, sum->errors);
        sum->ratio += (row.price.low_ratio + row.price.high_ratio) / 2;
        sum->is_counted &= row.price.instructions.has_value();
        sum->instructions += row.price.instructions.value_or(0);
        ++sum->priced;
    }
    return sums;
}

double share(std::size_t part, std::size_t whole, double of) {
    return whole == 0 ? 0 : of * static_cast<double>(part) / static_cast<double>(whole);
}

std::string sum_line(SettingSum& sum) {
    AccuracyErrors& e = sum.errors;
    const auto priced = static_cast<double>(sum.priced);
    return fmt::format("| `{}` | {} | {} | {:.1e} | {:.1e} | {:.1e} | {:.3f} | {:.2f} | {:.2f} | {:.2f} |\n", sum.name,
                       sum.promise > 0 ? number_text(sum.promise) : "", e.broken, e.mean(), e.per_mille(), e.largest(),
                       share(e.wrong_texels, e.texel_errors.size(), 100), std::min(e.psnr(), 999.0), sum.ratio / priced,
                       sum.is_counted ? sum.instructions / priced : std::nan(""));
}

}  // namespace

std::string accuracy_csv(std::vector<AccuracyRow>& rows) {
    std::string text = std::string(kColumns) + "\n";
    for (AccuracyRow& row : rows) text += errors_text(row) + "," + price_text(row.price) + "\n";
    return text;
}

Status compare_errors(const std::string& path, std::string_view csv, std::vector<AccuracyRow>& rows) {
    LineReader lines(csv);
    const auto names = lines.next();
    if (!names || names->text != kColumns)
        return Error{path,
                     fmt::format("expected the columns {}; found {}", kColumns, quoted(names ? names->text : ""))};
    for (AccuracyRow& row : rows) {
        const auto line = lines.next();
        const std::string errors = errors_text(row);
        if (!line || !line->text.starts_with(errors + ","))
            return Error{path + ":" + std::to_string(line ? line->number : 0),
                         fmt::format("expected {}; found {}", errors, quoted(line ? line->text : ""))};
    }
    return {};
}

std::string accuracy_page(std::vector<AccuracyRow>& rows, const std::string& command) {
    std::string text = fmt::format(
        "# What accuracy costs in time\n\nWritten by `{}`. Texel errors are against places worked out in numbers of "
        "113 "
        "bits, in texels along the longer side; wrong texels are those that are another one. The noise of colours "
        "(peak "
        "signal to noise) is against 64 rays for each pixel. Time is the ratio to exact, rounds taken in turn.\n\n"
        "| setting | promise | broken | mean | 99.9 % | largest | wrong texels [%] | noise [dB] | time | instructions "
        "a pixel |\n|---|---|---|---|---|---|---|---|---|---|\n",
        command);
    for (SettingSum& sum : sums_of(rows)) text += sum_line(sum);
    std::uint64_t pixels = 0, beyond = 0, judged = 0, wrong = 0;
    for (const AccuracyRow& row : rows) {
        pixels += row.errors.pixels;
        judged += row.errors.texel_errors.size();
        beyond += row.errors.beyond;
        if (row.setting.dials.links == kMostLinks) wrong += row.errors.wrong_ids;
    }
    return text + fmt::format(
                      "\n{} pixels, of which {} were judged; {} show another surface than the reference; {} are "
                      "farther off than is promised where exact pictures are, too.\n",
                      pixels, judged, wrong, beyond);
}

std::string accuracy_plot(std::vector<AccuracyRow>& rows, const std::string& output) {
    std::string text = fmt::format(
        "set terminal svg size 900,560 font 'sans,13' background 'white'\nset output '{}'\nset logscale y\n"
        "set xlabel 'time of a frame, exact = 1'\nset ylabel 'largest texel error [texels]'\nset format y '10^{{%T}}'\n"
        "set grid\nset key outside below\nset offsets graph 0.05, graph 0.25, graph 0.05, graph 0.05\n$points << END\n",
        output);
    std::vector<SettingSum> sums = sums_of(rows);
    for (SettingSum& sum : sums)
        text += fmt::format("{:.4f} {:.4e} \"{}\" {}\n", sum.ratio / static_cast<double>(sum.priced),
                            std::max(sum.errors.largest(), 1e-12), sum.name,
                            sum.promise > 0 ? number_text(sum.promise) : "NaN");
    return text +
           "END\nplot $points using 1:($4 > 0 ? $4 : NaN) with points pt 6 ps 1.4 lc rgb '#c03030' title 'promised', "
           "$points using 1:2 with points pt 7 ps 0.8 lc rgb '#204a87' title 'measured', "
           "$points using 1:2:3 with labels left offset 0.8,0 font 'sans,10' notitle\n";
}

Status check_promises(const std::vector<AccuracyRow>& rows) {
    for (const AccuracyRow& row : rows) {
        const AccuracyErrors& e = row.errors;
        const std::string where = fmt::format("{}, {} poses, {}", row.scene, name_of(row.poses), name_of(row.setting));
        if (e.unwritten + e.written_more > 0)
            return Error{where, fmt::format("expected every pixel to be written once; {} are not",
                                            e.unwritten + e.written_more)};
        if (e.broken > 0)
            return Error{where, fmt::format("expected no texel to be off by more than {}; {} are, by up to {}",
                                            number_text(row.setting.promise), e.broken, e.largest())};
        if (e.wrong_ids > 0 && row.setting.dials.links == kMostLinks)
            return Error{where,
                         fmt::format("expected the surfaces that the reference sees; {} of {} pixels show others",
                                     e.wrong_ids, e.pixels)};
    }
    return {};
}

}  // namespace enfilade
