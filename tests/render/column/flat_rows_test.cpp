// The rows of flats: the same whether they were known before or not.
#include "render/column/flat_rows.h"

#include <gtest/gtest.h>

#include "base/hash.h"

namespace enfilade::column {
namespace {

constexpr int kHeight = 90;

RayTables rays() {
    View view;
    view.pitch_tangent = 0.2;
    RayTables screen;
    screen.set(Projection(view, 160, kHeight));
    return screen;
}

FlatRowsKey key_of(int number) {
    return {-0.25 - number / 3,
            {LightModel::smooth, 0.3 + 0.01 * (number % 3), 1},
            nullptr,
            {number % 2 ? 4.0 : 0.0, number % 4 ? 1u : 8u, 0}};
}

void expect_as_alone(const FlatRows& rows, const RayTables& screen, int top, int bottom) {
    FlatRows alone;
    alone.start(rows.key(), screen);
    alone.prepare(screen, 0, kHeight);
    for (int row = top; row < bottom; ++row) {
        ASSERT_EQ(rows.depths()[row], alone.depths()[row]);
        ASSERT_EQ(rows.shades()[row], alone.shades()[row]);
        ASSERT_EQ(rows.darkness()[row], alone.darkness()[row]);
        if (is_there(rows.key().fog)) {
            ASSERT_EQ(rows.fog_parts()[row], alone.fog_parts()[row]);
        }
    }
}

TEST(FlatRows, AreTheSameInWhateverOrderTheyComeToBeKnown) {
    const RayTables screen = rays();
    Random random(4);
    FlatRowsCache cache;
    for (int trial = 0; trial < 3000; ++trial) {
        if (random.below(500) == 0) cache.start_frame();
        const FlatRowsKey key = key_of(static_cast<int>(random.below(100)));
        const int top = static_cast<int>(random.below(kHeight)),
                  bottom = top + static_cast<int>(random.below(static_cast<std::uint64_t>(kHeight - top) + 1));
        FlatRows& rows = cache.of(key, screen);
        ASSERT_EQ(rows.key(), key);
        rows.prepare(screen, top, bottom);
        expect_as_alone(rows, screen, top, bottom);
    }
}

TEST(FlatRowsCache, KeepsWhatWasAskedForLast) {
    const RayTables screen = rays();
    FlatRowsCache cache;
    FlatRows& floor = cache.of(key_of(0), screen);
    floor.prepare(screen, 50, 90);
    for (int number = 1; number < 200; ++number) {
        FlatRows& ceiling = cache.of(key_of(number), screen);
        ASSERT_NE(&ceiling, &floor);
        ASSERT_EQ(&cache.of(key_of(0), screen), &floor);
        ASSERT_EQ(floor.known().top, 50);
    }
}

TEST(FlatRowsCache, KnowsNothingOfThePictureBefore) {
    const RayTables screen = rays();
    FlatRowsCache cache;
    cache.of(key_of(0), screen).prepare(screen, 50, 90);
    cache.start_frame();
    EXPECT_TRUE(cache.of(key_of(0), screen).known().is_closed());
}

}  // namespace
}  // namespace enfilade::column
