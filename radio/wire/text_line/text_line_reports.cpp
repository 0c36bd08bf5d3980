#include "radio/wire/text_line/text_line_reports.h"

#include <algorithm>
#include <array>

#include "core/text/number.h"
#include "core/text/trimmed.h"
#include "radio/wire/text_line/plain_text.h"

namespace hedr {
namespace {

constexpr int kAgreeingLinesToTrust = 3;
constexpr std::size_t kLongestEvent = 120;  // bytes, as on the wire of hedr_robot.h
constexpr double kClockCounts = 4294967296.0;
constexpr double kMillisecond_s = 1e-3;
constexpr double kMicrosecond_s = 1e-6;
constexpr double kLongestStep_ms = 2000.0;  // more between two lines must be microseconds

constexpr std::array<std::string_view, 12> kPlxDaqCommands = {
    "CLEARDATA",  "CLEARSHEET", "CLEARRANGE", "RESETTIMER",     "CELL",           "ROW",
    "AUTOSCROLL", "BEEP",       "DONE",       "SAVEWORKBOOKAS", "FORCEEXCELQUIT", "CUSTOMBOX1"};

// As printed for a number, if not always a good one: Arduino prints "ovf".
bool looksLikeNumber(std::string_view field) {
    return parseNumber(field).has_value() || isWord(field, "OVF");
}

bool mostlyLetters(std::string_view text) {
    const auto letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
               static_cast<unsigned char>(c) >= 0x80;
    };
    const auto letters = std::count_if(text.begin(), text.end(), letter);
    const auto spaces = std::count(text.begin(), text.end(), ' ');
    return !text.empty() && letter(text.front()) &&
           2 * letters >= static_cast<std::ptrdiff_t>(text.size()) - spaces;
}

// A header that was damaged on the way: the same columns, some not understood.
bool isDamaged(const TextLayout& layout, const TextLayout& whole) {
    if (layout.size != whole.size) return false;
    return std::equal(
        layout.columns.begin(), layout.columns.end(), whole.columns.begin(),
        [](const auto& column, const auto& intact) { return !column || column == intact; });
}

}  // namespace

TextLineReports::TextLineReports(std::optional<TextLineFormat> format)
    : format_(std::move(format).value_or(TextLineFormat{})) {
    const std::size_t read = std::min(format_.columns.size(), kMaxTextColumns);
    if (read > 0) layout_ = layoutOf(std::span<const std::string>(format_.columns).first(read));
}

void TextLineReports::feed(std::span<const std::uint8_t> bytes, const OnReport& on_report) {
    counters_.bytes += bytes.size();
    decoder_.feed(bytes, [&](std::optional<std::string_view> line) { take(line, on_report); });
}

void TextLineReports::portOpened() {
    decoder_.reset();
    nameless_in_a_row_ = 0;
}

void TextLineReports::take(std::optional<std::string_view> line, const OnReport& on_report) {
    if (line && trimmed(*line).empty()) return;
    const Verdict verdict = line ? takeLine(trimmed(*line), on_report) : Verdict::kBad;
    if (!line) ++lines_of_values_;  // most likely
    if (verdict == Verdict::kBad && !confirmed()) agreeing_lines_ = 0;
    if (verdict == Verdict::kBad) nameless_in_a_row_ = 0;
    ++(verdict == Verdict::kGood  ? counters_.good_frames
       : verdict == Verdict::kBad ? counters_.bad_frames
                                  : counters_.unknown_frames);
}

TextLineReports::Verdict TextLineReports::takeLine(std::string_view line,
                                                   const OnReport& on_report) {
    if (line.starts_with('#')) return takeWords(trimmed(line.substr(1)), on_report);
    const auto fields = splitFields(line);
    if (fields) {
        if (const auto verdict = takePlxDaq(*fields, line, on_report)) return *verdict;
        if (std::ranges::any_of(fields->view(), looksLikeNumber)) {
            return takeNumbers(fields->view(), on_report);
        }
    }
    if (const auto pairs = splitPairs(line)) {
        const TextLayout layout = layoutOf(pairs->keys.view());
        const bool known = std::ranges::any_of(layout.columns, [](const auto& c) { return !!c; });
        if (known) return takePairs(*pairs, layout, on_report);
    }
    if (fields) {
        const TextLayout layout = layoutOf(fields->view());
        if (layout.hasMotion() && usable(layout)) return takeHeader(layout);
    }
    if (!mostlyLetters(line)) return Verdict::kBad;
    return takeWords(line, on_report);
}

std::optional<TextLineReports::Verdict> TextLineReports::takePlxDaq(const TextFields& fields,
                                                                    std::string_view line,
                                                                    const OnReport& on_report) {
    const std::string_view word = fields.fields[0];
    const auto rest = fields.view().subspan(1);
    if (isWord(word, "DATA")) return takeNumbers(rest, on_report);
    if (isWord(word, "LABEL")) {
        const TextLayout layout = layoutOf(rest);
        return usable(layout) ? takeHeader(layout) : asKnown();
    }
    if (isWord(word, "MSG") && !rest.empty()) {
        return takeWords(trimmed(line.substr(word.size() + 1)), on_report);
    }
    const auto is_word = [word](std::string_view command) { return isWord(word, command); };
    if (std::ranges::any_of(kPlxDaqCommands, is_word)) return asKnown();
    return std::nullopt;
}

