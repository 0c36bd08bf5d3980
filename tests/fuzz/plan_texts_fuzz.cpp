// Whatever stands in the small files about plans: no crash, and what is understood is written and
// read back as the same.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/site/control_points_file.h"
#include "core/site/placement_file.h"
#include "core/site/site_file.h"
#include "core/site/world_file.h"

namespace {

void demand(bool holds) {
    if (!holds) std::abort();
}

void readSiteText(std::string_view text) {
    const auto site = hedr::parseSite(text, "x", "/site");
    if (!site) return demand(!site.error().subject.empty());
    const auto again = hedr::parseSite(hedr::siteText(*site, "/site"), "x", "/site");
    demand(again && *again == *site);
}

void readPlacementText(const std::string& text) {
    for (const char* name : {"plan.toml", "map.yaml"}) {
        const auto placement = hedr::parsePlacement(text, name);
        if (placement) demand(std::isfinite(placement->placement.resolution_m));
    }
}

void readWorldFileText(std::string_view text) {
    const auto numbers = hedr::parseWorldFile(text, "x");
    if (!numbers) return;
    const auto again = hedr::parseWorldFile(hedr::worldFileText(*numbers), "x");
    demand(again && *again == *numbers);
    (void)hedr::placementOf(*numbers, 100, "x");
}

}  // namespace

// The first byte says what the others are.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
    switch (data[0]) {
        case 's':
            readSiteText(text);
            break;
        case 'p':
            readPlacementText(text);
            break;
        case 'c':
            (void)hedr::parseControlPoints(text, "x");
            break;
        case 'w':
            readWorldFileText(text);
            break;
        default:
            break;
    }
    return 0;
}
