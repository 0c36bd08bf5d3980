#include "core/reproduction/papers.h"

#include <array>

namespace hedr {

namespace {

constexpr std::array kPapers{
    Paper{"gyrodometry", "Borenstein, Feng, \"Gyrodometry\", 1996", reproduceGyrodometry},
    Paper{"hedr",
          "Borenstein, Borrell, Miller, Thomas, \"Heuristics-Enhanced Dead-Reckoning\", 2010",
          reproduceHedr},
    Paper{"gyro-error-model",
          "Barshan, Durrant-Whyte, \"Orientation Estimate for Mobile Robots using Gyroscopic "
          "Information\", 1994",
          reproduceGyroErrorModel},
    Paper{"gh-fusion",
          "Zimoch, Giobazolias, Girousis, Mozhaev, \"Investigating effects of sensor fusion of "
          "multiple combinations of sensors on robotic localisation uncertainty\", 2019",
          reproduceGhFusion},
    Paper{"umbmark",
          "Borenstein, Feng, \"Measurement and Correction of Systematic Odometry Errors in Mobile "
          "Robots\", 1996",
          reproduceUmbmark},
};

}  // namespace

std::span<const Paper> paperTable() { return kPapers; }

const Paper* findPaper(std::string_view name) {
    for (const Paper& paper : kPapers) {
        if (paper.name == name) return &paper;
    }
    return nullptr;
}

}  // namespace hedr
