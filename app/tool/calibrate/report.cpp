#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/tool/calibrate/verbs.h"
#include "core/calibration/history/calibration_record.h"

namespace hedr::tool {

namespace {

// Of what is said without an error; a value has as many as two digits of its error leave.
constexpr int kDigits = 4;
constexpr int kMostDigits = 12;

// All digits before the point, so long as somebody reads them.
std::string number(double value, int digits = kDigits) {
    constexpr double kReadable = 1e9;
    std::ostringstream text;
    const double size = std::abs(value);
    if (size >= std::pow(10.0, digits) && size < kReadable)
        text << std::fixed << std::setprecision(0) << value;
    else
        text << std::setprecision(digits) << value;
    return text.str();
}

int digitsKnown(double value, double error) {
    if (!(std::abs(error) > 0.0) || !std::isfinite(value) || value == 0.0) return kDigits;
    const double ratio = std::abs(value) / std::abs(error);
    return std::clamp(static_cast<int>(std::floor(std::log10(ratio))) + 3, 2, kMostDigits);
}

std::string words(Verdict verdict) {
    std::string name(nameOf(verdict));
    std::ranges::replace(name, '_', ' ');
    return name;
}

nlohmann::ordered_json jsonNumber(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nullptr;
}

nlohmann::ordered_json jsonInterval(const Interval& interval) {
    return {jsonNumber(interval.low), jsonNumber(interval.high)};
}

nlohmann::ordered_json jsonOf(const FoundParameter& found) {
    return {{"key", found.key},
            {"was", found.was ? jsonNumber(*found.was) : nullptr},
            {"now", jsonNumber(found.now.value)},
            {"standard_error", jsonNumber(found.now.standard_error)},
            {"interval_95", jsonInterval(found.now.interval())},
            {"stays", found.stays},
            {"follows", found.follows}};
}

nlohmann::ordered_json jsonOf(const Proof& proof) {
    return {{"what", proof.what},
            {"unit", proof.unit},
            {"parts", proof.parts},
            {"before", jsonNumber(proof.before)},
            {"after", jsonNumber(proof.after)},
            {"times_better", jsonNumber(proof.times_better)},
            {"times_better_95", jsonInterval(proof.times_better_95)},
            {"times_better_99", jsonInterval(proof.times_better_99)}};
}

void print(const FoundParameter& found, int width) {
    std::cout << std::left << std::setw(width) << found.key << std::right << "  "
              << number(found.now.value, digitsKnown(found.now.value, found.now.margin())) << "  "
              << (found.follows ? "goes with the others" : marginWords(found.now));
    std::cout << (found.was
                      ? (found.stays ? "  stays at " : "  was ") + number(*found.was, kMostDigits)
                      : "  was not known")
              << '\n';
}

void print(const EvidenceFigure& figure, int width) {
    std::cout << std::left << std::setw(width) << figure.name << std::right << "  "
              << number(figure.value);
    if (!figure.unit.empty()) std::cout << ' ' << figure.unit;
    if (figure.interval) {
        std::cout << "  (95 %: " << number(figure.interval->low) << " to "
                  << number(figure.interval->high) << ')';
    }
    std::cout << '\n';
}

void print(const Proof& proof) {
    if (proof.parts == 0) return;
    std::cout << "held out: " << proof.what << ", " << proof.parts << " parts: was "
              << number(proof.before) << ", now " << number(proof.after) << ' ' << proof.unit;
    if (proof.parts >= Proof::kFewestParts) {
        const bool better = proof.times_better >= 1.0;
        const auto times = [&](double of) { return number(better ? of : 1.0 / of); };
        const auto& [low, high] = proof.times_better_95;
        std::cout << ": " << times(proof.times_better) << " times " << (better ? "better" : "worse")
                  << " (95 %: " << times(better ? low : high) << " to "
                  << times(better ? high : low) << ')';
    }
    std::cout << '\n';
}

}  // namespace

std::string marginWords(const Estimate& estimate) {
    if (estimate.lopsided == 0.0) return "+- " + number(estimate.margin(), 2) + " (95 %)";
    const Interval interval = estimate.interval();
    return "+" + number(interval.high - estimate.value, 2) + " -" +
           number(estimate.value - interval.low, 2) + " (95 %)";
}

nlohmann::ordered_json toJson(const Calibration& calibration) {
    auto found = nlohmann::ordered_json::array();
    for (const FoundParameter& each : calibration.found) found.push_back(jsonOf(each));
    auto figures = nlohmann::ordered_json::array();
    for (const EvidenceFigure& figure : calibration.figures) {
        figures.push_back(
            {{"name", figure.name},
             {"value", jsonNumber(figure.value)},
             {"unit", figure.unit},
             {"interval_95", figure.interval ? jsonInterval(*figure.interval) : nullptr}});
    }
    return {{"procedure", calibration.procedure},
            {"verdict", nameOf(calibration.verdict)},
            {"reason", calibration.reason},
            {"found", found},
            {"proof", calibration.proof ? jsonOf(*calibration.proof) : nullptr},
            {"figures", figures},
            {"remarks", calibration.remarks}};
}

void printCalibration(const Calibration& calibration) {
    std::size_t width = 0;
    for (const FoundParameter& found : calibration.found) width = std::max(width, found.key.size());
    for (const EvidenceFigure& figure : calibration.figures)
        width = std::max(width, figure.name.size());
    for (const FoundParameter& found : calibration.found) print(found, static_cast<int>(width));
    for (const EvidenceFigure& figure : calibration.figures) print(figure, static_cast<int>(width));
    if (calibration.proof) print(*calibration.proof);
    for (const std::string& remark : calibration.remarks) std::cout << "note: " << remark << '\n';
    std::cout << words(calibration.verdict) << ": " << calibration.reason << '\n';
}

}  // namespace hedr::tool
