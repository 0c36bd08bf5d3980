#include "core/site/control_points.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <complex>
#include <utility>

namespace hedr {
namespace {

// A similarity of the plane is a complex number: world = factor * plan + offset.
using Complex = std::complex<double>;

constexpr double kFarthest = 1e9;         // metres or pixels; beyond, squares lose their meaning
constexpr double kNearest = 1e-6;         // metres or pixels; nearer points are one
constexpr double kLineShare = 0.02;       // of the spread beside a line to that along it
constexpr double kMirrorRatio = 25.0;     // a mirrored plan fits five times as well
constexpr double kRarely = 0.01;          // chance at which a point is called a blunder
constexpr double kClearOdds = 20.0;       // of the worst point against the next
constexpr double kRoundingShare = 1e-14;  // of the points' spread (not squared)

tl::unexpected<Error> refuse(std::string subject, std::string detail) {
    return fail(ErrorCode::kBadValue, std::move(subject), std::move(detail));
}

// "point 3" or "point 3 (door)".
std::string nameOf(std::span<const ControlPoint> points, std::size_t i) {
    const std::string number = "point " + std::to_string(i + 1);
    return points[i].name.empty() ? number : number + " (" + points[i].name + ')';
}

bool isUsable(const ControlPoint& p) {
    return std::ranges::all_of(std::array{p.plan.x, p.plan.y, p.world.x, p.world.y},
                               [](double v) { return std::abs(v) <= kFarthest; });
}

Result<void> checkPair(std::span<const ControlPoint> points, std::size_t i, std::size_t j) {
    const bool same_plan = points[i].plan == points[j].plan;
    const bool same_world = points[i].world == points[j].world;
    if (!same_plan && !same_world) return {};
    const std::string both = nameOf(points, i) + " and " + nameOf(points, j);
    if (same_plan && same_world) return refuse(both, "they are the same point twice");
    return refuse(both, same_plan ? "they are one place on the plan, but two in the world"
                                  : "they are one place in the world, but two on the plan");
}

Result<void> checkPoints(std::span<const ControlPoint> points) {
    if (points.size() < 2) {
        return refuse("control points", "there must be two at least");
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!isUsable(points[i])) {
            return refuse(nameOf(points, i), "a coordinate is not a number below 1e9");
        }
        for (std::size_t j = 0; j < i; ++j) {
            if (auto checked = checkPair(points, j, i); !checked) return checked;
        }
    }
    return {};
}

Result<void> checkOptions(const FitOptions& options) {
    const auto& resolution = options.fixed_resolution_m;
    if (resolution && !(*resolution > 0.0 && std::isfinite(*resolution))) {
        return refuse("fixed resolution", "it must be a positive number of metres");
    }
    if (options.fixed_heading_rad && !std::isfinite(*options.fixed_heading_rad)) {
        return refuse("fixed heading", "it must be a number");
    }
    return {};
}

// The points about their means, which keeps coordinates of a million metres exact.
struct Centred {
    Complex plan_mean;  // y up, from the lower left corner
    Complex world_mean;
    std::vector<Complex> plan;
    std::vector<Complex> world;
    double plan_square = 0.0;  // sums over the points
    double world_square = 0.0;
    Complex product;           // of conj(plan) and world
    Complex mirrored_product;  // of plan and world
    Complex plan_moment;       // of plan squared; its size says how much like a line they lie

    std::size_t size() const { return plan.size(); }
};

Complex meanOf(const std::vector<Complex>& values) {
    // From the first value, so that the sum does not lose the last digits.
    Complex sum{};
    for (const Complex& value : values) sum += value - values.front();
    return values.front() + sum / static_cast<double>(values.size());
}

Centred centred(std::span<const ControlPoint> points, int plan_height_px) {
    Centred c;
    for (const ControlPoint& p : points) {
        c.plan.emplace_back(p.plan.x, plan_height_px - p.plan.y);
        c.world.emplace_back(p.world.x, p.world.y);
    }
    c.plan_mean = meanOf(c.plan);
    c.world_mean = meanOf(c.world);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Complex u = c.plan[i] -= c.plan_mean;
        const Complex w = c.world[i] -= c.world_mean;
        c.plan_square += std::norm(u);
        c.world_square += std::norm(w);
        c.product += std::conj(u) * w;
        c.mirrored_product += u * w;
        c.plan_moment += u * u;
    }
    return c;
}

