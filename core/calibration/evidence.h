#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/calibration/estimate.h"

namespace hedr {

// What the operator sees of the samples, for any drawing: values in SI, angles in rad; whoever
// draws turns them into the unit that is read.

struct EvidenceAxis {
    std::string name;    // "Averaging time"
    std::string unit{};  // "s"; SI, empty: a bare number
    bool logarithmic = false;
};

struct EvidenceSeries {
    enum class Shape : unsigned char { kLine, kDashes, kDots, kSquares, kBand, kEllipse };

    std::string name;
    Shape shape = Shape::kLine;
    std::vector<double> x{};
    std::vector<double> y{};
    std::vector<double> y_high{};  // of a band, whose lower edge is y
};

struct EvidencePlot {
    std::string title;
    EvidenceAxis x{};
    EvidenceAxis y{};
    bool same_scale = false;  // one metre is as long on both axes
    std::vector<EvidenceSeries> series{};
};

// A figure beside the result.
struct EvidenceFigure {
    std::string name;  // "Drift while measuring"
    double value = 0.0;
    std::string unit{};
    std::optional<Interval> interval{};
};

// How much of what has to be known is known: information gained, not time passed.
struct CalibrationProgress {
    double share = 0.0;   // 1: enough
    std::string known{};  // "Known to ±0.003 °/s"
    std::string more{};   // "30 s more give ±0.002 °/s"; empty where there is enough
};

// What the operator has to do; the first that is not done is next.
struct CalibrationStep {
    std::string title;   // "Let it stand"
    std::string detail;  // one sentence
    bool done = false;
};

}  // namespace hedr
