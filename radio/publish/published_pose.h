#pragma once

#include <QString>
#include <chrono>
#include <optional>
#include <string>

#include "core/geometry/frames.h"
#include "core/result.h"
#include "core/site/geo_tie.h"
#include "core/track/track.h"
#include "radio/receive_clock.h"

namespace hedr {

// How far a heading can be trusted, as the window says it.
enum class PublishedTrust : unsigned char { kOff, kGood, kCoasting, kLostLock };

// What other programs are told of one robot.
struct PublishedPose {
    bool chosen = false;  // by the operator: NMEA can tell of one only
    std::string call_sign;
    ReceiveClock::time_point heard{};  // the robot's last good frame: the pose is of then
    Pose<World> pose{};
    PoseVariance variance{};
    double speed_m_s = 0.0;  // negative: backwards
    PublishedTrust trust = PublishedTrust::kOff;
    std::string estimator{};
    std::string floor{};
    std::optional<GeoTie> tie{};  // of the site; none: it is not tied to the globe
};

// One moment, by both clocks: ages are told by the first, moments are named by the second.
struct PublishTime {
    ReceiveClock::time_point now{};
    std::chrono::system_clock::time_point utc{};
};

// Where a pose is on the globe.
struct GlobePose {
    LatLon at{};
    double bearing_deg = 0.0;  // of the robot's front, clockwise from true north, in [0, 360)
    double course_deg = 0.0;   // of its way: the opposite of the bearing while it drives backwards
};

// Every number is one: a pose that is not is told nobody.
bool isFinite(const PublishedPose& pose);

double ageOf(const PublishedPose& pose, const PublishTime& time);  // in seconds
bool isStale(const PublishedPose& pose, const PublishTime& time);  // not true of this moment
// When the pose was true, by the wall clock of this computer.
std::chrono::system_clock::time_point momentOf(const PublishedPose& pose, const PublishTime& time);

// Errors: kNotOnGlobe where the site is not tied to the globe; those of latLonOf.
Result<GlobePose> onGlobe(const PublishedPose& pose);

// Of the position, along its most uncertain direction, in metres; none where the estimator does
// not say.
std::optional<double> sigmaOf(const PublishedPose& pose);

// "good", "coasting", "lost lock", "off".
const char* trustWord(PublishedTrust trust);

// "2026-05-04T09:08:07.250Z"
QString utcText(std::chrono::system_clock::time_point moment);

}  // namespace hedr
