#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "core/fusion/hedr_bayes.h"
#include "core/robot/motion.h"
#include "core/robot/sensor_csv.h"
#include "core/track/evaluation.h"
#include "core/track/track_file.h"

namespace hedr {
namespace {

struct Recording {
    const char* name;
    double limit_m;  // of the position error's rms
};

void PrintTo(const Recording& recording, std::ostream* out) { *out << recording.name; }

class HedrBayesOnRecordings : public ::testing::TestWithParam<Recording> {
  protected:
    struct Run {
        double ape_rmse_m = 0.0;
        double lost_share = 0.0;  // of the time
    };

    static Run run(const std::filesystem::path& folder) {
        const Vehicle vehicle = loadVehicle(folder / "vehicle.toml").value();
        const SensorLog log = loadSensorLog(folder / "sensors.csv").value();
        HedrBayes filter({}, hedrBayesPreset(vehicle));
        MotionBuilder motions(vehicle);
        std::vector<TrackPoint> track;
        double lost_s = 0.0;
        for (const SensorReport& report : log.reports) {
            const auto motion = motions.add(report);
            if (motion) filter.update(*motion);
            if (motion && filter.status().lost) lost_s += motion->dt_s;
            track.push_back({motions.time_s(), filter.pose()});
        }
        const auto truth = loadTrack(folder / "truth.csv").value();
        return {evaluate(track, truth, Alignment::kStart).value().ape_rmse_m,
                lost_s / (track.back().t_s - track.front().t_s)};
    }
    static std::filesystem::path folderOf(const char* name) {
        return std::filesystem::path(HEDR_SOURCE_DIR) / "../shared/data" / name;
    }
};

TEST_P(HedrBayesOnRecordings, StaysNearTheTruth) {
    const auto folder = folderOf(GetParam().name);
    if (!std::filesystem::exists(folder)) {
        GTEST_SKIP() << "the recording " << GetParam().name << " is not on this machine";
    }
    EXPECT_LE(run(folder).ape_rmse_m, GetParam().limit_m);
}

using HedrBayesOnOpenGround = HedrBayesOnRecordings;

TEST_P(HedrBayesOnOpenGround, SaysThatThereIsNoBuilding) {
    const auto folder = folderOf(GetParam().name);
    if (!std::filesystem::exists(folder)) {
        GTEST_SKIP() << "the recording " << GetParam().name << " is not on this machine";
    }
    const Run drive = run(folder);
    EXPECT_GT(drive.lost_share, 0.5);
    EXPECT_LE(drive.ape_rmse_m, GetParam().limit_m);
}

INSTANTIATE_TEST_SUITE_P(Real, HedrBayesOnOpenGround,
                         ::testing::Values(Recording{"husky_outdoor", 1.05 * 15.272},
                                           Recording{"plaza2_outdoor", 1.05 * 58.591}),
                         [](const auto& each) { return std::string(each.param.name); });

// Those without a target of their own: odometry's error, plus 5 %.
INSTANTIATE_TEST_SUITE_P(
    Real, HedrBayesOnRecordings,
    ::testing::Values(
        Recording{"tuc_corridor", 2.0}, Recording{"wean_1", 0.55},
        Recording{"wean_3", 1.05 * 2.930}, Recording{"wean_4", 1.05 * 0.555},
        Recording{"wean_5", 1.05 * 0.705}, Recording{"intel_lab", 1.05 * 26.437},
        Recording{"tuc_labyrinth", 1.05 * 0.253}, Recording{"maebot_convex", 1.05 * 0.197},
        Recording{"maebot_pentagon", 1.05 * 0.0613}, Recording{"maebot_walls", 1.05 * 0.458},
        Recording{"mbot_square", 1.05 * 0.081}, Recording{"mtrn4010_lab", 1.05 * 8.574},
        Recording{"mines_exp1", 1.05 * 1.614}, Recording{"plaza2_outdoor", 1.05 * 58.591}),
    [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace hedr
