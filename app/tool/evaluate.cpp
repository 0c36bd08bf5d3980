#include <future>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/tool/command.h"
#include "app/tool/comparison.h"
#include "app/tool/json_line.h"
#include "core/track/track_file.h"

namespace hedr::tool {

namespace {

struct Options {
    std::string track;
    std::string truth;
    std::string alignment = "none";
    bool json = false;
};

const std::map<std::string, Alignment> kAlignments{
    {"none", Alignment::kNone}, {"start", Alignment::kStart}, {"rigid", Alignment::kRigid}};

struct Figure {
    const char* name;
    double value;
};

std::vector<Figure> figures(const Evaluation& e) {
    return {{"samples", static_cast<double>(e.samples)},
            {"duration_s", e.duration_s},
            {"distance_m", e.distance_m},
            {"end_position_error_m", e.end_position_error_m},
            {"end_heading_error_deg", e.end_heading_error_deg},
            {"return_position_error_m", e.return_position_error_m},
            {"return_position_error_percent", e.return_position_error_percent},
            {"heading_rmse_deg", e.heading_rmse_deg},
            {"heading_max_deg", e.heading_max_deg},
            {"ape_rmse_m", e.ape_rmse_m},
            {"ape_mean_m", e.ape_mean_m},
            {"ape_median_m", e.ape_median_m},
            {"ape_max_m", e.ape_max_m}};
}

void print(const Evaluation& evaluation, bool json) {
    if (!json) {
        for (const Figure& figure : figures(evaluation)) {
            std::cout << figure.name << " " << figure.value << '\n';
        }
        return;
    }
    nlohmann::ordered_json object;
    for (const Figure& figure : figures(evaluation)) object[figure.name] = figure.value;
    object["samples"] = evaluation.samples;
    std::cout << jsonLine(object);
}

Result<void> runEvaluate(const Options& options) {
    // Reading takes most of the time, so both files are read at once.
    auto loading = std::async(std::launch::async, [&] { return loadTrack(options.truth); });
    const auto track = loadTrack(options.track);
    const auto truth = loading.get();
    if (!track) return tl::make_unexpected(track.error());
    if (!truth) return tl::make_unexpected(truth.error());
    const auto evaluation = compare(*track, *truth, kAlignments.at(options.alignment),
                                    options.track + " or " + options.truth);
    if (!evaluation) return tl::make_unexpected(evaluation.error());
    print(*evaluation, options.json);
    return {};
}

}  // namespace

Job addEvaluate(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("TRACK", options->track, "The track to judge, CSV or TUM")->required();
    app.add_option("--truth", options->truth, "The true track, CSV or TUM")->required();
    app.add_option("--align", options->alignment, "none (the default), start or rigid")
        ->check(oneOf({"none", "start", "rigid"}))
        ->type_name("HOW");
    app.add_flag("--json", options->json, "One JSON object on standard output");
    return [options] { return runEvaluate(*options); };
}

}  // namespace hedr::tool
