#include "render/column/canvas.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace enfilade::column {
namespace {

/// Four pixels in one register, on any machine.
using Four = std::uint32_t __attribute__((vector_size(16)));

Four load(const std::uint32_t* from) {
    Four four;
    std::memcpy(&four, from, sizeof four);
    return four;
}

void store(std::uint32_t* to, Four four) { std::memcpy(to, &four, sizeof four); }

/// Square blocks of this side, so that lines of both layouts stay in the first-level cache: one cache line [px].
constexpr int kBlock = kCacheLineBytes / sizeof(std::uint32_t);

/// Pixel matrices in memory: how far apart the lines of each are [pixels].
struct Pitches {
    std::ptrdiff_t from;
    std::ptrdiff_t to;
};

/// 4 x 4 pixels: lines become columns.
void turn_four(const std::uint32_t* from, std::uint32_t* to, Pitches pitch) {
    const Four a = load(from), b = load(from + pitch.from), c = load(from + 2 * pitch.from),
               d = load(from + 3 * pitch.from);
    const Four ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5), ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const Four cd_low = __builtin_shufflevector(c, d, 0, 4, 1, 5), cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    store(to, __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5));
    store(to + pitch.to, __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7));
    store(to + 2 * pitch.to, __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5));
    store(to + 3 * pitch.to, __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7));
}

/// lines x length pixels, one by one: for what is left at the edges.
void turn_plainly(const std::uint32_t* from, std::uint32_t* to, Pitches pitch, int lines, int length) {
    for (int line = 0; line < lines; ++line)
        for (int i = 0; i < length; ++i) to[i * pitch.to + line] = from[line * pitch.from + i];
}

/// Starts to bring a block that is turned next, and the place it goes to, into the cache. Both are far apart in memory,
/// so that processors do not foresee them: without this, turning takes twice as long.
void fetch_block(const std::uint32_t* from, const std::uint32_t* to, Pitches pitch) {
    constexpr int kToBeWritten = 1;
    for (int line = 0; line < kBlock; ++line) {
        __builtin_prefetch(from + line * pitch.from);
        __builtin_prefetch(to + line * pitch.to, kToBeWritten);
    }
}

/// Four whole lines of `to` after four others: a cache line is filled at once.
void turn_whole_block(const std::uint32_t* from, std::uint32_t* to, Pitches pitch) {
    for (int i = 0; i < kBlock; i += 4)
        for (int line = 0; line < kBlock; line += 4)
            turn_four(from + line * pitch.from + i, to + i * pitch.to + line, pitch);
}

/// Lines of `from` become columns of `to`.
void turn_block(const std::uint32_t* from, std::uint32_t* to, Pitches pitch, int lines, int length) {
    if (lines == kBlock && length == kBlock) return turn_whole_block(from, to, pitch);
    const int whole_lines = lines / 4 * 4, whole_length = length / 4 * 4;
    for (int line = 0; line < whole_lines; line += 4) {
        for (int i = 0; i < whole_length; i += 4)
            turn_four(from + line * pitch.from + i, to + i * pitch.to + line, pitch);
        turn_plainly(from + line * pitch.from + whole_length, to + whole_length * pitch.to + line, pitch, 4,
                     length - whole_length);
    }
    turn_plainly(from + whole_lines * pitch.from, to + whole_lines, pitch, lines - whole_lines, length);
}

}  // namespace

void Canvas::set(int begin, int end, int height) {
    begin_ = begin;
    end_ = end;
    height_ = height;
    const int lines = (height + kBlock - 1) / kBlock | 1;
    pitch_ = std::ptrdiff_t{lines} * kBlock;
    const std::size_t pixels = static_cast<std::size_t>(end - begin) * static_cast<std::size_t>(pitch_);
    // Made larger anew after each smaller one, it would be cleared.
    if (pixels_.size() < pixels) pixels_.resize(pixels);
}

// Blocks begin where the picture's own cache lines do.
void Canvas::copy_to(Frame& frame) const {
    const Pitches pitch{pitch_, frame.width};
    std::uint32_t* const corner = &frame.pixels[static_cast<std::size_t>(begin_)];
    const int before_line = (kBlock - begin_ % kBlock) % kBlock;
    const int width = end_ - begin_;
    for (int y = 0; y < height_; y += kBlock)
        for (int x = 0, next; x < width; x = next) {
            next = std::min(width, x < before_line ? before_line : x + kBlock);
            if (next + kBlock <= width && y + kBlock <= height_)
                fetch_block(pixels_.data() + next * pitch_ + y, corner + y * pitch.to + next, pitch);
            turn_block(pixels_.data() + x * pitch_ + y, corner + y * pitch.to + x, pitch, next - x,
                       std::min(kBlock, height_ - y));
        }
}

}  // namespace enfilade::column
