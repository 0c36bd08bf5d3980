// A scenario is a measuring device: figures in the documentation and bounds in tests rest on it. A
// change of what a seed gives must be made on purpose, by changing the numbers below.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>

#include "core/simulation/scenario.h"

namespace hedr {
namespace {

class Fnv {
  public:
    void add(std::int64_t value) {
        for (int byte = 0; byte < 8; ++byte) {
            hash_ = (hash_ ^ (static_cast<std::uint64_t>(value) >> (8 * byte) & 0xffU)) *
                    0x100000001b3U;
        }
    }
    // To a millionth: the last bits of a sine differ between processors.
    void add(double value) { add(static_cast<std::int64_t>(std::llround(1e6 * value))); }
    std::uint64_t value() const { return hash_; }

  private:
    std::uint64_t hash_ = 0xcbf29ce484222325U;
};

// Of every 100th report and pose.
std::uint64_t hashOf(const SimulatedMission& mission) {
    Fnv hash;
    for (std::size_t i = 0; i < mission.sensors.size(); i += 100) {
        const auto& ticks = std::get<WheelTicks>(mission.sensors[i].odometry);
        hash.add(ticks.left);
        hash.add(ticks.right);
        const auto* gyro = std::get_if<GyroRate>(&mission.sensors[i].gyro);
        hash.add(gyro ? gyro->rad_s : 0.0);
        hash.add(mission.sensors[i].magnetic_field.value_or(MagneticField{}).x);
        const Pose<World>& pose = mission.truth[i].pose;
        for (const double value : {pose.position.x, pose.position.y, pose.heading_rad}) {
            hash.add(value);
        }
    }
    return hash.value();
}

struct Reference {
    const char* scenario;
    std::uint64_t hash;
};

void PrintTo(const Reference& reference, std::ostream* out) { *out << reference.scenario; }

class ScenarioReference : public ::testing::TestWithParam<Reference> {};

TEST_P(ScenarioReference, OfSeed7IsWhatItAlwaysWas) {
    const auto scenario = scenarioByName(GetParam().scenario).value();
    const std::uint64_t hash = hashOf(simulate(scenario, 7));
    EXPECT_EQ(hash, GetParam().hash) << std::hex << "0x" << hash;
}

INSTANTIATE_TEST_SUITE_P(All, ScenarioReference,
                         ::testing::Values(Reference{"packbot-corridors", 0x280a16d1ba252b4f},
                                           Reference{"packbot-hall", 0xdd8f4a7a187b6db2},
                                           Reference{"packbot-box", 0xabdc26267783c6c0},
                                           Reference{"packbot-45", 0x38e226c6c0a1ac81},
                                           Reference{"packbot-offset", 0x203fb8ab44c29670},
                                           Reference{"labmate-bumps", 0x1fed2743817cdd6c},
                                           Reference{"gyrostar-warmup", 0xcf0abc2cc0908ed2},
                                           Reference{"romi-rectangle", 0x815de5c52504a72d},
                                           Reference{"umbmark", 0x872e4bcef13b03d9}),
                         [](const auto& each) {
                             std::string name = each.param.scenario;
                             for (char& c : name) c = c == '-' ? '_' : c;
                             return name;
                         });

}  // namespace
}  // namespace hedr
