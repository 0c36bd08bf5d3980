#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include "app/tool/json_line.h"
#include "app/tool/plan/align_by_trail.h"
#include "app/tool/plan/verbs.h"
#include "core/geometry/angle.h"
#include "core/site/control_points_file.h"

namespace hedr::tool {

namespace {

struct Options {
    ImageOptions image;
    std::string points;
    std::string tie;
    std::string out;
    bool keep_scale = false;
    bool keep_rotation = false;
    TrailOptions trail;
    bool json = false;
};

// Control points in the world, with what ties it to the globe where they are given there.
struct Points {
    std::vector<ControlPoint> points;
    std::optional<GeoTie> tie{};
};

// Without a tie the first point is the world's origin, and y points to the north.
Result<Points> inWorld(const std::vector<GeoControlPoint>& given, const std::string& tie_option) {
    Points result;
    result.tie = GeoTie{{}, given.empty() ? LatLon{} : given.front().at, 0.0};
    if (!tie_option.empty()) {
        const auto tie = parseTie(tie_option);
        if (!tie) return tl::make_unexpected(tie.error());
        result.tie = *tie;
    }
    for (const GeoControlPoint& point : given) {
        const auto world = worldPointOf(point.at, *result.tie);
        if (!world) return tl::make_unexpected(world.error());
        result.points.push_back({point.name, point.plan, *world});
    }
    return result;
}

Result<Points> loadPoints(const Options& options) {
    const auto loaded = loadControlPoints(options.points);
    if (!loaded) return tl::make_unexpected(loaded.error());
    if (const auto* metric = std::get_if<std::vector<ControlPoint>>(&*loaded))
        return Points{*metric, std::nullopt};
    return inWorld(std::get<std::vector<GeoControlPoint>>(*loaded), options.tie);
}

std::string nameOf(const std::vector<ControlPoint>& points, std::size_t i) {
    return points[i].name.empty() ? "point " + std::to_string(i + 1) : points[i].name;
}

// One row of a table: how sure one is, for a script and for a reader.
struct BlunderWords {
    Blunder blunder;
    const char* key;
    const char* sentence;
};

constexpr std::array kBlunderWords{
    BlunderWords{Blunder::kCannotTell, "cannot_tell", "too few points to tell whether it is wrong"},
    BlunderWords{Blunder::kNone, "none", "no worse than chance"},
    BlunderWords{Blunder::kUnclear, "unclear", "something is wrong, perhaps this"},
    BlunderWords{Blunder::kProbable, "probable", "probably wrong"},
};

const BlunderWords& wordsOf(Blunder blunder) {
    return *std::ranges::find(kBlunderWords, blunder, &BlunderWords::blunder);
}

nlohmann::ordered_json toJson(const Points& points, const PlanFit& fit) {
    auto residuals = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        residuals.push_back({{"name", nameOf(points.points, i)},
                             {"x_m", fit.residuals_m[i].x},
                             {"y_m", fit.residuals_m[i].y},
                             {"length_m", fit.residuals_m[i].length()}});
    }
    nlohmann::ordered_json object{{"placement", tool::toJson(fit.placement)},
                                  {"rms_m", fit.rms_m},
                                  {"residuals", residuals},
                                  {"worst", nullptr},
                                  {"blunder", wordsOf(fit.blunder).key},
                                  {"all_on_a_line", fit.all_on_a_line},
                                  {"geo_tie", tool::toJson(points.tie)}};
    if (fit.worst) object["worst"] = nameOf(points.points, *fit.worst);
    return object;
}

std::string inCentimetres(double metres) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << 100.0 * metres;
    return text.str();
}

void print(const Points& points, const PlanFit& fit) {
    tool::print(fit.placement);
    if (points.tie) tool::print(*points.tie);
    std::size_t widest = 0;
    for (std::size_t i = 0; i < points.points.size(); ++i)
        widest = std::max(widest, nameOf(points.points, i).size());
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const Vector<World>& off = fit.residuals_m[i];
        std::cout << "residual   " << std::left << std::setw(static_cast<int>(widest))
                  << nameOf(points.points, i) << std::right << std::setw(9)
                  << inCentimetres(off.length()) << " cm  (x " << inCentimetres(off.x) << ", y "
                  << inCentimetres(off.y) << ")\n";
    }
    std::cout << "rms        " << inCentimetres(fit.rms_m) << " cm\n";
    if (fit.worst) {
        std::cout << "worst      " << nameOf(points.points, *fit.worst) << ": "
                  << wordsOf(fit.blunder).sentence << '\n';
    }
    if (fit.all_on_a_line)
        std::cout << "warning    all points are on a line: set one beside it, lest the image be "
                     "mirrored\n";
}

// The complaint is about the points; the fit knows no file.
Error inFile(Error error, const std::string& file) {
    error.detail = error.subject.empty() ? error.detail : error.subject + ": " + error.detail;
    error.subject = file;
    return error;
}

Result<void> alignByPoints(const Options& options) {
    const auto points = loadPoints(options);
    if (!points) return tl::make_unexpected(points.error());
    const auto plan = loadPlanWatched(options.image);
    if (!plan) return tl::make_unexpected(plan.error());
    FitOptions kept;
    if (options.keep_scale) kept.fixed_resolution_m = plan->placement.resolution_m;
    if (options.keep_rotation) kept.fixed_heading_rad = plan->placement.origin.heading_rad;
    const auto fit = fitPlacement(points->points, plan->levels.front().height_px, kept);
    if (!fit) return tl::make_unexpected(inFile(fit.error(), options.points));
    auto saved =
        saveFoundPlace(*plan, fit->placement, {options.image.file, options.points}, options.out);
    if (!saved) return saved;
    if (options.json) {
        std::cout << jsonLine(toJson(*points, *fit));
    } else {
        print(*points, *fit);
    }
    return {};
}

}  // namespace

Job addPlanAlign(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addImageOptions(app, options->image);
    auto* points =
        app.add_option("POINTS.csv", options->points,
                       "Columns plan_x_px, plan_y_px, then world_x_m, world_y_m or latitude_deg, "
                       "longitude_deg, and perhaps name; or a QGIS .points file");
    auto* keep_scale =
        app.add_flag("--keep-scale", options->keep_scale, "Leave the metres per pixel as they are");
    auto* keep_rotation =
        app.add_flag("--keep-rotation", options->keep_rotation, "Leave the rotation as it is");
    app.add_option("--out", options->out, "Where to write the placement, a plan.toml")
        ->check(notEmpty());
    auto* tie = addTieOption(app, options->tie);
    addJsonFlag(app, options->json);
    auto* trail = addTrailOptions(app, options->trail);
    for (CLI::Option* of_points : {points, keep_scale, keep_rotation, tie})
        trail->excludes(of_points);
    app.callback([points, trail] {
        if (points->empty() && trail->empty()) throw CLI::RequiredError("POINTS.csv or --trail");
    });
    return [options] {
        if (options->trail.file.empty()) return alignByPoints(*options);
        return alignByTrail(options->image, options->trail, options->out, options->json);
    };
}

}  // namespace hedr::tool
