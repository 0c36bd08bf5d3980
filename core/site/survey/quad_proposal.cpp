#include "core/site/survey/quad_proposal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/geometry/angle.h"
#include "core/site/survey/edge_lines.h"
#include "core/site/survey/edge_support.h"
#include "core/site/survey/photo_tones.h"
#include "core/site/survey/quad_search.h"
#include "core/site/survey/rectification.h"

namespace hedr {
namespace {

constexpr int kCoarse_px = 400;  // for sheets: what they lie on may be grainy
constexpr int kFine_px = 800;    // for thin lines
constexpr int kLeastPhoto_px = 64;
constexpr std::size_t kMostLines = 60;
constexpr double kParallel_rad = radFromDeg(0.7);
constexpr double kLeastGain = 0.1;  // of the lines that a rectification makes parallel

Quad onPhoto(const QuadCandidate& candidate, double photo_px_per_px) {
    std::array<Point<Plan>, 4> corners;
    std::ranges::transform(candidate.corners, corners.begin(), [&](Point<Small> p) {
        return Point<Plan>{photo_px_per_px * p.x, photo_px_per_px * p.y};
    });
    return orderedQuad(corners);
}

std::vector<EdgeSupport> supported(const PhotoTones& tones, const std::vector<EdgeLine>& lines) {
    std::vector<EdgeSupport> edges;
    edges.reserve(lines.size());
    for (const EdgeLine& line : lines) edges.emplace_back(tones, line);
    return edges;
}

// The share of the edges that lie along one grid of right angles, the best one, after `map`.
template <class To>
double shareOnGrid(const std::vector<EdgeLine>& lines, const Perspective<To, Small>& map,
                   Point<Small> middle) {
    struct Edge {
        double angle_rad;
        double weight;
    };
    std::vector<Edge> edges;
    double total = 0.0;
    for (const EdgeLine& line : lines) {
        const double off = line.offset - line.normal.x * middle.x - line.normal.y * middle.y;
        const Point<Small> foot = middle + off * line.normal;
        const Vector<Small> direction{-line.normal.y, line.normal.x};
        const Vector<To> way = map * (foot + direction) - map * (foot + (-1.0) * direction);
        edges.push_back({std::atan2(way.y, way.x), line.weight});
        total += line.weight;
    }
    double best = 0.0;
    for (const Edge& grid : edges) {
        double weight = 0.0;
        for (const Edge& edge : edges) {
            const double off = std::remainder(edge.angle_rad - grid.angle_rad, 0.5 * kPi);
            if (std::abs(off) < kParallel_rad) weight += edge.weight;
        }
        best = std::max(best, weight / total);
    }
    return best;
}

// A drawing that is flat as it is has parallel lines already.
bool makesParallel(const PlanLevel& photo, const Quad& quad, const PhotoTones& tones,
                   const std::vector<EdgeLine>& lines) {
    const auto r = rectificationOf(photo.width_px, photo.height_px, quad);
    if (!r) return false;
    const Eigen::Vector3d larger(tones.photo_px_per_px, tones.photo_px_per_px, 1.0);
    const Perspective<Plan, Small> photo_from_small(larger.asDiagonal());
    const Point<Small> middle{0.5 * tones.width_px, 0.5 * tones.height_px};
    return shareOnGrid(lines, r->flat_from_photo * photo_from_small, middle) >
           shareOnGrid(lines, photo_from_small, middle) + kLeastGain;
}

}  // namespace

std::optional<QuadProposal> proposeQuad(const PlanLevel& photo) {
    if (!photo.pixels || std::min(photo.width_px, photo.height_px) < kLeastPhoto_px) return {};
    const PhotoTones coarse = photoTones(photo, kCoarse_px);
    if (const auto sheet =
            bestQuad(coarse, supported(coarse, edgeLines(coarse, kMostLines)), QuadKind::kSheet)) {
        return QuadProposal{onPhoto(*sheet, coarse.photo_px_per_px), QuadKind::kSheet,
                            sheet->support};
    }
    const PhotoTones tones = photoTones(photo, kFine_px);
    const std::vector<EdgeLine> lines = edgeLines(tones, kMostLines);
    const auto drawing = bestQuad(tones, supported(tones, lines), QuadKind::kDrawing);
    if (!drawing) return {};
    const Quad quad = onPhoto(*drawing, tones.photo_px_per_px);
    if (!makesParallel(photo, quad, tones, lines)) return {};
    return QuadProposal{quad, QuadKind::kDrawing, drawing->support};
}

}  // namespace hedr
