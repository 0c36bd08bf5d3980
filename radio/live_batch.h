#pragma once

#include <QMetaType>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "core/fusion/estimate.h"
#include "core/mission/link_sample.h"
#include "core/result.h"
#include "core/site/site.h"
#include "radio/link/link_health.h"
#include "radio/link/requests.h"
#include "radio/receive_clock.h"
#include "radio/receiver.h"
#include "radio/recorder.h"
#include "radio/source/link_address.h"
#include "radio/wire/signing/frame_verifier.h"

namespace hedr {

enum class PortState : unsigned char { kClosed, kOpen, kGone };

// From when on the robot was on a floor: for the points of every track after that robot time.
struct FloorChange {
    std::string floor;  // its name
    double t_s = 0.0;
    friend bool operator==(const FloorChange&, const FloorChange&) = default;
};

// What crosses from the radio thread to the GUI thread, by value, at most once a frame.
struct LiveBatch {
    PortState port = PortState::kClosed;
    std::optional<Error> port_error{};
    std::vector<NamedPoints> tracks;      // only what is new
    std::vector<NamedStatus> statuses{};  // of the tracks that check their heading
    double speed_m_s = 0.0;
    double driven_m = 0.0;
    bool standing = false;
    LinkHealth link{};
    std::vector<LinkSample> link_samples{};   // only what is new
    std::vector<RequestProgress> requests{};  // only what has changed
    std::vector<EventReport> robot_events{};  // only what is new
    std::vector<HeardSensors> sensors{};      // only what is new, and while they are kept
    RobotLanguage language = RobotLanguage::kUnknown;
    std::string refusal{};  // why text that arrives is not understood; empty where it is not so
    SigningCounters signing{};
    bool demands_signing = false;      // unsigned frames are rejected
    std::optional<Error> key_error{};  // a key or its counters that cannot be used
    LinkAddress address{};             // with what was found out about it
    double frames_per_s = 0.0;         // good frames over the last second
    std::optional<ReceiveClock::time_point> mission_begin{};  // of a continued one: its first start
    // Of a continued mission, once, with its tracks. No site where the operator has loaded one.
    std::optional<Site> restored_site{};
    std::vector<FloorChange> restored_floors{};
    // What the operator has to know and can go on with, each once: damage of the mission that goes
    // on or is played, wheels that nobody has described.
    std::vector<Error> warnings{};
    bool wheels_assumed = false;
    std::optional<ReceiveClock::time_point> last_byte{};
    std::optional<ReceiveClock::time_point> last_good{};   // believed frame
    std::optional<ReceiveClock::time_point> last_frame{};  // good one that says how it moves
    std::optional<HelloReport> robot{};
    std::optional<Vehicle> vehicle{};  // that is in use, once sensors are heard
    std::optional<StatusReport> status{};
    RecorderState recorder{};
};

}  // namespace hedr

Q_DECLARE_METATYPE(hedr::LiveBatch)
