#include "radio/live_link.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace hedr {

namespace {

constexpr std::chrono::milliseconds kFramePeriod{16};
constexpr double kRateWindow_s = 1.0;

std::span<const std::uint8_t> asSpan(const QByteArray& bytes) {
    return {reinterpret_cast<const std::uint8_t*>(bytes.constData()),
            static_cast<std::size_t>(bytes.size())};
}

}  // namespace

LiveLink::LiveLink(const Setup& setup, QObject* parent)
    : QObject(parent),
      setup_(setup),
      keys_(setup.keys.empty() ? LinkKeys() : LinkKeys::load(setup.keys)),
      receiver_(
          {.vehicle = setup.vehicle, .start = {}, .settings = {}, .verifier = keys_.verifier()}),
      recorder_(setup.mission, setup.header),
      frame_timer_(this) {
    if (!keys_.refused().empty()) batch_.key_error = keys_.refused().front();
    frame_timer_.setInterval(kFramePeriod);
    frame_timer_.setTimerType(Qt::PreciseTimer);
    connect(&frame_timer_, &QTimer::timeout, this, &LiveLink::handleFrameTime);
}

LiveLink::~LiveLink() {
    if (source_) source_->disconnect(this);
    (void)keys_.close(receiver_.verifier());  // the limit that is kept already is safe, too
    gatherNews();
    recorder_.write();
}

void LiveLink::open(const LinkAddress& address) {
    if (!std::exchange(restored_, true)) restoreMission();
    frame_timer_.start();
    setSource(makeByteSource(address));
    if (const auto* recording = std::get_if<RecordingAddress>(&address)) {
        if (const auto usable = prepareToPlay(recording->file.toStdString()); !usable)
            return handleFailed(usable.error());
    }
    source_->open();
}

void LiveLink::setSource(std::unique_ptr<ByteSource> source) {
    if (source_) source_->disconnect(this);
    source_ = std::move(source);
    connect(source_.get(), &ByteSource::opened, this, &LiveLink::handleOpened);
    connect(source_.get(), &ByteSource::failed, this, &LiveLink::handleFailed);
    connect(source_.get(), &ByteSource::bytesReceived, this, &LiveLink::handleBytes);
}

void LiveLink::close() {
    if (source_) source_->close();
    if (batch_.port == PortState::kOpen) recorder_.addMark(time_s(), StreamKind::kPortLost);
    batch_.port = PortState::kClosed;
    batch_.port_error.reset();
    requests_.cancelAll();
    noteRequests();
    gatherNews();
    recorder_.write();
    sendBatch();
    frame_timer_.stop();
}

void LiveLink::setFramePeriod(std::chrono::milliseconds period) {
    if (frame_timer_.intervalAsDuration() != period) frame_timer_.setInterval(period);
}

void LiveLink::notePlan(const MissionPlan& plan) { recorder_.setPlan(plan); }

void LiveLink::noteSite(const Site& site) {
    site_noted_ = true;
    recorder_.setSite(time_s(), site);
    noteNewNames(site);
    direction_rad_ = site.direction_rad;
    if (batch_.port == PortState::kOpen) tellDirection();
}

// Where the robot was is told by the floors' names.
void LiveLink::noteNewNames(const Site& site) {
    std::vector<std::string> names;
    for (const SiteFloor& floor : site.floors) names.push_back(floor.name);
    for (std::size_t i = 0; i < names.size() && names.size() == floor_names_.size(); ++i) {
        if (names[i] == floor_names_[i]) continue;
        recorder_.addEvent({time_s(), kFloorRenamedEvent, floor_names_[i] + '\n' + names[i]});
    }
    floor_names_ = std::move(names);
}

// To the estimators, and at this place of the stream to those that compute it again.
void LiveLink::tellDirection() {
    if (receiver_.direction_rad() == direction_rad_) return;
    recorder_.addMark(time_s(), StreamKind::kDirection, packDirection(direction_rad_));
    receiver_.setDirection(direction_rad_);
}

void LiveLink::noteFloor(const std::string& name) {
    recorder_.addEvent({time_s(), kFloorEvent, name});
}

void LiveLink::handleOpened() {
    // Another program may take a connection over: what was asked was not asked of it.
    if (batch_.port == PortState::kOpen) requests_.cancelAll();
    noteRequests();
    recorder_.addMark(time_s(), StreamKind::kPortOpened);
    receiver_.portOpened();
    sensor_rate_.startAgain();
    if (site_noted_) tellDirection();
    batch_.port = PortState::kOpen;
    batch_.port_error.reset();
    news_ = true;
}

void LiveLink::handleFailed(const Error& error) {
    if (batch_.port == PortState::kOpen) recorder_.addMark(time_s(), StreamKind::kPortLost);
    batch_.port = PortState::kGone;
    batch_.port_error = error;
    // What was asked now may be wrong when the robot is back: a pose, above all.
    requests_.cancelAll();
    noteRequests();
    news_ = true;
}

void LiveLink::handleBytes(const QByteArray& bytes) {
    recorder_.addBytes(time_s(), asSpan(bytes));
    const std::uint64_t believed_before = receiver_.believedFrames();
    const Receiver::MotionCount motion_before = receiver_.motionCount();
    receiver_.feed(asSpan(bytes));
    noteRejected();
    batch_.last_byte = ReceiveClock::now();
    if (!batch_.mission_begin) batch_.mission_begin = batch_.last_byte;
    if (receiver_.makesSense()) source_->noteUnderstood();
    if (receiver_.namesMissing()) source_->noteNamesMissing();
    // What others send in the robot's name does not make it heard, and a robot that greets but does
    // not say how it moves is nowhere to be seen.
    if (receiver_.believedFrames() > believed_before) {
        batch_.last_good = batch_.last_byte;
        meter_.noteFrames(time_s(), receiver_.robotTime_s());
    }
    if (receiver_.motionCount() != motion_before) {
        noteGap();
        batch_.last_frame = batch_.last_byte;
    }
    noteRestart();
    hearAnswers();
    news_ = true;
}

