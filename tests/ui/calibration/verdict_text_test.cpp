#include "ui/calibration/verdict_text.h"

#include <gtest/gtest.h>

#include "tests/ui/calibration/samples.h"
#include "ui/calibration/verdict_box.h"

namespace hedr {
namespace {

VerdictText textOf(Verdict verdict) { return verdictText(test::decidedView(verdict).calibration); }

TEST(VerdictText, SaysHowManyTimesBetterAndHowSure) {
    const VerdictText text = textOf(Verdict::kAccepted);
    EXPECT_EQ(text.word, "Better, 12.8 times");
    EXPECT_EQ(text.interval, "95 %: 9 to 17 times");
    EXPECT_EQ(text.tone, Tone::kGood);
    EXPECT_FALSE(text.reason.isEmpty());
}

TEST(VerdictText, KeepsTheDecimalsThatDecide) {
    Calibration calibration = test::decidedView(Verdict::kAccepted).calibration;
    calibration.proof->times_better = 1.237;
    calibration.proof->times_better_95 = {1.04, 1.47};
    EXPECT_EQ(verdictText(calibration).word, "Better, 1.24 times");
    EXPECT_EQ(verdictText(calibration).interval, "95 %: 1.04 to 1.47 times");
    calibration.proof->times_better = 1e150;
    calibration.proof->times_better_95 = {2.34, 1e300};
    EXPECT_EQ(verdictText(calibration).word, "Better, more than 1000 times");
    EXPECT_EQ(verdictText(calibration).interval, "95 %: 2.3 to more than 1000 times");
}

TEST(VerdictText, CallsWhatIsWorseWorse) {
    EXPECT_EQ(textOf(Verdict::kRefused).interval, "95 %: 1.10 to 2.5 times worse");
    EXPECT_EQ(textOf(Verdict::kUnchanged).interval, "95 %: 1.03 times worse to 1.04 times better");
}

TEST(VerdictText, TellsEveryVerdictByItsWord) {
    EXPECT_EQ(textOf(Verdict::kRefused).word, "Refused");
    EXPECT_EQ(textOf(Verdict::kRefused).tone, Tone::kAlarm);
    EXPECT_EQ(textOf(Verdict::kNotProven).word, "Not proven");
    EXPECT_EQ(textOf(Verdict::kNotProven).tone, Tone::kWarning);
    EXPECT_EQ(textOf(Verdict::kNotProven).interval, "") << "nothing was held out";
    EXPECT_EQ(textOf(Verdict::kUnchanged).word, "As good as it was");
}

TEST(VerdictText, HasNoneWhileNothingIsFound) {
    EXPECT_EQ(verdictText({}).word, "No verdict yet");
    EXPECT_EQ(verdictText({}).tone, Tone::kDim);
    Calibration refusal = refused({}, "It has not stood for long.");
    EXPECT_EQ(verdictText(refusal).word, "No verdict yet") << "more samples may mend it";
    EXPECT_EQ(verdictText(refusal).reason, "It has not stood for long.");
    refusal.progress.share = 1.0;
    EXPECT_EQ(verdictText(refusal).word, "Refused");
}

TEST(VerdictBox, CanBeReadOnItsGround) {
    for (const Theme& theme : {dayTheme(), nightTheme()}) {
        for (const Tone tone : {Tone::kDim, Tone::kGood, Tone::kWarning, Tone::kAlarm}) {
            const QColor ground = verdictGround(tone, theme);
            EXPECT_GE(contrastRatio(colourOf(tone, theme), ground), 4.5) << static_cast<int>(tone);
            EXPECT_GE(contrastRatio(theme.ink, ground), 7.0) << static_cast<int>(tone);
        }
    }
}

}  // namespace
}  // namespace hedr
