#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/robot/vehicle.h"
#include "radio/wire/reports.h"
#include "radio/wire/text_line/text_clock.h"
#include "radio/wire/text_line/text_fields.h"
#include "radio/wire/text_line/text_layout.h"
#include "radio/wire/text_line/text_line_decoder.h"
#include "radio/wire/text_line/text_reporter.h"

namespace hedr {

// Reports of a robot that prints lines of text: numbers under a header line, PLX-DAQ, "key:value"
// pairs (docs/text_robots.md). It says nothing until three lines in a row agree with the names, so
// that no noise and no boot message is taken for a robot; the first two are not reported.
//
// Robot time is the printed one, with wraps of millis() and micros() at 2^32 joined; it goes back
// where the robot was restarted, and hello's boot_id then grows. Without a printed time it is the
// number of lines, bad ones too, over the vehicle file's rate_hz; without that nothing is
// recognised, and refusal() says so. A printed time without a unit is in seconds where one of the
// first three has a decimal point, in microseconds where they are more than 2000 apart, else in
// milliseconds.
//
// Counters: good are lines that were understood, words after recognition too; bad are those of
// another number of columns, with a value that is no number, out of time, or no text at all;
// unknown are words, headers and nameless numbers before the robot was recognised.
class TextLineReports {
  public:
    // The columns of `format` overrule those of a header line.
    explicit TextLineReports(std::optional<TextLineFormat> format = std::nullopt);

    void feed(std::span<const std::uint8_t> bytes, const OnReport& on_report);
    // Bytes that follow do not continue those before.
    void portOpened();

    const WireCounters& counters() const { return counters_; }
    bool recognised() const { return recognised_; }
    // Why lines that look like a robot's are not recognised, and what to do; empty where there is
    // nothing to say.
    const std::string& refusal() const { return refusal_; }
    // Lines of numbers come whose names were not heard: they may have been said before.
    bool namesMissing() const { return !layout_ && nameless_in_a_row_ >= kNamelessToMiss; }

  private:
    enum class Verdict { kGood, kBad, kUnknown };
    static constexpr int kNamelessToMiss = 3;

    void take(std::optional<std::string_view> line, const OnReport& on_report);
    Verdict takeLine(std::string_view line, const OnReport& on_report);
    std::optional<Verdict> takePlxDaq(const TextFields& fields, std::string_view line,
                                      const OnReport& on_report);
    Verdict takeNumbers(std::span<const std::string_view> fields, const OnReport& on_report);
    Verdict takePairs(const TextPairs& pairs, const TextLayout& layout, const OnReport& on_report);
    Verdict takeHeader(const TextLayout& layout);
    Verdict takeWords(std::string_view words, const OnReport& on_report);
    Verdict takeSample(const TextLayout& layout, const TextSample& sample,
                       const OnReport& on_report);

    bool usable(const TextLayout& layout);
    bool confirm(const TextLayout& layout, double printed_time);
    std::optional<double> printedTime(const TextSample& sample) const;
    double secondsPerPrinted(const TextLayout& layout, const TextSample& sample) const;
    bool confirmed() const;
    Verdict asKnown() const { return recognised_ ? Verdict::kGood : Verdict::kUnknown; }

    TextLineFormat format_;
    TextLineDecoder decoder_;
    TextClock clock_;
    TextReporter reporter_;
    WireCounters counters_;
    bool recognised_ = false;
    std::string refusal_;

    std::optional<TextLayout> layout_{};  // of lines that do not name their values
    int agreeing_lines_ = 0;
    double last_printed_time_ = 0.0;
    double shortest_step_ = 0.0;  // of the printed times
    bool time_has_point_ = false;
    double bare_time_unit_s_ = 1.0;  // of a time without a unit
    std::uint64_t lines_of_values_ = 0;
    int nameless_in_a_row_ = 0;  // lines of numbers since the last one that was none
};

}  // namespace hedr