TextLineReports::Verdict TextLineReports::takeHeader(const TextLayout& layout) {
    clock_.expectStart();
    lines_of_values_ = 0;
    const bool named_by_vehicle = !format_.columns.empty();
    const bool same = layout_ && (named_by_vehicle || isDamaged(layout, *layout_));
    if (!same) {
        layout_ = layout;
        agreeing_lines_ = 0;
        time_has_point_ = false;
    }
    return asKnown();
}

TextLineReports::Verdict TextLineReports::takeNumbers(std::span<const std::string_view> fields,
                                                      const OnReport& on_report) {
    ++lines_of_values_;
    if (!layout_) {
        nameless_in_a_row_ = std::min(nameless_in_a_row_ + 1, kNamelessToMiss);
        if (namesMissing() && refusal_.empty()) {
            refusal_ =
                "the lines hold numbers, but no header line named them in words that are known: "
                "let the robot print one when it starts, or list the columns in [text] of the "
                "vehicle file";
        }
        return Verdict::kUnknown;
    }
    const auto sample = readSample(*layout_, fields);
    return sample ? takeSample(*layout_, *sample, on_report) : Verdict::kBad;
}

TextLineReports::Verdict TextLineReports::takePairs(const TextPairs& pairs,
                                                    const TextLayout& layout,
                                                    const OnReport& on_report) {
    if (!usable(layout)) return asKnown();
    ++lines_of_values_;
    const auto sample = readSample(layout, pairs.values.view());
    if (!sample) return Verdict::kBad;
    if (confirmed()) reporter_.learn(layout);
    return takeSample(layout, *sample, on_report);
}

TextLineReports::Verdict TextLineReports::takeWords(std::string_view words,
                                                    const OnReport& on_report) {
    const auto text = plainText(words, kLongestEvent);
    if (!text) return Verdict::kBad;
    if (recognised_ && !text->empty()) on_report(EventReport{clock_.time_s(), *text});
    return asKnown();
}

TextLineReports::Verdict TextLineReports::takeSample(const TextLayout& layout,
                                                     const TextSample& sample,
                                                     const OnReport& on_report) {
    const auto printed = printedTime(sample);
    if (!printed) return Verdict::kBad;
    const bool trusted = confirmed();
    if (!trusted) {
        time_has_point_ = time_has_point_ || sample.time_has_point;
        if (!confirm(layout, *printed)) return Verdict::kGood;
    }
    const double unit_s = secondsPerPrinted(layout, sample);
    const TextColumn* time = layout.find(TextQuantity::kTime);
    const double count_s = time && time->has_unit ? time->scale : unit_s;
    const auto period_s = count_s < 1.0 ? std::optional(count_s * kClockCounts) : std::nullopt;
    const auto step = clock_.advance(*printed * unit_s, period_s);
    if (step == TextClock::Step::kDoubtful) return Verdict::kBad;
    if (step == TextClock::Step::kRestarted) reporter_.restart();
    reporter_.report(sample, clock_.time_s(), on_report);
    if (!trusted) {
        const std::string columns = describe(layout, bare_time_unit_s_);
        on_report(EventReport{clock_.time_s(), columns.substr(0, kLongestEvent)});
    }
    return Verdict::kGood;
}

// Whether lines with such columns can become reports; a missing time is told.
bool TextLineReports::usable(const TextLayout& layout) {
    const bool timed = layout.has(TextQuantity::kTime) || format_.rate_hz;
    if (layout.hasMotion() && !timed && refusal_.empty()) {
        refusal_ =
            "the lines hold no time: let the robot print it, t_ms say, or write rate_hz, the lines "
            "per second, in [text] of the vehicle file";
    }
    return layout.hasMotion() && timed;
}

// True at the line that makes enough of them.
bool TextLineReports::confirm(const TextLayout& layout, double printed_time) {
    const bool goes_on = agreeing_lines_ > 0 && printed_time > last_printed_time_;
    agreeing_lines_ = goes_on ? agreeing_lines_ + 1 : 1;
    const double step = printed_time - last_printed_time_;
    shortest_step_ = agreeing_lines_ > 2 ? std::min(step, shortest_step_) : step;
    last_printed_time_ = printed_time;
    if (!confirmed()) return false;
    bare_time_unit_s_ = time_has_point_                    ? 1.0
                        : shortest_step_ > kLongestStep_ms ? kMicrosecond_s
                                                           : kMillisecond_s;
    recognised_ = true;
    refusal_.clear();
    clock_.expectStart();
    reporter_.learn(layout);
    return true;
}

bool TextLineReports::confirmed() const { return agreeing_lines_ >= kAgreeingLinesToTrust; }

std::optional<double> TextLineReports::printedTime(const TextSample& sample) const {
    if (const auto time = sample[TextQuantity::kTime]) return time;
    if (format_.rate_hz) return static_cast<double>(lines_of_values_) / *format_.rate_hz;
    return std::nullopt;
}

// What one of printedTime() is in seconds.
double TextLineReports::secondsPerPrinted(const TextLayout& layout,
                                          const TextSample& sample) const {
    const TextColumn* time = layout.find(TextQuantity::kTime);
    const bool bare = time && !time->has_unit && sample[TextQuantity::kTime];
    return bare ? bare_time_unit_s_ : 1.0;
}

}  // namespace hedr
