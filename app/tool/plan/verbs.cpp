#include "app/tool/plan/verbs.h"

#include <cmath>
#include <iostream>
#include <sstream>

#include "core/geometry/angle.h"
#include "core/site/placement_file.h"
#include "core/site/plan_copy.h"
#include "core/text/number.h"

namespace hedr::tool {

void addImageOptions(CLI::App& app, ImageOptions& image) {
    app.add_option("IMAGE", image.file,
                   "An image, a PDF, SVG or DXF, a plan.toml, or a ROS map .yaml")
        ->required();
    app.add_option("--page", image.choice.page, "Page of a PDF")->check(positiveNumber());
    app.add_option("--paper-scale", image.choice.paper_scale,
                   "N of a PDF or SVG that is drawn 1:N; 100 unless told")
        ->check(positiveNumber());
}

void addJsonFlag(CLI::App& app, bool& json) {
    app.add_flag("--json", json, "One JSON object on standard output");
}

CLI::Option* addTieOption(CLI::App& app, std::string& tie) {
    const CLI::Validator checked(
        [](const std::string& text) {
            const auto parsed = parseTie(text);
            return parsed ? std::string() : complaintAbout(parsed.error());
        },
        "", "tie");
    return app
        .add_option("--tie", tie,
                    "LATITUDE,LONGITUDE,BEARING_DEG: where the world's origin is on the globe, and "
                    "where its y axis points, clockwise from north")
        ->check(checked);
}

std::vector<double> parseNumbers(const std::string& text) {
    std::vector<double> numbers;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        const auto number = parseNumber(word);
        if (!number || !std::isfinite(*number)) return {};
        numbers.push_back(*number);
    }
    return numbers;
}

Result<GeoTie> parseTie(const std::string& text) {
    const std::vector<double> numbers = parseNumbers(text);
    if (numbers.size() == 3 && std::abs(numbers[0]) <= 90.0 && std::abs(numbers[1]) <= 180.0)
        return GeoTie{{}, {numbers[0], numbers[1]}, radFromDeg(numbers[2])};
    return fail(
        ErrorCode::kBadValue, "--tie",
        "is \"" + text + "\", must be LATITUDE,LONGITUDE,BEARING_DEG, for example 48.1,11.5,-12");
}

PlanProgress shownOn(ProgressLine& line) {
    return [&line](double share) {
        line.show(static_cast<std::size_t>(std::lround(100.0 * share)), 100);
        return true;
    };
}

Result<PlanImage> loadPlanWatched(const ImageOptions& image) {
    ProgressLine line("loading");
    return loadPlan(image.file, shownOn(line), {}, image.choice);
}

nlohmann::ordered_json toJson(const PlanPlacement& placement) {
    return {{"resolution_m", placement.resolution_m},
            {"origin_x_m", placement.origin.position.x},
            {"origin_y_m", placement.origin.position.y},
            {"rotation_deg", degFromRad(placement.origin.heading_rad)}};
}

nlohmann::ordered_json toJson(const std::optional<GeoTie>& tie) {
    if (!tie) return nullptr;
    return {{"x_m", tie->point.x},
            {"y_m", tie->point.y},
            {"latitude_deg", tie->at.latitude_deg},
            {"longitude_deg", tie->at.longitude_deg},
            {"bearing_of_y_deg", degFromRad(tie->bearing_of_y_rad)}};
}

void print(const PlanPlacement& placement) {
    const auto& [position, heading_rad] = placement.origin;
    std::cout << "resolution " << placement.resolution_m << " m per pixel\norigin     "
              << position.x << ", " << position.y << " m, the lower left corner\nrotation   "
              << degFromRad(heading_rad) << " deg\n";
}

void print(const GeoTie& tie) {
    const auto digits = std::cout.precision(10);
    std::cout << "geo tie    " << tie.point.x << ", " << tie.point.y << " m is at "
              << tie.at.latitude_deg << ", " << tie.at.longitude_deg;
    std::cout.precision(digits);
    std::cout << ", y points to " << degFromRad(tie.bearing_of_y_rad) << " deg\n";
}

CLI::Validator positiveNumber() {
    return {[](const std::string& text) {
                const auto number = parseNumber(text);
                return number && std::isfinite(*number) && *number > 0.0
                           ? std::string()
                           : "must be a positive number, is " + text;
            },
            "POSITIVE"};
}

Result<void> saveFoundPlace(const PlanImage& plan, const PlanPlacement& found,
                            std::vector<std::filesystem::path> read, const std::string& out) {
    if (out.empty()) return {};
    const auto image = std::filesystem::absolute(plan.image_file);
    read.push_back(image);
    return refuseOverwriting(read, out).and_then([&] {
        return savePlacement({image, found}, out);
    });
}

}  // namespace hedr::tool
