#include "core/calibration/gyro_samples.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/calibration/median.h"
#include "core/calibration/short_number.h"

namespace hedr {

namespace {

constexpr double kGapPeriods = 3.0;
constexpr double kLongestStep_s = 86400.0;
constexpr double kMostBrokenShare = 0.1;

bool finite(const GyroRate& rate) { return std::isfinite(rate.rad_s); }
template <class Whole>  // microradians, nothing
bool finite(const Whole&) {
    return true;
}

// The rate between two readings of one kind; none where they are of two.
std::optional<double> rateBetween(const Gyro& before, const Gyro& now, double dt_s) {
    if (const auto* rate = std::get_if<GyroRate>(&now)) return rate->rad_s;
    const auto* angle = std::get_if<GyroAngle>(&now);
    const auto* old = std::get_if<GyroAngle>(&before);
    if (!angle || !old) return std::nullopt;
    return 1e-6 * static_cast<double>(static_cast<std::int32_t>(angle->urad - old->urad)) / dt_s;
}

double medianStep_s(const std::vector<GyroSample>& samples) {
    std::vector<double> steps_s;
    steps_s.reserve(samples.size());
    for (const GyroSample& sample : samples) steps_s.push_back(sample.dt_s);
    return medianOf(std::move(steps_s));
}

void countGaps(GyroSamples& result) {
    result.period_s = medianStep_s(result.samples);
    for (const GyroSample& sample : result.samples) {
        if (sample.dt_s <= kGapPeriods * result.period_s) continue;
        ++result.gaps;
        result.longest_gap_s = std::max(result.longest_gap_s, sample.dt_s);
    }
}

}  // namespace

double GyroSamples::mean_rad_s() const {
    double sum = 0.0;
    for (const GyroSample& sample : samples) sum += sample.rate_rad_s;
    return sum / static_cast<double>(samples.size());
}

std::vector<double> GyroSamples::rates_rad_s() const {
    std::vector<double> rates;
    rates.reserve(samples.size());
    for (const GyroSample& sample : samples) rates.push_back(sample.rate_rad_s);
    return rates;
}

std::string complaintAboutBroken(std::size_t good, std::size_t broken) {
    const auto all = static_cast<double>(good + broken);
    if (static_cast<double>(broken) <= kMostBrokenShare * all) return {};
    return std::to_string(broken) + " of " + shortNumber(all, 1) +
           " gyro readings are no numbers, or not later than the one before. Check the gyro, its "
           "wiring, and that nothing sets the robot's clock.";
}

std::vector<SensorReport> withGyroRates(std::vector<SensorReport> reports) {
    std::optional<double> last_time_s;
    Gyro last_gyro;
    for (SensorReport& report : reports) {
        if (!std::holds_alternative<GyroAngle>(report.gyro)) continue;
        const double dt_s = last_time_s ? report.robot_time_s - *last_time_s : 0.0;
        const auto rate = dt_s > 0.0 ? rateBetween(last_gyro, report.gyro, dt_s) : std::nullopt;
        last_time_s = report.robot_time_s;
        last_gyro = std::exchange(report.gyro, rate ? Gyro(GyroRate{*rate}) : Gyro());
    }
    return reports;
}

Result<GyroSamples> gyroSamplesOf(std::span<const SensorReport> reports) {
    GyroSamples result;
    const SensorReport* last = nullptr;
    for (const SensorReport& report : reports) {
        if (std::holds_alternative<std::monostate>(report.gyro)) continue;
        const bool good = std::isfinite(report.robot_time_s) &&
                          std::visit([](const auto& gyro) { return finite(gyro); }, report.gyro);
        const double dt_s = good && last ? report.robot_time_s - last->robot_time_s : 0.0;
        if (!good || (last && (dt_s <= 0.0 || dt_s > kLongestStep_s))) {
            ++result.broken;
            continue;
        }
        if (last) {
            const auto rate = rateBetween(last->gyro, report.gyro, dt_s);
            if (rate) result.samples.push_back({report.robot_time_s, dt_s, *rate});
        }
        last = &report;
    }
    if (result.samples.size() < 2) return fail(ErrorCode::kNoData, "gyro readings");
    countGaps(result);
    return result;
}

}  // namespace hedr
