#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/fusion/tracker.h"
#include "core/track/track.h"
#include "radio/link/link_health.h"
#include "radio/wire/robot_speech.h"

namespace hedr {

// The name of the track of the robot's own pose.
inline constexpr const char* kRobotTrack = "robot";

struct NamedPoints {
    std::string name;  // an estimator's, or kRobotTrack
    std::vector<TrackPoint> points;
};

// How the heading of one track is checked against the building.
struct NamedStatus {
    std::string name;
    HedrStatus status{};
};

// What the sensors said, its time on the continuous scale of Motion::t_s. After a restart of the
// robot, which the next number of `boot` tells, counters and angle begin anew.
struct HeardSensors {
    std::uint64_t boot = 0;
    SensorReport report{};
};

// From bytes to estimates: the one engine behind the live map and a mission computed again. It sees
// nothing but bytes, so the same bytes give the same tracks, however they were cut.
class Receiver {
  public:
    struct Setup {
        std::optional<Vehicle> vehicle{};     // none: as the robot's hello says
        std::optional<Pose<World>> start{};   // none: where the robot says it is
        std::vector<std::string> settings{};  // KEY=VALUE of estimators.h, checked by the caller
        FrameVerifier verifier{};             // without a key: unsigned frames are believed
        bool keeps_sensors = false;           // for takeSensors()
    };

    explicit Receiver(Setup setup);

    void feed(std::span<const std::uint8_t> bytes);
    // The heading of one corridor in the world; none: to be learnt. A setting of direction_deg
    // overrules it.
    void setDirection(std::optional<double> direction_rad);
    std::optional<double> direction_rad() const { return direction_rad_; }
    // Bytes that follow do not continue those before.
    void portOpened();

    // The points since the last call; one entry per track that has any.
    std::vector<NamedPoints> takePoints();

    // What the sensors said since the last call, where that is kept: what calibration looks at.
    std::vector<HeardSensors> takeSensors() { return std::exchange(sensors_, {}); }
    void keepSensors(bool keep) {
        setup_.keeps_sensors = keep;
        sensors_.clear();
    }

    // Since the last call: what answers a request, and events.
    std::vector<Report> takeAnswers() { return std::exchange(answers_, {}); }

    // Which frames are believed; what it rejected since the last call.
    FrameVerifier& verifier() { return speech_.verifier(); }
    const FrameVerifier& verifier() const { return speech_.verifier(); }
    std::vector<RejectedFrame> takeRejected() { return speech_.takeRejected(); }

    RobotLanguage language() const { return speech_.language(); }
    double clockPeriod_s() const { return speech_.clockPeriod_s(); }
    // Of the last sensors or pose.
    const std::optional<double>& robotTime_s() const { return robot_time_s_; }
    // Why text that looks like a robot's is not understood; empty where there is nothing to say.
    const std::string& refusal() const { return speech_.refusal(); }
    // Whether the robot says that it obeys requests.
    bool listens() const { return hello_ && (hello_->capabilities & kCapabilityRequests) != 0; }
    // A request in the robot's language; empty where that has no words for it.
    std::vector<std::uint8_t> spoken(const Request& request) { return speech_.spoken(request); }
    LinkHealth health() const;
    std::uint64_t believedFrames() const { return speech_.believedFrames(); }
    bool makesSense() const { return speech_.makesSense(); }
    bool namesMissing() const { return speech_.namesMissing(); }
    // Reports so far that say how the robot moves.
    struct MotionCount {
        std::uint64_t sensors = 0;
        std::uint64_t poses = 0;
        friend bool operator==(const MotionCount&, const MotionCount&) = default;
    };
    const MotionCount& motionCount() const { return motion_count_; }
    // What asks the robot to say more often how it moves; none where its language has no words
    // for that.
    std::vector<std::vector<std::uint8_t>> wishesSpoken() { return speech_.wishesSpoken(); }
    // Of the tracks that check their heading against the building: hedr, hedr_bayes, the robot's.
    std::vector<NamedStatus> statuses() const;
    double speed_m_s() const { return speed_m_s_; }
    double driven_m() const { return tracker_ ? tracker_->driven_m() : 0.0; }
    bool standing() const { return tracker_ && tracker_->motion().standing; }
    const std::optional<HelloReport>& robot() const { return hello_; }
    const std::optional<StatusReport>& status() const { return status_; }
    const std::optional<Vehicle>& vehicle() const { return vehicle_; }  // that is in use
    const EstimatorInputs& inputs() const { return inputs_; }  // what robot and vehicle give
    // What is taken for the robot's wheels where nobody has said how they are made and the tracks
    // depend on it, in plain English; empty otherwise.
    std::string assumedWheels() const;

  private:
    void take(const Report& report);
    void take(const HelloReport& hello);
    void take(const PoseReport& pose);
    void take(const SensorReport& sensors);
    void take(const StatusReport& status) { status_ = status; }
    void keep(const SensorReport& sensors);
    void take(const EventReport& event);
    void take(const ParameterReport& parameter) { answers_.emplace_back(parameter); }
    void take(const AcknowledgeReport& acknowledge) { answers_.emplace_back(acknowledge); }
    void take(const TimeEchoReport& echo) { answers_.emplace_back(echo); }

    bool ready() const;
    bool goesOn(double robot_time_s);
    void noteInputs(const SensorReport& sensors);
    void begin();
    void restartRobot();
    void followSpeed();
    void followLegs();
    HedrStatus bayesStatus(const BayesStatus& bayes) const;
    HedrStatus robotStatus() const;

    Setup setup_;
    RobotSpeech speech_;
    std::uint64_t robot_restarts_ = 0;
    std::uint64_t reconnects_ = 0;
    std::vector<Report> answers_;
    std::vector<HeardSensors> sensors_;

    std::optional<HelloReport> hello_{};
    std::optional<StatusReport> status_{};
    std::optional<PoseReport> robot_pose_{};
    std::optional<Vehicle> vehicle_{};
    EstimatorInputs inputs_{};
    std::optional<double> direction_rad_{};
    std::optional<Tracker> tracker_{};
    std::optional<double> robot_time_s_{};
    std::uint64_t restarts_at_hello_ = 0;
    std::optional<double> doubtful_since_s_{};  // robot time: it may have been restarted before
    bool boot_told_ = false;                    // by a hello since then
    bool travel_known_ = false;
    bool counts_ticks_ = false;
    bool tells_wheels_apart_ = false;
    MotionCount motion_count_{};
    int sensors_before_ = 0;  // the estimators began
    double speed_m_s_ = 0.0;
    double bayes_idle_s_ = 0.0;  // since hedr_bayes last drove along a corridor

    // The robot's own pose starts again at zero with the robot; the trail must not.
    struct Anchor {
        Pose<World> reported{};
        Pose<World> shown{};
        std::uint64_t restarts = 0;  // of the tracker by then
    };
    std::optional<Anchor> anchor_{};
    std::optional<TrackPoint> last_robot_point_{};
    double robot_active_t_s_ = 0.0;  // when its HEDR was last active

    std::vector<NamedPoints> points_;
    std::vector<TrackPoint> robot_points_;
};

}  // namespace hedr
