#include "core/calibration/squares/umbmark_text.h"

#include "core/calibration/short_number.h"

namespace hedr {

std::string sentenceOf(const LeftOutRun& run) {
    return "Run " + std::to_string(run.number) + ' ' + run.reason + '.';
}

std::string readLength(double length_m) {
    if (length_m >= 1.0) return shortNumber(length_m) + " m";
    if (length_m >= 0.01) return shortNumber(100.0 * length_m) + " cm";
    return shortNumber(1000.0 * length_m) + " mm";
}

std::string runsText(const std::vector<std::size_t>& numbers) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
        if (last < i + 2) last = i;  // "3 and 4" is as short as "3 to 4"
        parts.push_back(std::to_string(numbers[i]) +
                        (last > i ? " to " + std::to_string(numbers[last]) : ""));
        i = last + 1;
    }
    std::string text = numbers.size() == 1 ? "run " : "runs ";
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i > 0) text += i + 1 < parts.size() ? ", " : " and ";
        text += parts[i];
    }
    return text;
}

}  // namespace hedr
