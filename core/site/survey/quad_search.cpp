#include "core/site/survey/quad_search.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"
#include "core/site/survey/quad.h"

namespace hedr {
namespace {

constexpr double kLeastTurn_rad = radFromDeg(40.0);  // from one side to the next
constexpr double kMostTurn_rad = radFromDeg(140.0);
constexpr double kMostOutside = 0.06;  // of a corner beside the photo, in diagonals
constexpr double kLeastArea = 0.06;    // of the photo's
constexpr double kLeastSide = 0.4;     // of a side that is seen
constexpr double kLeastMean = 0.6;
constexpr double kLeastVisible = 0.6;  // of a side that lies in the photo
constexpr double kBeyond = 0.1;        // of a side: where it is looked at for its end
constexpr double kWeightBeyond = 0.6;
constexpr double kWeightShort = 0.6;

using Corners = std::array<Point<Small>, 4>;

struct Side {
    const EdgeSupport* edge;
    double inward_rad;  // the direction of the inside, 0..2 pi, clockwise on the screen
};

std::vector<Side> sidesOf(const std::vector<EdgeSupport>& edges, QuadKind kind) {
    const double sign = kind == QuadKind::kSheet ? 1.0 : -1.0;
    std::vector<Side> sides;
    for (const EdgeSupport& edge : edges) {
        const Vector<Small> inward = sign * edge.line().normal;
        const double angle = std::atan2(inward.y, inward.x);
        sides.push_back({&edge, angle < 0.0 ? angle + 2.0 * kPi : angle});
    }
    std::ranges::sort(sides, {}, &Side::inward_rad);
    return sides;
}

double areaOf(const Corners& c) {
    const Vector<Small> a = c[2] - c[0];
    const Vector<Small> b = c[3] - c[1];
    return 0.5 * std::abs(a.x * b.y - a.y * b.x);
}

class Search {
  public:
    Search(const PhotoTones& tones, QuadKind kind)
        : kind_(kind),
          area_(static_cast<double>(tones.width_px) * tones.height_px),
          outside_px_(kMostOutside * std::hypot(tones.width_px, tones.height_px)),
          width_px_(tones.width_px),
          height_px_(tones.height_px) {}

    // Sides in the order of their directions, so that each quad is met once.
    std::optional<QuadCandidate> best(const std::vector<Side>& sides) {
        for (std::size_t a = 0; a < sides.size(); ++a) {
            for (std::size_t b = a + 1; b < sides.size(); ++b) {
                const auto ab = corner(sides[a], sides[b]);
                if (!ab) continue;
                for (std::size_t c = b + 1; c < sides.size(); ++c) {
                    const auto bc = corner(sides[b], sides[c]);
                    if (!bc || !isSeen(sides[b], *ab, *bc)) continue;
                    for (std::size_t d = c + 1; d < sides.size(); ++d) {
                        const auto cd = corner(sides[c], sides[d]);
                        if (!cd || !isSeen(sides[c], *bc, *cd)) continue;
                        const auto da = corner(sides[d], sides[a]);
                        if (!da || !isSeen(sides[d], *cd, *da)) continue;
                        if (!isSeen(sides[a], *da, *ab)) continue;
                        consider({&sides[a], &sides[b], &sides[c], &sides[d]},
                                 {*da, *ab, *bc, *cd});
                    }
                }
            }
        }
        return best_;
    }

  private:
    std::optional<Point<Small>> corner(const Side& before, const Side& after) const {
        const double turn = std::abs(wrapAngle(after.inward_rad - before.inward_rad));
        if (turn < kLeastTurn_rad || turn > kMostTurn_rad) return {};
        const EdgeLine& a = before.edge->line();
        const EdgeLine& b = after.edge->line();
        const double sine = a.normal.x * b.normal.y - a.normal.y * b.normal.x;
        const Point<Small> p{(a.offset * b.normal.y - b.offset * a.normal.y) / sine,
                             (b.offset * a.normal.x - a.offset * b.normal.x) / sine};
        const bool near = p.x > -outside_px_ && p.y > -outside_px_ &&
                          p.x < width_px_ + outside_px_ && p.y < height_px_ + outside_px_;
        return near ? std::optional(p) : std::nullopt;
    }

    double support(const Side& side, Point<Small> from, Point<Small> to) const {
        return kind_ == QuadKind::kSheet ? side.edge->step(from, to) : side.edge->edge(from, to);
    }

    bool isSeen(const Side& side, Point<Small> from, Point<Small> to) const {
        return side.edge->visible_px(from, to) > kLeastVisible * (to - from).length() &&
               support(side, from, to) > kLeastSide;
    }

    // How much of a side is seen, less where it goes on beyond its corners or does not reach them.
    double credit(const Side& side, Point<Small> from, Point<Small> to) const {
        const Vector<Small> on = kBeyond * (to - from);
        const Point<Small> before = from + (-1.0) * on;
        const Point<Small> last = to + (-1.0) * on;
        const double beyond = 0.5 * (support(side, before, from) + support(side, to, to + on));
        const double short_of = 0.5 * (missing(side, from, from + on) + missing(side, last, to));
        return support(side, from, to) * (1.0 - kWeightBeyond * beyond) *
               (1.0 - kWeightShort * short_of);
    }

    double missing(const Side& side, Point<Small> from, Point<Small> to) const {
        return side.edge->visible_px(from, to) < 1.0 ? 0.0 : 1.0 - support(side, from, to);
    }

    void consider(const std::array<const Side*, 4>& sides, const Corners& corners) {
        const double area = areaOf(corners) / area_;
        if (area < kLeastArea) return;
        double product = 1.0;
        for (std::size_t i = 0; i < 4; ++i) {
            product *= credit(*sides[i], corners[i], corners[(i + 1) % 4]);
        }
        const double seen = std::pow(product, 0.25);
        const double rank = product * std::sqrt(area);
        if (seen < kLeastMean || rank <= best_rank_ || !checkQuad(asQuad(corners))) return;
        best_rank_ = rank;
        best_ = QuadCandidate{corners, seen};
    }

    static Quad asQuad(const Corners& corners) {
        Quad quad;
        std::ranges::transform(corners, quad.corners.begin(), [](Point<Small> p) {
            return Point<Plan>{p.x, p.y};
        });
        return quad;
    }

    QuadKind kind_;
    double area_;
    double outside_px_;
    double width_px_;
    double height_px_;
    std::optional<QuadCandidate> best_;
    double best_rank_ = 0.0;
};

}  // namespace

std::optional<QuadCandidate> bestQuad(const PhotoTones& tones,
                                      const std::vector<EdgeSupport>& edges, QuadKind kind) {
    return Search(tones, kind).best(sidesOf(edges, kind));
}

}  // namespace hedr
