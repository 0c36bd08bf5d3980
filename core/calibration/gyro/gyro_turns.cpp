#include "core/calibration/gyro/gyro_turns.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/calibration/median.h"
#include "core/geometry/angle.h"
#include "core/robot/wheel_motion.h"

namespace hedr {

namespace {

constexpr double kFullTurn_rad = 2.0 * kPi;
constexpr double kBackToMark_rad = radFromDeg(20.0);  // at most
constexpr double kScaleOff = 0.1;                     // at most
constexpr double kMarkOffTurns = 8.0 / 360.0;         // at most, both marks together
constexpr double kSureOfCountTurns = 0.12;
constexpr double kLongestRateGap_s = 0.25;
constexpr double kGapInPeriods = 5.0;
constexpr double kLongestAngleGap_s = 10.0;  // it may have gone round unseen

bool hasRates(std::span<const SensorReport> reports) {
    return std::any_of(reports.begin(), reports.end(), [](const SensorReport& report) {
        return std::holds_alternative<GyroRate>(report.gyro);
    });
}

std::vector<WheelHeading> wheelHeadings(std::span<const SensorReport> reports,
                                        const Vehicle& vehicle) {
    std::vector<WheelHeading> headings;
    Odometry last;
    double heading_rad = 0.0;
    for (const SensorReport& report : reports) {
        if (std::holds_alternative<std::monostate>(report.odometry)) continue;
        const WheelMotion moved = wheelMotionBetween(last, report.odometry, vehicle);
        last = report.odometry;
        const double turn_rad = moved.turn_rad.value_or(0.0);
        if (!std::isfinite(turn_rad) || !std::isfinite(report.robot_time_s)) continue;
        if (moved.turn_rad || headings.empty()) heading_rad += turn_rad;
        if (moved.turn_rad) headings.push_back({report.robot_time_s, heading_rad});
    }
    return headings;
}

// The share of the mean of each stand in what the bias adds up to from `begin_s` to `end_s`.
std::vector<double> biasShares(std::span<const GyroStand> stands, double begin_s, double end_s) {
    std::vector<double> shares_s(stands.size(), 0.0);
    for (std::size_t i = 0; i + 1 < stands.size(); ++i) {
        const double first_s = stands[i].middle_s();
        const double next_s = stands[i + 1].middle_s();
        const double from_s = std::max(begin_s, first_s);
        const double to_s = std::min(end_s, next_s);
        const double way = (0.5 * (from_s + to_s) - first_s) / (next_s - first_s);
        shares_s[i] += (1.0 - way) * (to_s - from_s);
        shares_s[i + 1] += way * (to_s - from_s);
    }
    return shares_s;
}

std::optional<double> wheelTurn(const TurnLog& log, double begin_s, double end_s) {
    const auto at = [&log](double t_s) {
        const auto later =
            std::upper_bound(log.wheels.begin(), log.wheels.end(), t_s,
                             [](double t, const WheelHeading& each) { return t < each.t_s; });
        return later == log.wheels.begin() ? 0.0 : std::prev(later)->heading_rad;
    };
    if (log.wheels.empty()) return std::nullopt;
    return at(end_s) - at(begin_s);
}

GyroTurn turnBetween(const TurnLog& log, std::size_t from, std::size_t to) {
    const std::span stands(log.standing.stands);
    const double begin_s = stands[from].end_s;
    const double end_s = stands[to].begin_s;
    GyroTurn turn{.from = from, .to = to, .duration_s = end_s - begin_s};
    const auto later = [](double t_s, const GyroSample& sample) { return t_s < sample.t_s; };
    auto sample = std::upper_bound(log.samples.begin(), log.samples.end(), begin_s, later);
    for (; sample != log.samples.end() && sample->t_s <= end_s; ++sample) {
        turn.reported_rad += sample->rate_rad_s * sample->dt_s;
        turn.gap_s = std::max(turn.gap_s, sample->dt_s);
    }
    const auto between = stands.subspan(from, to - from + 1);
    turn.bias_share_s = biasShares(between, begin_s, end_s);
    for (std::size_t i = 0; i < between.size(); ++i) {
        turn.reported_rad -= turn.bias_share_s[i] * between[i].mean_rad_s;
    }
    turn.wheels_rad = wheelTurn(log, begin_s, end_s);
    return turn;
}

// The last stand at each place: between places it turned.
std::vector<std::size_t> placesIn(const TurnLog& log, const TurnOptions& options) {
    const std::size_t stands = log.standing.stands.size();
    if (options.closed && stands > 1) return {0, stands - 1};
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < stands; ++i) {
        const bool moved =
            i == 0 || options.gyro_scale * std::abs(turnBetween(log, i - 1, i).reported_rad) >
                          kBackToMark_rad;
        if (moved) {
            places.push_back(i);
        } else {
            places.back() = i;
        }
    }
    return places;
}

bool mayBe(double turned_turns, int whole) {
    const double turns = static_cast<double>(whole);
    return std::abs(turned_turns - turns) <= kScaleOff * turns + kMarkOffTurns;
}

struct Count {
    int fewest = 0;  // 0: no whole number
    int most = 0;
};

// How many turns it may have been, not less than none.
Count countOf(double turned_turns, const TurnOptions& options) {
    Count count;
    constexpr double kMost = 1000.0;
    if (!(turned_turns < kMost)) return count;
    const auto first = static_cast<int>(turned_turns / (1.0 + 2.0 * kScaleOff));
    const auto last = static_cast<int>(turned_turns / (1.0 - 2.0 * kScaleOff)) + 1;
    for (int whole = std::max(1, first); whole <= last; ++whole) {
        const bool told = !options.turns || std::abs(std::abs(*options.turns) - whole) < 0.5;
        if (!told || !mayBe(turned_turns, whole)) continue;
        if (count.fewest == 0) count.fewest = whole;
        count.most = whole;
    }
    return count;
}

// The turns of all logs while they are counted.
class TurnCounting {
  public:
    explicit TurnCounting(const TurnOptions& options) : options_(options) {}

