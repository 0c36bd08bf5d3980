#pragma once

#include <optional>
#include <string>

#include "app/tool/plan/verbs.h"

namespace hedr::tool {

// What `hedr plan align --trail` is told beside the image.
struct TrailOptions {
    std::string file;
    std::optional<double> resolution_m{};  // of a plan that does not say it
    std::size_t pick = 1;                  // which of the placements, best first
};

// Registers them; gives back --trail itself.
CLI::Option* addTrailOptions(CLI::App& app, TrailOptions& options);

// Says where the plan may lie below the trail, and writes the picked placement to `out` unless that
// is empty. Errors: those of loadPlan, loadTrack, freeSpaceOf, placeByTrail and saveFoundPlace,
// kBadValue (fewer placements than picked from).
Result<void> alignByTrail(const ImageOptions& image, const TrailOptions& options,
                          const std::string& out, bool json);

}  // namespace hedr::tool
