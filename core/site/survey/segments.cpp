#include "core/site/survey/segments.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <opencv2/imgproc.hpp>
#include <span>

#include "core/geometry/angle.h"
#include "core/site/survey/ink.h"

namespace hedr {
namespace {

constexpr double kShortest = 0.018;  // of the picture's side
constexpr double kShortest_px = 10.0;
constexpr double kNearly = radFromDeg(2.0);
constexpr std::size_t kMostSegments = 6000;
constexpr double kBeside = 0.025;   // of the picture's side: as near is beside
constexpr int kMostBeside = 6;      // edges; a hollow wall has three beside each
constexpr double kLeastKept = 0.1;  // of the length, else the drawing is hatching all over
constexpr double kAside_px = 2.0;   // segments of one line lie as near to it

bool areBeside(const Segment& a, const Segment& b, double reach_px) {
    if (std::abs(deviationFromGrid(a.angle_rad - b.angle_rad, kPi)) > kNearly) return false;
    const double x = b.middle_x_px - a.middle_x_px;
    const double y = b.middle_y_px - a.middle_y_px;
    const double c = std::cos(a.angle_rad);
    const double s = std::sin(a.angle_rad);
    const double along_px = std::abs(c * x + s * y);
    return along_px < 0.5 * std::max(a.length_px, b.length_px) &&
           std::abs(c * y - s * x) < reach_px;
}

double lengthOf(std::span<const Segment> segments) {
    double sum = 0.0;
    for (const Segment& segment : segments) sum += segment.length_px;
    return sum;
}

// A segment as seen by one who looks along an angle.
struct Piece {
    double along_px = 0.0;
    double aside_px = 0.0;
    double slope = 0.0;
    double length_px = 0.0;
};

std::vector<Piece> piecesAlong(const std::vector<Segment>& segments, double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    std::vector<Piece> pieces;
    for (const Segment& segment : segments) {
        const double off = deviationFromGrid(segment.angle_rad - angle_rad, kPi);
        if (std::abs(off) > kNearly) continue;
        pieces.push_back({c * segment.middle_x_px + s * segment.middle_y_px,
                          c * segment.middle_y_px - s * segment.middle_x_px, off,
                          segment.length_px});
    }
    std::ranges::sort(pieces, {}, &Piece::aside_px);
    return pieces;
}

// The straight line through pieces, by least squares; each one's length is its mass.
Segment lineThrough(std::span<const Piece> pieces, double angle_rad) {
    double mass = 0.0;
    double along = 0.0;
    double aside = 0.0;
    for (const Piece& piece : pieces) {
        mass += piece.length_px;
        along += piece.length_px * piece.along_px;
        aside += piece.length_px * piece.aside_px;
    }
    double square = 0.0;
    double product = 0.0;
    for (const Piece& piece : pieces) {
        const double inner = std::pow(piece.length_px, 3) / 12.0;
        const double off_px = piece.along_px - along / mass;
        square += inner + piece.length_px * off_px * off_px;
        product += inner * piece.slope + piece.length_px * off_px * (piece.aside_px - aside / mass);
    }
    return {angle_rad + std::atan(product / square), std::cbrt(12.0 * square), 0.0, 0.0};
}

void addLines(const std::vector<Segment>& segments, double angle_rad, std::vector<Segment>& lines) {
    const std::vector<Piece> pieces = piecesAlong(segments, angle_rad);
    for (auto first = pieces.begin(); first != pieces.end();) {
        const auto last = std::find_if(first, pieces.end(), [&](const Piece& piece) {
            return piece.aside_px > first->aside_px + kAside_px;
        });
        lines.push_back(lineThrough({first, last}, angle_rad));
        first = last;
    }
}

}  // namespace

std::vector<Segment> segmentsIn(const PlanLevel& picture) {
    std::vector<cv::Vec4f> found;
    cv::createLineSegmentDetector(cv::LSD_REFINE_STD)->detect(greyOf(picture), found);
    const double shortest_px =
        std::max(kShortest_px, kShortest * std::max(picture.width_px, picture.height_px));
    std::vector<Segment> segments;
    for (const cv::Vec4d line : found) {
        const double right = line[2] - line[0];
        const double up = line[1] - line[3];
        const double length_px = std::hypot(right, up);
        if (length_px < shortest_px) continue;
        segments.push_back({std::atan2(up, right), length_px, 0.5 * (line[0] + line[2]),
                            -0.5 * (line[1] + line[3])});
    }
    std::ranges::sort(segments, std::greater(), &Segment::length_px);
    segments.resize(std::min(segments.size(), kMostSegments));
    return segments;
}

std::vector<Segment> withoutHatching(const std::vector<Segment>& segments, double picture_side_px) {
    const double reach_px = kBeside * picture_side_px;
    std::vector<Segment> kept;
    std::ranges::copy_if(segments, std::back_inserter(kept), [&](const Segment& segment) {
        const auto beside = std::ranges::count_if(
            segments, [&](const Segment& other) { return areBeside(segment, other, reach_px); });
        return beside - 1 < kMostBeside;  // it is beside itself
    });
    return lengthOf(kept) >= kLeastKept * lengthOf(segments) ? kept : segments;
}

std::vector<Segment> linesAlong(const std::vector<Segment>& segments, double angle_rad) {
    std::vector<Segment> lines;
    addLines(segments, angle_rad, lines);
    addLines(segments, angle_rad + kPi / 2, lines);
    return lines;
}

}  // namespace hedr
