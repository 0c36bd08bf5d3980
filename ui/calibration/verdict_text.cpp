#include "ui/calibration/verdict_text.h"

#include <QCoreApplication>

#include "ui/calibration/evidence_units.h"

namespace hedr {
namespace {

QString verdictSentence(const char* text) { return QCoreApplication::translate("Verdict", text); }

bool isProven(const Calibration& calibration) {
    return calibration.proof && calibration.proof->parts >= Proof::kFewestParts;
}

// So many times better; beyond a thousand it is but a large number.
QString timesText(double times, int decimals) {
    constexpr double kMost = 1000.0;
    return times < kMost ? plainNumber(times, decimals)
                         : verdictSentence("more than %1").arg(plainNumber(kMost, 0));
}

QString boundText(double times) {
    return timesText(times, times >= 5.0 ? 0 : times >= 2.0 ? 1 : 2);
}

// By how much, 95 % sure; nobody reads "0.4 times better" as worse.
QString intervalText(const Interval& times_better) {
    const QString low = boundText(times_better.low);
    const QString high = boundText(times_better.high);
    if (times_better.low >= 1.0) return verdictSentence("95 %: %1 to %2 times").arg(low, high);
    const QString worse = boundText(1.0 / times_better.low);
    if (times_better.high > 1.0)
        return verdictSentence("95 %: %1 times worse to %2 times better").arg(worse, high);
    return verdictSentence("95 %: %1 to %2 times worse")
        .arg(boundText(1.0 / times_better.high), worse);
}

// Better or worse by how much; without a proof, only what was decided.
QString wordOf(const Calibration& calibration) {
    const double times = isProven(calibration) ? calibration.proof->times_better : 1.0;
    switch (calibration.verdict) {
        case Verdict::kAccepted:
            return verdictSentence("Better, %1 times").arg(timesText(times, times >= 2.0 ? 1 : 2));
        case Verdict::kUnchanged:
            return verdictSentence("As good as it was");
        case Verdict::kRefused:
            return verdictSentence("Refused");
        case Verdict::kNotProven:
            break;
    }
    return verdictSentence("Not proven");
}

// Too few samples are no good, but that is nothing to be alarmed at while more come in.
bool isTooEarly(const Calibration& calibration) {
    if (calibration.verdict == Verdict::kRefused) return calibration.progress.share < 1.0;
    return calibration.verdict == Verdict::kNotProven && calibration.found.empty();
}

}  // namespace

VerdictText verdictText(const Calibration& calibration) {
    if (isTooEarly(calibration)) {
        return {.word = verdictSentence("No verdict yet"),
                .reason = QString::fromStdString(calibration.reason)};
    }
    VerdictText text{.word = wordOf(calibration),
                     .reason = QString::fromStdString(calibration.reason),
                     .tone = verdictTone(calibration.verdict)};
    if (isProven(calibration)) text.interval = intervalText(calibration.proof->times_better_95);
    return text;
}

QString verdictWord(Verdict verdict) {
    switch (verdict) {
        case Verdict::kAccepted:
            return verdictSentence("accepted");
        case Verdict::kUnchanged:
            return verdictSentence("unchanged");
        case Verdict::kRefused:
            return verdictSentence("refused");
        case Verdict::kNotProven:
            break;
    }
    return verdictSentence("not proven");
}

QString declinedWord() { return verdictSentence("not taken over"); }

Tone verdictTone(Verdict verdict) {
    switch (verdict) {
        case Verdict::kAccepted:
        case Verdict::kUnchanged:
            return Tone::kGood;
        case Verdict::kRefused:
            return Tone::kAlarm;
        case Verdict::kNotProven:
            break;
    }
    return Tone::kWarning;
}

}  // namespace hedr
