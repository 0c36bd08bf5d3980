#include <array>
#include <cmath>
#include <iostream>
#include <memory>
#include <vector>

#include "app/tool/json_line.h"
#include "app/tool/plan/verbs.h"
#include "core/site/plan_copy.h"
#include "core/site/raster_file.h"
#include "core/site/survey/quad_proposal.h"
#include "core/site/survey/rectification.h"
#include "core/site/survey/sheet_format.h"

namespace hedr::tool {

namespace {

constexpr std::size_t kNumbers = 8;  // of four corners

struct Options {
    ImageOptions image;
    std::string out;
    std::string corners;
    std::optional<double> aspect{};
    bool json = false;
};

CLI::Validator fourCorners() {
    return CLI::Validator(
        [](const std::string& text) {
            return std::string(parseNumbers(text).size() == kNumbers ? "" : "must be 8 numbers");
        },
        "", "corners");
}

// Where the rectangle is in the photo, and how sure that is: none where the user has said it.
struct FoundQuad {
    Quad quad{};
    std::optional<double> confidence{};
};

Result<FoundQuad> quadOf(const PlanLevel& photo, const Options& options) {
    if (!options.corners.empty()) {
        const std::vector<double> numbers = parseNumbers(options.corners);
        std::array<Point<Plan>, 4> corners{};
        for (std::size_t i = 0; i < corners.size(); ++i)
            corners[i] = {numbers[2 * i], numbers[2 * i + 1]};
        return FoundQuad{orderedQuad(corners)};
    }
    if (const auto proposal = proposeQuad(photo))
        return FoundQuad{proposal->quad, proposal->confidence};
    return fail(ErrorCode::kBadValue, "--corners",
                "is missing, and no sheet or frame is seen in " + options.image.file +
                    "; perhaps it is flat as it is");
}

// None where the user has said the shape.
std::vector<LikelySheetFormat> formatsOf(const Rectification& flat) {
    return flat.aspect.sigma > 0.0 ? likelyFormats(flat.aspect) : std::vector<LikelySheetFormat>{};
}

nlohmann::ordered_json toJson(const FoundQuad& found, const Rectification& flat) {
    auto formats = nlohmann::ordered_json::array();
    for (const auto& [format, aspect, probability] : formatsOf(flat))
        formats.push_back(
            {{"name", format.name}, {"aspect", aspect}, {"probability", probability}});
    auto corners = nlohmann::ordered_json::array();
    for (const Point<Plan>& corner : found.quad.corners) corners.push_back({corner.x, corner.y});
    nlohmann::ordered_json object{
        {"corners_px", corners},       {"confidence", nullptr},
        {"aspect", flat.aspect.value}, {"aspect_sigma", flat.aspect.sigma},
        {"usual_formats", formats},    {"width_px", flat.width_px},
        {"height_px", flat.height_px}};
    if (found.confidence) object["confidence"] = *found.confidence;
    return object;
}

void print(const FoundQuad& found, const Rectification& flat, const std::string& out) {
    std::cout << "corners   ";
    const char* between = " ";
    for (const Point<Plan>& corner : found.quad.corners) {
        std::cout << between << corner.x << ',' << corner.y;
        between = "  ";
    }
    if (found.confidence) std::cout << "\nconfidence " << *found.confidence;
    std::cout << "\naspect     " << flat.aspect.value << " width to height";
    if (flat.aspect.sigma > 0.0) std::cout << ", +-" << 100.0 * flat.aspect.sigma << " %";
    for (const auto& [format, aspect, probability] : formatsOf(flat)) {
        std::cout << "\nperhaps    " << format.name << ", " << std::lround(100.0 * probability)
                  << " %: --aspect " << aspect;
    }
    std::cout << "\nwrote      " << out << ", " << flat.width_px << " x " << flat.height_px
              << " pixels\n";
}

Result<PlanLevel> flattened(const PlanLevel& photo, const Rectification& flat) {
    ProgressLine line("rectifying");
    return rectified(photo, flat, shownOn(line));
}

Result<void> runRectify(const Options& options) {
    const auto plan = loadPlanWatched(options.image);
    if (!plan) return tl::make_unexpected(plan.error());
    const auto photo = readWhole(plan->levels.front());
    if (!photo) return tl::make_unexpected(photo.error());
    const auto found = quadOf(*photo, options);
    if (!found) return tl::make_unexpected(found.error());
    const auto flat = rectificationOf(photo->width_px, photo->height_px, found->quad,
                                      options.aspect, plan->focal_length);
    if (!flat) return tl::make_unexpected(flat.error());
    auto written =
        refuseOverwriting({plan->image_file, options.image.file}, options.out)
            .and_then([&] { return flattened(*photo, *flat); })
            .and_then([&](const PlanLevel& image) { return savePlanImage(image, options.out); });
    if (!written) return written;
    if (options.json) {
        std::cout << jsonLine(toJson(*found, *flat));
    } else {
        print(*found, *flat, options.out);
    }
    return {};
}

}  // namespace

Job addPlanRectify(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addImageOptions(app, options->image);
    app.add_option("--out", options->out, "Where to write the flat image, a PNG")
        ->required()
        ->check(notEmpty());
    app.add_option(
           "--corners", options->corners,
           "X,Y,X,Y,X,Y,X,Y: the corners of a rectangle in the photo, pixels from its upper "
           "left corner; found unless told")
        ->check(fourCorners());
    app.add_option("--aspect", options->aspect,
                   "Width / height of that rectangle; recovered from the perspective unless told")
        ->check(CLI::Range(0.02, 50.0));
    addJsonFlag(app, options->json);
    return [options] { return runRectify(*options); };
}

}  // namespace hedr::tool
