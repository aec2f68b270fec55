// Short lists: like a vector, whether what they hold lies in them or on the heap.
#include "base/containers.h"

#include <gmock/gmock.h>

#include "base/hash.h"

namespace enfilade {
namespace {

using ::testing::ElementsAre;

using Numbers = ShortList<int, 3>;

Numbers up_to(int count) {
    Numbers list;
    for (int i = 1; i <= count; ++i) list.push_back(i);
    return list;
}

TEST(ShortList, IsEmptyAtFirst) { EXPECT_TRUE(Numbers().empty()); }

TEST(ShortList, KeepsItsOrderWhenItGrowsBeyondWhatFits) {
    EXPECT_THAT(up_to(3), ElementsAre(1, 2, 3));
    EXPECT_THAT(up_to(5), ElementsAre(1, 2, 3, 4, 5));
}

TEST(ShortList, TakesAnElementOfItsOwn) {
    Numbers list = up_to(3);
    list.push_back(list.front());
    for (int i = 0; i < 20; ++i) list.push_back(list.front());
    EXPECT_EQ(list.back(), 1);
}

TEST(ShortList, IsCopiedAndMovedWhateverItsSize) {
    for (int count : {0, 2, 3, 4, 9}) {
        Numbers list = up_to(count), other = up_to(7);
        const Numbers copy = list;
        EXPECT_EQ(copy, list);
        other = list;
        EXPECT_EQ(other, list);
        const Numbers moved = std::move(list);
        EXPECT_EQ(moved, copy);
        EXPECT_TRUE(list.empty());
        list = std::move(other);
        EXPECT_EQ(list, copy);
    }
}

TEST(ShortList, GivesUpWhatIsAskedFor) {
    for (int count : {3, 6}) {
        Numbers list = up_to(count);
        list.erase_if([](int i) { return i % 2 == 0; });
        EXPECT_EQ(list.size(), static_cast<std::size_t>(count + 1) / 2);
        EXPECT_EQ(list.back(), count / 2 * 2 - (count == 6 ? 1 : -1));
    }
}

// What is done to it at random is done to a vector as well.
TEST(ShortList, BehavesLikeAVector) {
    Random random(1);
    Numbers list;
    std::vector<int> vector;
    for (int i = 0; i < 10000; ++i) {
        const int number = static_cast<int>(random.below(100));
        switch (random.below(vector.size() > 6 ? 4 : 8)) {
            case 0:
                list.clear();
                vector.clear();
                break;
            case 1:
                list.erase_if([&](int n) { return n > number; });
                std::erase_if(vector, [&](int n) { return n > number; });
                break;
            case 2:
            case 3:
                if (vector.empty()) break;
                list.pop_back();
                vector.pop_back();
                break;
            default: list.push_back(number); vector.push_back(number);
        }
        ASSERT_TRUE(std::equal(list.begin(), list.end(), vector.begin(), vector.end())) << "step " << i;
    }
}

}  // namespace
}  // namespace enfilade