// Another clock, and none of what was asked before is remembered.
void LiveLink::noteRestart() {
    const std::uint64_t restarts = receiver_.health().restarts;
    if (std::exchange(restarts_, restarts) == restarts) return;
    clock_echo_.forgetAnswers();
    sensor_rate_.startAgain();
}

void LiveLink::noteRejected() {
    for (const RejectedFrame& frame : receiver_.takeRejected())
        recorder_.addRejected({frame.index, static_cast<int>(frame.reason)});
    noteKeys(keys_.keepHeard(receiver_.verifier()));
}

void LiveLink::noteKeys(const Result<void>& kept) {
    batch_.key_error.reset();
    if (!keys_.refused().empty()) batch_.key_error = keys_.refused().front();
    if (!kept) batch_.key_error = kept.error();
}

// So that whoever reads the mission afterwards sees where it was blind, and for how long.
void LiveLink::noteGap() {
    constexpr double kGap_s = 3.0;  // from here on the link was called lost
    if (!batch_.last_frame) return;
    const double silent_s =
        std::chrono::duration<double>(*batch_.last_byte - *batch_.last_frame).count();
    if (silent_s < kGap_s) return;
    const auto tenths = static_cast<long>(std::lround(10.0 * silent_s));
    recorder_.addEvent(
        {time_s(), kGapEvent, std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10)});
}

void LiveLink::hearAnswers() {
    for (const Report& answer : receiver_.takeAnswers()) {
        requests_.hear(answer);
        if (const auto* echo = std::get_if<TimeEchoReport>(&answer))
            clock_echo_.hear(*echo, time_s(), receiver_.clockPeriod_s());
        if (const auto* event = std::get_if<EventReport>(&answer)) {
            recorder_.addEvent({time_s(), kRobotEvent, event->text});
            batch_.robot_events.push_back(*event);
        }
    }
}

void LiveLink::handleFrameTime() {
    countFrameRate();
    watchSensorRate();
    askRobot();
    takeLinkSample();
    gatherNews();
    const bool recorder_failed = recorder_.state().error.has_value();
    recorder_.writeIfDue(time_s());
    if (news_ || recorder_failed != recorder_.state().error.has_value()) sendBatch();
}

void LiveLink::takeLinkSample() {
    if (!batch_.mission_begin) return;
    const auto& status = receiver_.status();
    const auto sample =
        meter_.sampleIfDue(time_s(), receiver_.health(),
                           {.round_trip_s = clock_echo_.roundTrip_s(time_s()),
                            .clock_offset_s = clock_echo_.offset_s(),
                            .radio_dbm = status ? status->radio_dbm : std::nullopt});
    if (!sample) return;
    recorder_.addLinkSample(*sample);
    batch_.link_samples.push_back(*sample);
    news_ = true;
}

// What the bytes so far have given, for the recorder and the GUI.
void LiveLink::gatherNews() {
    const std::vector<NamedPoints> points = receiver_.takePoints();
    for (const NamedPoints& track : points) batch_.tracks.push_back(track);
    recorder_.addEstimates(points);
    if (!vehicle_noted_ && receiver_.vehicle()) {
        vehicle_noted_ = true;
        recorder_.setVehicle(*receiver_.vehicle());
        warnOfAssumedWheels();
    }
}

void LiveLink::warnOfAssumedWheels() {
    const std::string assumed = receiver_.assumedWheels();
    batch_.wheels_assumed = !assumed.empty();
    if (!batch_.wheels_assumed) return;
    batch_.warnings.push_back({ErrorCode::kWheelsUnknown, receiver_.robot()->vehicle, assumed});
    recorder_.addEvent({time_s(), kWarningEvent, kWheelsWarning + assumed});
}

void LiveLink::countFrameRate() {
    const double elapsed_s = time_s() - rate_since_s_;
    if (elapsed_s < kRateWindow_s) return;
    const std::uint64_t frames = receiver_.health().good_frames;
    batch_.frames_per_s = static_cast<double>(frames - rate_frames_) / elapsed_s;
    rate_frames_ = frames;
    rate_since_s_ = time_s();
}

void LiveLink::sendBatch() {
    batch_.statuses = receiver_.statuses();
    batch_.speed_m_s = receiver_.speed_m_s();
    batch_.driven_m = receiver_.driven_m();
    batch_.standing = receiver_.standing();
    batch_.link = receiver_.health();
    batch_.language = receiver_.language();
    batch_.refusal = receiver_.refusal();
    batch_.signing = receiver_.verifier().counters();
    batch_.demands_signing = receiver_.verifier().demandsSigning();
    if (source_) batch_.address = source_->address();
    batch_.robot = receiver_.robot();
    batch_.status = receiver_.status();
    batch_.recorder = recorder_.state();
    batch_.vehicle = receiver_.vehicle();
    batch_.sensors = receiver_.takeSensors();
    emit batchReady(batch_);
    batch_.tracks.clear();
    batch_.link_samples.clear();
    batch_.requests.clear();
    batch_.robot_events.clear();
    batch_.restored_site.reset();
    batch_.restored_floors.clear();
    batch_.warnings.clear();
    news_ = false;
}

double LiveLink::time_s() const {
    return std::chrono::duration<double>(ReceiveClock::now() - begin_).count();
}

}  // namespace hedr
