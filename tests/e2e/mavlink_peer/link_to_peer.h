#pragma once

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QtTest/QTest>
#include <functional>
#include <map>
#include <memory>

#include "core/mission/mission_reader.h"
#include "radio/live_link.h"
#include "radio/recomputation.h"
#include "tests/e2e/gathered_tracks.h"
#include "tests/e2e/mavlink_peer/expected.h"
#include "tests/e2e/mavlink_peer/peer_process.h"

namespace hedr {

// A live link to the peer, and what it tells.
class LinkToMavlinkPeer : public ::testing::Test {
  protected:
    void SetUp() override {
        const std::string missing = noMavlinkPeer();
        if (!missing.empty()) GTEST_SKIP() << missing;
    }

    std::filesystem::path mission() const { return folder_.filePath("m.hedr").toStdString(); }

    void begin(const QStringList& options) {
        peer_ = std::make_unique<MavlinkPeer>(folder_.filePath("robot"), options);
        Vehicle vehicle;
        vehicle.geometry.wheelbase_m = kPeerTrack_m;
        vehicle.gyro_bias_rad_s = 0.0;
        link_ = std::make_unique<LiveLink>(LiveLink::Setup{
            .vehicle = vehicle,
            .mission = mission(),
            .header = {.start = std::chrono::system_clock::now(), .program_version = "test"}});
        QObject::connect(link_.get(), &LiveLink::batchReady,
                         [this](const LiveBatch& batch) { hear(batch); });
        link_->open(SerialAddress{folder_.filePath("robot")});
    }

    bool waitFor(const std::function<bool()>& heard) {
        return QTest::qWaitFor([&] { return heard() || peer_->failed(); }, 20000) &&
               !peer_->failed();
    }

    void end() {
        link_->close();
        link_.reset();
        peer_.reset();
    }

    void hear(const LiveBatch& batch) {
        last_ = batch;
        gather(tracks_, batch);
        for (const EventReport& event : batch.robot_events) words_.push_back(event.text);
        for (const LinkSample& sample : batch.link_samples) samples_.push_back(sample);
        for (const RequestProgress& each : batch.requests) requests_[each.ticket] = each;
    }

    RequestState stateOf(std::uint64_t ticket) { return requests_[ticket].state; }

    void forEachBytes(const std::function<void(const StreamRow&)>& visit) const {
        const auto reader = MissionReader::open(mission());
        ASSERT_TRUE(reader) << reader.error().detail;
        ASSERT_TRUE(reader->forEachStreamRow([&](const StreamRow& row) {
            if (row.kind == StreamKind::kBytes) visit(row);
            return true;
        }));
    }

    void expectTheSameBitsAgain() {
        ASSERT_TRUE(tracks_.contains("hedr") && tracks_.contains(kRobotTrack));
        for (const auto& [name, points] : tracks_) {
            const auto again = recomputeTrack(mission(), name, {});
            ASSERT_TRUE(again) << again.error().detail;
            EXPECT_TRUE(again->as_live) << name;
            EXPECT_EQ(again->points.size(), points.size()) << name;
        }
    }

    QTemporaryDir folder_;
    std::unique_ptr<MavlinkPeer> peer_;
    std::unique_ptr<LiveLink> link_;
    LiveBatch last_;
    GatheredTracks tracks_;
    std::vector<std::string> words_;
    std::vector<LinkSample> samples_;
    std::map<std::uint64_t, RequestProgress> requests_;
};

}  // namespace hedr
