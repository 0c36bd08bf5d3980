#include "core/calibration/history/calibration_record.h"

#include <gtest/gtest.h>

#include "tests/core/calibration/history/history_examples.h"

namespace hedr {
namespace {

using test::fullRecord;

TEST(CalibrationRecord, ComesBackFromItsTextToTheLastBit) {
    const auto again = parseRecord(formatRecord(fullRecord()), "r");
    ASSERT_TRUE(again) << again.error().detail;
    EXPECT_EQ(*again, fullRecord());
    const CalibrationRecord empty{.procedure = "allan", .time_utc = "now", .robot = "r"};
    EXPECT_EQ(parseRecord(formatRecord(empty), "r").value(), empty);
}

TEST(CalibrationRecord, IsRefusedWithTheLineThatIsWrong) {
    std::string text = formatRecord(fullRecord());
    text.replace(text.find("\"accepted\""), 10, "\"splendid\"");
    const auto read = parseRecord(text, "r.toml");
    ASSERT_FALSE(read);
    EXPECT_TRUE(read.error().subject.starts_with("r.toml:")) << read.error().subject;
    EXPECT_NE(read.error().detail.find("verdict"), std::string::npos);
    EXPECT_FALSE(parseRecord("format = 1\n", "r.toml"));
    EXPECT_FALSE(parseRecord(formatRecord(fullRecord()) + "more = 1\n", "r.toml"));
}

TEST(CalibrationRecord, IsRefusedWhereWhatWasToldCannotHaveBeenTold) {
    for (const auto& [right, wrong] : {std::pair{"run = 7", "run = 0"},
                                       {"direction = \"clockwise\"", "direction = \"left\""},
                                       {"on_before_s = 60.0", "on_before_s = -1.0"},
                                       {"lopsided = 0.125", "lopsided = 1.5"},
                                       {"rate_rad_s = 0.8", "rate = 0.8"}}) {
        std::string text = formatRecord(fullRecord());
        const std::size_t at = text.find(right);
        ASSERT_NE(at, std::string::npos) << right;
        text.replace(at, std::string_view(right).size(), wrong);
        EXPECT_FALSE(parseRecord(text, "r.toml")) << wrong;
    }
}

}  // namespace
}  // namespace hedr
