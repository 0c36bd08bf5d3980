#include "app/tool/plan/verbs.h"

namespace hedr::tool {

Job addPlan(CLI::App& app) {
    return addVerbs(
        app, {{"info", "Say what an image is and where it lies", addPlanInfo},
              {"directions", "Find how an image's lines run", addPlanDirections},
              {"rectify", "Make a photo of a plan flat", addPlanRectify},
              {"align", "Find where an image lies by control points or a trail", addPlanAlign},
              {"convert", "Write an image or its place for other programs", addPlanConvert}});
}

}  // namespace hedr::tool