// The principal sums of squares are (plan_square ± |plan_moment|) / 2.
bool isOnALine(const Centred& c) {
    const double along = c.plan_square + std::abs(c.plan_moment);
    const double beside = c.plan_square - std::abs(c.plan_moment);
    return beside < kLineShare * kLineShare * along;
}

bool fitsMirroredOnly(const Centred& c) {
    if (c.size() < 3 || isOnALine(c)) return false;
    const double upright = c.world_square - std::norm(c.product) / c.plan_square;
    const double mirrored = c.world_square - std::norm(c.mirrored_product) / c.plan_square;
    return kMirrorRatio * mirrored < upright;
}

Result<Complex> factorOf(const Centred& c, const FitOptions& options) {
    const double resolution = std::abs(c.product) / c.plan_square;
    const double heading = options.fixed_heading_rad.value_or(std::arg(c.product));
    if (c.plan_square < kNearest * kNearest || c.world_square < kNearest * kNearest) {
        return refuse("control points", "they all lie in one place");
    }
    if (!(std::abs(c.product) > 1e-12 * std::sqrt(c.plan_square * c.world_square))) {
        return refuse("control points", "they contradict each other: no placement fits them");
    }
    if (options.fixed_resolution_m) return std::polar(*options.fixed_resolution_m, heading);
    // The turned product's real part is the best scale where the heading is fixed.
    const double share = options.fixed_heading_rad ? std::cos(std::arg(c.product) - heading) : 1.0;
    if (share <= 0.0) {
        return refuse("fixed heading", "the points lie the other way round");
    }
    return std::polar(resolution * share, heading);
}

// How strongly a point determines its own fit, across and along the ray from the mean.
struct Leverage {
    double radial;      // shared with the scale
    double tangential;  // shared with the heading
};

Leverage leverageOf(const Centred& c, std::size_t i, const FitOptions& options) {
    const double mean = 1.0 / static_cast<double>(c.size());
    const double own = std::norm(c.plan[i]) / c.plan_square;
    return {mean + (options.fixed_resolution_m ? 0.0 : own),
            mean + (options.fixed_heading_rad ? 0.0 : own)};
}

// By how much the sum of squares falls if the point is taken away.
double gainOf(const Centred& c, std::size_t i, Complex factor, Complex residual,
              const FitOptions& options) {
    constexpr double kAllItsOwn = 1e-9;  // the point alone fixes a parameter
    const Leverage h = leverageOf(c, i, options);
    const Complex ray = factor * c.plan[i];
    const double length = std::abs(ray);
    const Complex turned = length > 0.0 ? residual * std::conj(ray) / length : residual;
    const auto part = [](double r, double leverage) {
        return 1.0 - leverage > kAllItsOwn ? r * r / (1.0 - leverage) : 0.0;
    };
    return part(turned.real(), h.radial) + part(turned.imag(), h.tangential);
}

int redundancyOf(std::size_t points, const FitOptions& options) {
    return 2 * static_cast<int>(points) - 4 + (options.fixed_resolution_m ? 1 : 0) +
           (options.fixed_heading_rad ? 1 : 0);
}

PlacementSigma sigmaOf(const Centred& c, Complex factor, double variance,
                       const FitOptions& options) {
    const double per_scale = options.fixed_resolution_m ? 0.0 : variance / c.plan_square;
    const double per_turn = options.fixed_heading_rad ? 0.0 : variance / c.plan_square;
    const double mean = variance / static_cast<double>(c.size());
    // The origin follows the mean, the scale along its ray and the heading across it.
    const Complex ray = std::polar(1.0, std::arg(factor)) * c.plan_mean;
    const auto squared = [](double v) { return v * v; };
    return {std::sqrt(per_scale),
            std::sqrt(per_turn) / std::abs(factor),
            {std::sqrt(mean + squared(ray.real()) * per_scale + squared(ray.imag()) * per_turn),
             std::sqrt(mean + squared(ray.imag()) * per_scale + squared(ray.real()) * per_turn)}};
}

