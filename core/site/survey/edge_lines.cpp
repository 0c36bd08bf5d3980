#include "core/site/survey/edge_lines.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

constexpr double kLeastSlope = 0.018;  // of the tone per pixel
constexpr double kFullSlope = 0.05;    // an edge as steep as that, or steeper, counts in full
constexpr int kAngles = 256;
constexpr int kSpread = 2;  // angle cells to both sides that an edge pixel votes for
constexpr double kCell_px = 2.0;
constexpr double kLeastShare = 0.06;  // of the picture's longer side
constexpr double kFitCosine = 0.985;  // 10 degrees

struct EdgePixel {
    Point<Small> at{};
    Vector<Small> normal{};
    double weight = 0.0;
};

double dot(Vector<Small> a, Vector<Small> b) { return a.x * b.x + a.y * b.y; }

// Pixels where the slope is steepest across the edge.
std::vector<EdgePixel> edgePixels(const PhotoTones& tones) {
    std::vector<EdgePixel> pixels;
    for (int y = 2; y + 2 < tones.height_px; ++y) {
        for (int x = 2; x + 2 < tones.width_px; ++x) {
            const Point<Small> at{x + 0.5, y + 0.5};
            const Vector<Small> slope = tones.slope(at);
            const double steepness = slope.length();
            if (steepness < kLeastSlope) continue;
            const Vector<Small> normal = (1.0 / steepness) * slope;
            if (tones.slope(at + normal).length() > steepness ||
                tones.slope(at + (-1.0) * normal).length() > steepness) {
                continue;
            }
            pixels.push_back({at, normal, std::min(1.0, steepness / kFullSlope)});
        }
    }
    return pixels;
}

// Votes for (angle of the normal, distance from the middle of the picture).
class Ballot {
  public:
    explicit Ballot(const PhotoTones& tones)
        : middle_{0.5 * tones.width_px, 0.5 * tones.height_px},
          offsets_(static_cast<int>(std::hypot(tones.width_px, tones.height_px) / kCell_px) + 3),
          votes_(static_cast<std::size_t>(kAngles * offsets_)) {
        for (std::size_t i = 0; i < kAngles; ++i) {
            const double angle = 2.0 * kPi * static_cast<double>(i) / kAngles;
            normals_[i] = {std::cos(angle), std::sin(angle)};
        }
    }

    void add(const EdgePixel& pixel) {
        const double angle = std::atan2(pixel.normal.y, pixel.normal.x);
        const int nearest = static_cast<int>(std::lround(angle / (2.0 * kPi) * kAngles));
        for (int turn = nearest - kSpread; turn <= nearest + kSpread; ++turn) {
            const double offset = dot(normal(turn), pixel.at - middle_) / kCell_px;
            votes(turn, static_cast<int>(std::lround(offset)) + offsets_ / 2) +=
                static_cast<float>(pixel.weight);
        }
    }

    // Cells with more votes than any other nearby, the most votes first.
    std::vector<EdgeLine> peaks(double least) {
        std::vector<EdgeLine> lines;
        for (int turn = 0; turn < kAngles; ++turn) {
            for (int cell = 2; cell + 2 < offsets_; ++cell) {
                const double count = static_cast<double>(votes(turn, cell));
                if (count < least || !isPeak(turn, cell)) continue;
                const int from_middle = cell - offsets_ / 2;
                const double offset = kCell_px * from_middle;
                const Vector<Small> n = normal(turn);
                lines.push_back({n, offset + dot(n, middle_ - Point<Small>{}), count});
            }
        }
        std::ranges::sort(lines, std::ranges::greater{}, &EdgeLine::weight);
        return lines;
    }

  private:
    static std::size_t wrapped(int turn) {
        return static_cast<std::size_t>(turn + kAngles) % kAngles;
    }
    Vector<Small> normal(int turn) const { return normals_[wrapped(turn)]; }
    float& votes(int turn, int cell) {
        return votes_[wrapped(turn) * static_cast<std::size_t>(offsets_) +
                      static_cast<std::size_t>(cell)];
    }
    bool isPeak(int turn, int cell) {
        const float here = votes(turn, cell);
        for (int i = -2; i <= 2; ++i) {
            for (int k = -2; k <= 2; ++k) {
                const float there = votes(turn + i, cell + k);
                const bool before = i < 0 || (i == 0 && k < 0);
                if (there > here || (there == here && before)) return false;
            }
        }
        return true;
    }

    Point<Small> middle_;
    int offsets_;
    std::vector<float> votes_;
    std::array<Vector<Small>, kAngles> normals_{};
};

// The line through the edge pixels that lie within `reach_px` of it, by total least squares.
std::optional<EdgeLine> fitted(const EdgeLine& line, const std::vector<EdgePixel>& pixels,
                               double reach_px) {
    double weight = 0.0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    for (const EdgePixel& pixel : pixels) {
        const double off = dot(line.normal, pixel.at - Point<Small>{}) - line.offset;
        if (std::abs(off) > reach_px || dot(line.normal, pixel.normal) < kFitCosine) continue;
        const Eigen::Vector2d at(pixel.at.x, pixel.at.y);
        weight += pixel.weight;
        sum += pixel.weight * at;
        squares += pixel.weight * at * at.transpose();
    }
    if (weight < 1.0) return {};
    const Eigen::Vector2d mean = sum / weight;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(squares / weight -
                                                              mean * mean.transpose());
    Eigen::Vector2d normal = axes.eigenvectors().col(0);
    if (normal.dot(Eigen::Vector2d(line.normal.x, line.normal.y)) < 0.0) normal = -normal;
    return EdgeLine{{normal.x(), normal.y()}, normal.dot(mean), weight};
}

bool isSame(const EdgeLine& a, const EdgeLine& b, const PhotoTones& tones) {
    if (dot(a.normal, b.normal) < 0.999) return false;
    const Vector<Small> middle{0.5 * tones.width_px, 0.5 * tones.height_px};
    return std::abs((a.offset - dot(a.normal, middle)) - (b.offset - dot(b.normal, middle))) < 2.0;
}

}  // namespace

std::vector<EdgeLine> edgeLines(const PhotoTones& tones, std::size_t most) {
    const std::vector<EdgePixel> pixels = edgePixels(tones);
    Ballot ballot(tones);
    for (const EdgePixel& pixel : pixels) ballot.add(pixel);
    const double least = kLeastShare * std::max(tones.width_px, tones.height_px);

    std::vector<EdgeLine> lines;
    for (const EdgeLine& peak : ballot.peaks(least)) {
        if (lines.size() == most) break;
        std::optional<EdgeLine> line = peak;
        for (const double reach_px : {4.0, 2.5, 1.5}) {
            if (line) line = fitted(*line, pixels, reach_px);
        }
        if (!line || line->weight < least) continue;
        const auto same = [&](const EdgeLine& other) { return isSame(*line, other, tones); };
        if (std::ranges::none_of(lines, same)) lines.push_back(*line);
    }
    return lines;
}

}  // namespace hedr
