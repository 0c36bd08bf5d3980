#include "radio/receiver.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/text/clean_text.h"

namespace hedr {

namespace {

constexpr int kSensorsToWaitFor = 100;  // a second's worth
constexpr double kSpeedFilter_s = 0.5;
constexpr double kSameBoot_s = 1.5;          // a robot is not restarted and back so soon
constexpr double kPatienceForHello_s = 5.0;  // it comes once a second, if it is not lost

// `pose` as it is when its frame is moved so that `reported` comes to lie on `shown`.
Pose<World> moved(const Pose<World>& pose, const Pose<World>& reported, const Pose<World>& shown) {
    const double turn = shown.heading_rad - reported.heading_rad;
    const double dx = pose.position.x - reported.position.x;
    const double dy = pose.position.y - reported.position.y;
    return {{shown.position.x + std::cos(turn) * dx - std::sin(turn) * dy,
             shown.position.y + std::sin(turn) * dx + std::cos(turn) * dy},
            pose.heading_rad + turn};
}

Vehicle vehicleOf(const HelloReport& hello) {
    Vehicle vehicle;
    vehicle.name = hello.vehicle;
    vehicle.geometry = hello.geometry;
    vehicle.heading_source = hello.heading_source;
    return vehicle;
}

}  // namespace

Receiver::Receiver(Setup setup)
    : setup_(std::move(setup)),
      speech_(setup_.vehicle ? setup_.vehicle->text : std::nullopt, setup_.verifier) {}

void Receiver::feed(std::span<const std::uint8_t> bytes) {
    speech_.feed(bytes, [this](const Report& report) { take(report); });
}

void Receiver::setDirection(std::optional<double> direction_rad) {
    constexpr std::string_view kSetting = "direction_deg=";
    const bool overruled = std::ranges::any_of(
        setup_.settings, [&](const std::string& each) { return each.starts_with(kSetting); });
    if (overruled) return;
    direction_rad_ = direction_rad;
    if (tracker_) tracker_->setDirection(direction_rad_);
}

void Receiver::portOpened() {
    if (speech_.counters().bytes > 0) ++reconnects_;
    speech_.portOpened();
}

void Receiver::take(const Report& report) {
    std::visit([this](const auto& known) { take(known); }, report);
}

void Receiver::take(const HelloReport& hello) {
    const bool other_boot = hello_ && hello_->boot_id != hello.boot_id;
    if (other_boot) restartRobot();
    if (tracker_) restarts_at_hello_ = tracker_->motions().restarts();
    if (doubtful_since_s_) {
        boot_told_ = true;
        if (tracker_ && !other_boot) tracker_->goOnAfterGap();
    }
    hello_ = hello;
    hello_->vehicle = cleanText(hello.vehicle);
    hello_->firmware = cleanText(hello.firmware);
}

void Receiver::take(const EventReport& event) {
    answers_.emplace_back(EventReport{event.robot_time_s, cleanText(event.text)});
}

void Receiver::restartRobot() {
    ++robot_restarts_;
    anchor_.reset();
    // The clock may have told the tracker already.
    if (tracker_ && tracker_->motions().restarts() == restarts_at_hello_) tracker_->restart();
}

// Whether what a robot of protocol 1 says goes on from what it said before. After a while unheard
// it may have been restarted, and its clock and counters may look as if they had gone on: the next
// hello says. As they count all the way nothing is lost until then. A clock that went back is told
// from one that goes on without a hello.
bool Receiver::goesOn(double robot_time_s) {
    if (language() != RobotLanguage::kHedr || !tracker_ || !tracker_->motions().started())
        return true;
    const MotionBuilder& motions = tracker_->motions();
    const double gap_s = motions.continuous(robot_time_s) - motions.time_s();
    if (boot_told_ || gap_s <= kSameBoot_s) {
        doubtful_since_s_.reset();
        return true;
    }
    if (!doubtful_since_s_) doubtful_since_s_ = robot_time_s;
    return std::abs(robot_time_s - *doubtful_since_s_) > kPatienceForHello_s;
}

void Receiver::take(const PoseReport& pose) {
    ++motion_count_.poses;
    robot_pose_ = pose;
    robot_time_s_ = pose.robot_time_s;
    if (!tracker_ || !goesOn(pose.robot_time_s)) return;
    if (anchor_ && anchor_->restarts != tracker_->motions().restarts()) anchor_.reset();
    if (!anchor_) {
        anchor_ =
            Anchor{pose.pose,
                   last_robot_point_ ? last_robot_point_->pose : setup_.start.value_or(pose.pose),
                   tracker_->motions().restarts()};
    }
    const double t_s = tracker_->motions().continuous(pose.robot_time_s);
    if (last_robot_point_ && t_s <= last_robot_point_->t_s) return;
    const bool first = !last_robot_point_;
    last_robot_point_ =
        TrackPoint{t_s, moved(pose.pose, anchor_->reported, anchor_->shown), pose.drift_rad_s};
    if (first || pose.hedr == HedrState::kActive) robot_active_t_s_ = t_s;
    robot_points_.push_back(*last_robot_point_);
}

void Receiver::take(const SensorReport& sensors) {
    robot_time_s_ = sensors.robot_time_s;
    ++motion_count_.sensors;
    if (!hello_) return;
    if (!tracker_) {
        noteInputs(sensors);
        if (!ready()) return;
        begin();
    }
    if (!goesOn(sensors.robot_time_s)) return;
    boot_told_ = false;
    if (!tracker_->add(sensors)) return;
    keep(sensors);
    for (std::size_t i = 0; i < tracker_->size(); ++i) {
        points_[i].points.push_back(tracker_->point(i));
    }
    followSpeed();
    followLegs();
}

void Receiver::keep(const SensorReport& sensors) {
    if (!setup_.keeps_sensors) return;
    const MotionBuilder& motions = tracker_->motions();
    sensors_.push_back({motions.restarts(), sensors});
    sensors_.back().report.robot_time_s = motions.time_s();
}

// A value need not come with every report.
void Receiver::noteInputs(const SensorReport& sensors) {
    ++sensors_before_;
    const bool wheels = !std::holds_alternative<std::monostate>(sensors.odometry);
    travel_known_ = travel_known_ || wheels;
    counts_ticks_ = counts_ticks_ || std::holds_alternative<WheelTicks>(sensors.odometry);
    tells_wheels_apart_ = tells_wheels_apart_ || counts_ticks_ ||
                          std::holds_alternative<WheelTravel>(sensors.odometry);
    inputs_.gyro = inputs_.gyro || !std::holds_alternative<std::monostate>(sensors.gyro);
    inputs_.both_wheels =
        inputs_.both_wheels || (wheels && !std::holds_alternative<PathTravel>(sensors.odometry));
    inputs_.magnetometer = inputs_.magnetometer || sensors.magnetic_field ||
                           (hello_->capabilities & kCapabilityMagnetometer) != 0;
}

// All that it promised has come; a robot that keeps something back is not waited for longer than a
// second.
bool Receiver::ready() const {
    const bool posed = setup_.start || robot_pose_;
    const bool gyro = inputs_.gyro || (hello_->capabilities & kCapabilityGyro) == 0;
    return (posed && gyro && travel_known_) || sensors_before_ > kSensorsToWaitFor;
}

void Receiver::begin() {
    vehicle_ = setup_.vehicle.value_or(vehicleOf(*hello_));
    // The wire's counters, whatever the robot's own are.
    if (language() == RobotLanguage::kHedr) vehicle_->encoder_counter_bits = 32;
    if (!inputs_.gyro) vehicle_->heading_source = HeadingSource::kEncoders;

    FusionConfig config = fusionPreset(*vehicle_);
    for (const std::string& setting : setup_.settings) {
        const auto equals = setting.find('=');
        (void)setFusionValue(config, setting.substr(0, equals), setting.substr(equals + 1));
    }
    const Pose<World> start =
        setup_.start.value_or(robot_pose_ ? robot_pose_->pose : Pose<World>{});
    const EstimatorInputs in_vehicle = inputsOf(*vehicle_);
    inputs_.gyro_drift = in_vehicle.gyro_drift;
    inputs_.magnetometer_range = in_vehicle.magnetometer_range;
    tracker_.emplace(Tracker::Setup{.vehicle = *vehicle_,
                                    .config = config,
                                    .start = start,
                                    .clock_period_s = clockPeriod_s(),
                                    .estimators = estimatorsFor(inputs_)});
    if (direction_rad_) tracker_->setDirection(direction_rad_);
    restarts_at_hello_ = 0;
    for (std::size_t i = 0; i < tracker_->size(); ++i) {
        points_.push_back({std::string(tracker_->name(i)), {}});
    }
}

std::string Receiver::assumedWheels() const {
    const bool told = language() == RobotLanguage::kHedr || setup_.vehicle ||
                      (hello_ && (hello_->capabilities & kCapabilityNoGeometry) == 0);
    if (told || !vehicle_ || !tells_wheels_apart_) return {};
    const VehicleGeometry& geometry = vehicle_->geometry;
    const auto number = [](double value) {
        std::ostringstream text;
        text << value;
        return text.str();
    };
    const std::string base = number(geometry.wheelbase_m) + " m apart";
    if (!counts_ticks_) return "they are taken to be " + base;
    return "they are taken to measure " + number(geometry.left_wheel_diameter_m) + " m, " + base +
           ", with " + number(geometry.ticks_per_revolution) + " counts a turn";
}

void Receiver::followSpeed() {
    const Motion& motion = tracker_->motion();
    const double share = motion.dt_s / (kSpeedFilter_s + motion.dt_s);
    if (motion.dt_s > 0.0) speed_m_s_ += share * (motion.distance_m / motion.dt_s - speed_m_s_);
}

void Receiver::followLegs() {
    const auto bayes = tracker_->bayesStatus();
    if (!bayes) return;
    bayes_idle_s_ =
        bayes->alongCorridor() && !standing() ? 0.0 : bayes_idle_s_ + tracker_->motion().dt_s;
}

std::vector<NamedPoints> Receiver::takePoints() {
    std::vector<NamedPoints> taken;
    for (NamedPoints& track : points_) {
        if (!track.points.empty()) taken.push_back({track.name, std::exchange(track.points, {})});
    }
    if (!robot_points_.empty()) taken.push_back({kRobotTrack, std::exchange(robot_points_, {})});
    return taken;
}

LinkHealth Receiver::health() const {
    const WireCounters counters = speech_.counters();
    return {.bytes = counters.bytes,
            .good_frames = counters.good_frames,
            .bad_frames = counters.bad_frames,
            .lost_frames = counters.lost_frames,
            .late_frames = counters.late_frames,
            .unknown_frames = counters.unknown_frames,
            .restarts = robot_restarts_,
            .reconnects = reconnects_};
}

}  // namespace hedr
