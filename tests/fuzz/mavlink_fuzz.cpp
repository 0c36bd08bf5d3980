// Whatever comes over the line, and however it is cut: no crash, the same reports, and a good frame
// behind it is found.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "radio/wire/mavlink/mavlink_codec.h"
#include "radio/wire/mavlink/mavlink_reports.h"

namespace {

using hedr::MavlinkReports;
using hedr::Report;
using Bytes = std::span<const std::uint8_t>;

void demand(bool holds) {
    if (!holds) std::abort();
}

struct Finite {
    void operator()(const hedr::SensorReport& report) const {
        demand(std::isfinite(report.robot_time_s));
        if (const auto* rate = std::get_if<hedr::GyroRate>(&report.gyro)) {
            demand(std::isfinite(rate->rad_s));
        }
        if (const auto* travel = std::get_if<hedr::WheelTravel>(&report.odometry)) {
            demand(std::isfinite(travel->left_m) && std::isfinite(travel->right_m));
        }
        if (report.temperature_c) demand(std::isfinite(*report.temperature_c));
    }
    void operator()(const hedr::PoseReport& report) const {
        demand(std::isfinite(report.robot_time_s) && std::isfinite(report.pose.position.x) &&
               std::isfinite(report.pose.position.y) && std::isfinite(report.pose.heading_rad) &&
               std::isfinite(report.yaw_rate_rad_s));
    }
    template <class Other>
    void operator()(const Other&) const {}
};

struct Listener {
    MavlinkReports reports;
    std::vector<Report> heard;
    void feed(Bytes bytes) {
        reports.feed(bytes, [this](const Report& report) {
            std::visit(Finite{}, report);
            heard.push_back(report);
        });
    }
};

hedr::MavlinkBytes heartbeat() {
    return hedr::encodeMavlink(hedr::MavlinkHeartbeat{}, {.system = 7, .component = 1});
}

// In pieces whose lengths the bytes themselves choose.
void feedInPieces(Listener& listener, Bytes bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t piece = std::min<std::size_t>(1U + bytes[at] % 97U, bytes.size() - at);
        listener.feed(bytes.subspan(at, piece));
        at += piece;
    }
}

// The bytes as frames with the right checksum: an index into the messages known, a length, a
// payload, and so on. So the reports see more than what chance lets through.
std::vector<std::uint8_t> framed(Bytes bytes) {
    std::vector<std::uint8_t> stream;
    const hedr::MavlinkBytes first = heartbeat();
    stream.assign(first.view().begin(), first.view().end());
    while (bytes.size() > 3) {
        const auto& info = hedr::kMavlinkMessages[bytes[0] % hedr::kMavlinkMessages.size()];
        const std::size_t length = std::min<std::size_t>(bytes[1], bytes.size() - 3);
        const hedr::MavlinkBytes frame = hedr::encodeMavlinkFrame(
            {.version = info.id < 256 && (bytes[2] & 1U) != 0 ? 1 : 2,
             .sequence = bytes[2],
             .system = static_cast<std::uint8_t>((bytes[2] & 6U) == 6U ? bytes[2] : 7U),
             .component = static_cast<std::uint8_t>((bytes[2] & 24U) == 24U ? bytes[2] : 1U),
             .message_id = info.id,
             .payload = bytes.subspan(3, length)});
        stream.insert(stream.end(), frame.view().begin(), frame.view().end());
        bytes = bytes.subspan(3 + length);
    }
    return stream;
}

void hear(Bytes bytes) {
    Listener whole;
    whole.feed(bytes);
    Listener cut;
    feedInPieces(cut, bytes);
    demand(whole.heard == cut.heard);
    demand(whole.reports.counters() == cut.reports.counters());
    demand(whole.reports.signedFrames() == cut.reports.signedFrames());

    // A candidate that waits for its end may take the frame only into a frame of its own.
    const std::uint64_t good = whole.reports.counters().good_frames;
    whole.feed(heartbeat().view());
    whole.feed(std::vector<std::uint8_t>(2 * hedr::kMaxMavlinkFrameBytes));
    demand(whole.reports.counters().good_frames > good);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Bytes bytes(data, size);
    hear(bytes);
    hear(framed(bytes));
    return 0;
}
