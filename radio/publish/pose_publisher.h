#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "radio/publish/publish_target.h"
#include "radio/publish/published_pose.h"

namespace hedr {

// How one target fares.
struct PublishState {
    PublishTarget target{};
    std::uint16_t port = 0;        // it listens there; 0: it sends, or cannot listen
    std::size_t clients = 0;       // of a target that listens
    std::optional<Error> error{};  // why nothing goes out there; none: nothing is wrong
};

// Tests put their own in.
struct PublishClock {
    std::function<ReceiveClock::time_point()> now = [] { return ReceiveClock::now(); };
    std::function<std::chrono::system_clock::time_point()> utc_now = [] {
        return std::chrono::system_clock::now();
    };
};

// Tells other programs where the robots are. CoT once a second, NMEA five times, JSON ten times,
// however often it is told itself; between that it goes on with what it was told last, whose age
// grows. Lives in one thread and never blocks it.
class PosePublisher : public QObject {
    Q_OBJECT

  public:
    explicit PosePublisher(PublishClock clock = {}, QObject* parent = nullptr);
    ~PosePublisher() override;

    // Instead of those before; one that stays keeps its clients. At first there is none.
    void setTargets(const std::vector<PublishTarget>& targets);
    // Of all robots that are somewhere.
    void setPoses(std::vector<PublishedPose> poses) { poses_ = std::move(poses); }

    std::vector<PublishState> states() const;  // in the order of the targets

  signals:
    void stateChanged();  // targets are not to be changed from within it

  private:
    struct Outlet;
    std::unique_ptr<Outlet> open(const PublishTarget& target);
    void send(Outlet& outlet);
    void noteGlobe(Outlet& outlet);

    PublishClock clock_;
    QByteArray station_;
    std::vector<PublishedPose> poses_;
    std::vector<std::unique_ptr<Outlet>> outlets_;
};

}  // namespace hedr
