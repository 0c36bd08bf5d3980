#include "core/text/csv.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <chrono>

#include "core/text/nearest_name.h"
#include "core/text/number.h"

namespace hedr {
namespace {

TEST(CsvReader, CountsBlankLinesInItsLineNumbers) {
    auto csv = CsvReader::open("\na\n\n\n1\n", "file");
    ASSERT_TRUE(csv);
    ASSERT_TRUE(*csv->next());
    EXPECT_EQ(csv->where(), "file:5");
    EXPECT_FALSE(*csv->next());
}

TEST(CsvReader, ReadsALastLineWithoutANewline) {
    auto csv = CsvReader::open("a,b\n1,2", "file");
    ASSERT_TRUE(*csv->next());
    EXPECT_EQ(*csv->number(1), 2.0);
}

TEST(CsvReader, CutsALongFieldInItsMessage) {
    const std::string text = "a\n" + std::string(1000, 'x') + "\n";
    auto csv = CsvReader::open(text, "file");
    ASSERT_TRUE(*csv->next());
    EXPECT_LT(csv->number(0).error().detail.size(), 100U);
}

TEST(CsvReader, SkipsLinesThatBeginWithAHash) {
    auto csv = CsvReader::open("\xEF\xBB\xBF# of Monday\n\na,b\n # 1,2\n3,4\n", "file");
    ASSERT_TRUE(csv);
    EXPECT_EQ(csv->columns().front(), "a");
    ASSERT_TRUE(*csv->next());
    EXPECT_EQ(*csv->number(1), 4.0);
    EXPECT_EQ(csv->where(), "file:5");
    EXPECT_EQ(CsvReader::open("# nothing\n", "file").error().code, ErrorCode::kFileEmpty);
}

std::string headerOf(int columns) {
    std::string header = "c0";
    for (int i = 1; i < columns; ++i) header += ",c" + std::to_string(i);
    return header;
}

TEST(CsvReader, ReadsAHeaderOfAHundredThousandColumnsAtOnce) {
    const std::string header = headerOf(100000);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE(CsvReader::open(header + "\n", "file"));
    const auto twice = CsvReader::open(header + ",c7\n", "file");
    // Comparing each with each takes more than ten seconds.
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(3));
    ASSERT_FALSE(twice);
    EXPECT_EQ(twice.error().detail, "column \"c7\" twice");
}

RC_GTEST_PROP(Number, ReadsBackToTheLastBit, (double value)) {
    std::string text;
    appendNumber(text, value);
    RC_ASSERT(parseNumber(text) == value);
}

RC_GTEST_PROP(Number, KeepsEveryInteger, (std::int64_t value)) {
    std::string text;
    appendNumber(text, value);
    RC_ASSERT(parseInteger(text) == value);
}

TEST(Number, IsTheWholeTextOrNothing) {
    EXPECT_EQ(parseNumber("+1.5"), 1.5);
    for (const char* text : {"", "+", "1.5 ", "1,5", "0x10", "1e999", "12abc"})
        EXPECT_FALSE(parseNumber(text)) << text;
    EXPECT_FALSE(parseInteger("9223372036854775808"));
}

TEST(NearestName, FindsATypingErrorAndNothingElse) {
    constexpr std::array<std::string_view, 3> kKnown = {"gyro", "hedr", "odometry"};
    EXPECT_EQ(nearestName("odometri", kKnown), "odometry");
    EXPECT_EQ(nearestName("hdr", kKnown), "hedr");
    EXPECT_EQ(nearestName("kalman", kKnown), "");
    EXPECT_EQ(nearestName("", kKnown), "");
}

}  // namespace
}  // namespace hedr
