#include "ui/calibration/plot_thinning.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hedr {
namespace {

const QPointF kGap(std::nan(""), std::nan(""));

// So many points of noise over a strip of 600 x 400 px, from left to right.
std::vector<QPointF> noise(int count) {
    std::vector<QPointF> points;
    for (int i = 0; i < count; ++i) {
        points.emplace_back(600.0 * i / count, 200.0 + 190.0 * std::sin(1e4 * std::sin(1.0 * i)));
    }
    return points;
}

qsizetype size(const std::vector<QPolygonF>& pieces) {
    qsizetype all = 0;
    for (const QPolygonF& piece : pieces) all += piece.size();
    return all;
}

TEST(PlotThinning, KeepsAShortLineAsItIs) {
    const std::vector<QPointF> line{{0, 0}, {10, 10}, {20, 0}};
    const auto pieces = linePieces(line, 1.0);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(pieces.front(), QPolygonF(QList<QPointF>(line.begin(), line.end())));
}

TEST(PlotThinning, LeavesGapsOpen) {
    const auto pieces = linePieces({{0, 0}, {10, 10}, kGap, {30, 0}, {40, 5}, kGap, {60, 6}}, 1.0);
    ASSERT_EQ(pieces.size(), 2U) << "a point alone is no line";
    EXPECT_EQ(pieces[0].back(), QPointF(10, 10));
    EXPECT_EQ(pieces[1].front(), QPointF(30, 0));
    EXPECT_TRUE(linePieces({}, 1.0).empty());
    EXPECT_TRUE(linePieces({kGap}, 1.0).empty());
}

TEST(PlotThinning, JoinsTheLongPiecesOfALine) {
    std::vector<QPointF> line;
    for (int i = 0; i < 1000; ++i) line.emplace_back(2.0 * i, i % 7);
    const auto pieces = linePieces(line, 1.0);
    EXPECT_GT(pieces.size(), 5U);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        EXPECT_EQ(pieces[i].front(), pieces[i - 1].back());
    }
    EXPECT_EQ(pieces.back().back(), line.back());
}

TEST(PlotThinning, LeavesOutWhatIsNearerThanAPixelButTheEnd) {
    std::vector<QPointF> line;
    for (int i = 0; i <= 1000; ++i) line.emplace_back(0.01 * i, 0.0);
    const auto pieces = linePieces(line, 1.0);
    EXPECT_LE(size(pieces), 12);
    EXPECT_EQ(pieces.back().back(), QPointF(10.0, 0.0));
}

TEST(PlotThinning, DrawsManySamplesAsARibbonOfColumns) {
    const std::vector<QPointF> line = noise(100'000);
    ASSERT_TRUE(goesRight(line));
    const auto pieces = ribbonPieces(line, line, 1.0);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_LE(pieces.front().size(), 1202);
    const QRectF bounds = pieces.front().boundingRect();
    EXPECT_NEAR(bounds.top(), 9.0, 0.1) << "no peak is lost";
    EXPECT_NEAR(bounds.bottom(), 391.0, 0.1);
}

TEST(PlotThinning, FillsBetweenTheEdgesOfABand) {
    const auto pieces = ribbonPieces({{0, 10}, {50, 12}, kGap, {80, 9}, {90, 9}},
                                     {{0, 2}, {50, 4}, {60, 4}, {80, 3}, {90, 3}}, 0.0);
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0], QPolygonF({{0, 2}, {50, 4}, {50, 12}, {0, 10}}));
}

TEST(PlotThinning, SeesWhetherALineGoesBack) {
    EXPECT_TRUE(goesRight({{0, 0}, {0, 5}, kGap, {1, 2}}));
    EXPECT_FALSE(goesRight({{0, 0}, {2, 5}, {1, 2}}));
    EXPECT_TRUE(goesRight({}));
}

}  // namespace
}  // namespace hedr
