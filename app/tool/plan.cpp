#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "app/tool/plan/verbs.h"

namespace hedr::tool {

namespace {

struct Verb {
    const char* name;
    const char* description;
    Job (*add)(CLI::App& app);
};

constexpr std::array kVerbs{
    Verb{"info", "Say what an image is and where it lies", addPlanInfo},
    Verb{"directions", "Find how an image's lines run", addPlanDirections},
    Verb{"rectify", "Make a photo of a plan flat", addPlanRectify},
    Verb{"align", "Find where an image lies by control points or a trail", addPlanAlign},
    Verb{"convert", "Write an image or its place for other programs", addPlanConvert},
};

}  // namespace

Job addPlan(CLI::App& app) {
    app.require_subcommand(1);
    std::vector<std::pair<CLI::App*, Job>> jobs;
    for (const Verb& verb : kVerbs) {
        CLI::App* sub = app.add_subcommand(verb.name, verb.description);
        jobs.emplace_back(sub, verb.add(*sub));
    }
    return [jobs = std::move(jobs)]() -> Result<void> {
        for (const auto& [sub, job] : jobs) {
            if (sub->parsed()) return job();
        }
        return {};
    };
}

}  // namespace hedr::tool