// Names the worst point and says what to think of it.
void judge(PlanFit& fit, const Centred& c, Complex factor, const FitOptions& options) {
    const int spare = redundancyOf(c.size(), options) - 2;  // without the suspected point
    if (spare < 1 || c.size() < 3) return;
    std::vector<double> gains;
    double sum = 0.0;
    for (std::size_t i = 0; i < c.size(); ++i) {
        const Complex residual(fit.residuals_m[i].x, fit.residuals_m[i].y);
        sum += std::norm(residual);
        gains.push_back(gainOf(c, i, factor, residual, options));
    }
    const auto worst = std::ranges::max_element(gains);
    fit.worst = static_cast<std::size_t>(worst - gains.begin());
    fit.blunder = Blunder::kNone;
    const double rounding = kRoundingShare * (std::abs(c.world_mean) + std::sqrt(c.world_square));
    if (sum <= rounding * rounding * static_cast<double>(c.size())) return;
    // The tail of Fisher's F with 2 and `spare` degrees of freedom, for one point.
    const auto chance = [&](double gain) {
        return std::pow(std::max(sum - gain, 0.0) / sum, 0.5 * spare);
    };
    const double first = chance(*worst);
    *worst = 0.0;
    const double second = chance(*std::ranges::max_element(gains));
    fit.chance = std::min(1.0, first * static_cast<double>(c.size()));
    if (fit.chance >= kRarely) return;
    fit.blunder = second < kClearOdds * first ? Blunder::kUnclear : Blunder::kProbable;
}

}  // namespace

Result<PlanFit> fitPlacement(std::span<const ControlPoint> points, int plan_height_px,
                             const FitOptions& options) {
    assert(plan_height_px > 0);
    const auto checked = checkPoints(points).and_then([&] { return checkOptions(options); });
    if (!checked) return tl::make_unexpected(checked.error());
    const Centred c = centred(points, plan_height_px);
    if (fitsMirroredOnly(c)) {
        return refuse("control points",
                      "the points fit only a mirrored plan: two of them are swapped, or an axis "
                      "points the other way");
    }
    const auto factor = factorOf(c, options);
    if (!factor) return tl::make_unexpected(factor.error());

    PlanFit fit;
    const Complex origin = c.world_mean - *factor * c.plan_mean;
    const double heading_rad = options.fixed_heading_rad.value_or(std::arg(*factor));
    const double resolution_m = options.fixed_resolution_m.value_or(std::abs(*factor));
    fit.placement = {resolution_m, {{origin.real(), origin.imag()}, heading_rad}};
    double sum = 0.0;
    for (std::size_t i = 0; i < c.size(); ++i) {
        const Complex residual = *factor * c.plan[i] - c.world[i];
        fit.residuals_m.push_back({residual.real(), residual.imag()});
        sum += std::norm(residual);
    }
    fit.rms_m = std::sqrt(sum / static_cast<double>(c.size()));
    fit.all_on_a_line = isOnALine(c);
    const int redundancy = redundancyOf(c.size(), options);
    if (redundancy > 0) fit.sigma = sigmaOf(c, *factor, sum / redundancy, options);
    judge(fit, c, *factor, options);
    return fit;
}

Result<PlanPlacement> fitTwoPointsAndDistance(Point<Plan> a, Point<Plan> b, double distance_m,
                                              int plan_height_px, const PlanPlacement& current) {
    if (!(distance_m > 0.0 && std::isfinite(distance_m))) {
        return refuse("distance", "it must be a positive number of metres");
    }
    const double length_px = (b - a).length();
    if (!(length_px > 0.0 && std::isfinite(length_px))) {
        return refuse("two points", "they must be two places on the plan");
    }
    PlanPlacement placement{distance_m / length_px, current.origin};
    // From the lower left corner to a, in the world: before and after.
    const Complex ray(a.x, plan_height_px - a.y);
    const Complex shift =
        std::polar(current.resolution_m - placement.resolution_m, current.origin.heading_rad) * ray;
    placement.origin.position = current.origin.position + Vector<World>{shift.real(), shift.imag()};
    return placement;
}

}  // namespace hedr
