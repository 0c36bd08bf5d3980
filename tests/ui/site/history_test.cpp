#include "ui/site/history.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

History<int> counted(int to) {
    History<int> history;
    for (int i = 1; i <= to; ++i) history.add(i);
    return history;
}

TEST(History, ForgetsStepsThatNoLongerChangeAnything) {
    History<int> history = counted(5);
    history.rewrite([](int& value) { value /= 2; });  // 0 0 1 1 2 2
    EXPECT_EQ(history.now(), 2);
    history.undo();
    EXPECT_EQ(history.now(), 1);
    history.undo();
    EXPECT_EQ(history.now(), 0);
    EXPECT_FALSE(history.canUndo());
}

TEST(History, StaysWhereItIsWhenItIsRewritten) {
    History<int> history = counted(5);
    history.undo();
    history.undo();
    history.rewrite([](int& value) { value *= 10; });
    EXPECT_EQ(history.now(), 30);
    history.redo();
    EXPECT_EQ(history.now(), 40);
}

}  // namespace
}  // namespace hedr