    void addLog(const TurnLog& log, std::size_t index) {
        const auto places = placesIn(log, options_);
        std::size_t from = 0;  // of the pieces that are not whole yet
        for (std::size_t to = 1; to < places.size(); ++to) {
            const GyroTurn alone = turnBetween(log, places[to - 1], places[to]);
            if (isWhole(alone)) {
                if (from + 1 < to) add(turnBetween(log, places[from], places[to - 1]), index);
                add(alone, index);
                from = to;
            } else if (const auto together = turnBetween(log, places[from], places[to]);
                       isWhole(together)) {
                add(together, index);
                from = to;
            }
        }
        if (from + 1 < places.size()) add(turnBetween(log, places[from], places.back()), index);
    }

    TurnsFound result(std::span<const TurnLog> logs) {
        TurnsFound found;
        const std::optional<double> ratio = sureRatio();
        for (GyroTurn& turn : turns_) {
            const Count count = countOf(turnedTurns(turn), options_);
            int whole = count.fewest;
            if (count.most > count.fewest) whole = ratio ? nearestCount(turn, *ratio) : 0;
            found.ambiguous = found.ambiguous || (whole == 0 && count.fewest > 0);
            const bool good = whole > 0 && turn.gap_s <= logs[turn.log].longest_gap_s;
            turn.whole = turn.reported_rad < 0.0 ? -whole : whole;
            (good ? found.whole : found.others).push_back(std::move(turn));
        }
        return found;
    }

  private:
    double turnedTurns(const GyroTurn& turn) const {
        return options_.gyro_scale * std::abs(turn.reported_rad) / kFullTurn_rad;
    }
    bool isWhole(const GyroTurn& turn) const {
        return countOf(turnedTurns(turn), options_).fewest > 0;
    }
    void add(GyroTurn turn, std::size_t log) {
        turn.number = turns_.size() + 1;
        turn.log = log;
        turns_.push_back(std::move(turn));
    }

    // Median of what those turns say of which the number is sure.
    std::optional<double> sureRatio() const {
        std::vector<double> ratios;
        for (const GyroTurn& turn : turns_) {
            const Count count = countOf(turnedTurns(turn), options_);
            if (count.fewest == 0 || count.fewest != count.most) continue;
            ratios.push_back(turnedTurns(turn) / count.fewest);
        }
        if (ratios.empty()) return std::nullopt;
        return medianOf(std::move(ratios));
    }

    int nearestCount(const GyroTurn& turn, double ratio) const {
        const double turns = turnedTurns(turn) / ratio;
        const double whole = std::round(turns);
        return std::abs(turns - whole) < kSureOfCountTurns ? static_cast<int>(whole) : 0;
    }

    TurnOptions options_;
    std::vector<GyroTurn> turns_{};
};

}  // namespace

std::optional<TurnLog> readTurnLog(std::span<const SensorReport> reports, const Vehicle& vehicle) {
    auto gyro = gyroSamplesOf(reports);
    if (!gyro) return std::nullopt;
    TurnLog log{.samples = withoutLoneReadings(std::move(gyro->samples)), .broken = gyro->broken};
    log.longest_gap_s = hasRates(reports)
                            ? std::max(kLongestRateGap_s, kGapInPeriods * gyro->period_s)
                            : kLongestAngleGap_s;
    log.standing = standsIn(log.samples, reports, vehicle);
    log.wheels = wheelHeadings(reports, vehicle);
    return log;
}

TurnsFound turnsIn(std::span<const TurnLog> logs, const TurnOptions& options) {
    TurnCounting counting(options);
    for (std::size_t i = 0; i < logs.size(); ++i) counting.addLog(logs[i], i);
    return counting.result(logs);
}

}  // namespace hedr
