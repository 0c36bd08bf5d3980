// What is parsed here and by no library: small text files beside a plan, and plain pictures. The
// first byte says which of them the rest is. No crash, no memory without bound, and what is read is
// finite and reads back as itself.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/site/control_points_file.h"
#include "core/site/geo_text.h"
#include "core/site/placement_file.h"
#include "core/site/plain_pnm.h"
#include "core/site/raster/bmp_header.h"
#include "core/site/site_file.h"
#include "core/site/world_file.h"

namespace {

using namespace hedr;

void demand(bool holds) {
    if (!holds) std::abort();
}

void readPlacement(const std::string& text, const char* name) {
    const auto found = parsePlacement(text, name);
    if (!found) return;
    const PlanPlacement& placement = found->placement;
    demand(std::isfinite(placement.resolution_m) && placement.resolution_m > 0.0);
    demand(std::isfinite(placement.origin.position.x) &&
           std::isfinite(placement.origin.position.y) &&
           std::isfinite(placement.origin.heading_rad));
}

void readWorldFile(const std::string& text) {
    const auto numbers = parseWorldFile(text, "plan.pgw");
    if (!numbers) return;
    const auto again = parseWorldFile(worldFileText(*numbers), "plan.pgw");
    demand(again && *again == *numbers);
    const auto ground_from_plan = groundFromPlan(*numbers);
    demand(ground_from_plan.linear().allFinite() && ground_from_plan.offset().allFinite());
    demand(ground_from_plan.linear().determinant() != 0.0);
    (void)placementOf(*numbers, 100, "plan.pgw");
}

void readSiteText(const std::string& text) {
    const auto site = parseSite(text, "x", "/site");
    if (!site) return demand(!site.error().subject.empty());
    const auto again = parseSite(siteText(*site, "/site"), "x", "/site");
    demand(again && *again == *site);
}

void readControlPoints(const std::string& text) {
    const auto points = parseControlPoints(text, "points.csv");
    if (!points) return;
    const auto finite = [](const auto& list) {
        for (const auto& point : list) {
            demand(std::isfinite(point.plan.x) && std::isfinite(point.plan.y));
        }
    };
    std::visit(finite, *points);
}

void readPicture(const std::string& bytes) {
    const auto level = parsePlainPnm(bytes, "plan.pgm");
    if (!level) return;
    demand(level->pixels->size() == static_cast<std::size_t>(level->width_px) *
                                        static_cast<std::size_t>(level->height_px) *
                                        static_cast<std::size_t>(level->channels));
}

void readPlace(const std::string& text) {
    const auto at = latLonFromText(text);
    if (at) {
        demand(std::abs(at->latitude_deg) <= 90.0 && std::abs(at->longitude_deg) <= 180.0);
        const auto again = latLonFromText(latLonText(*at));
        demand(again && std::abs(again->latitude_deg - at->latitude_deg) < 1e-7 &&
               std::abs(again->longitude_deg - at->longitude_deg) < 1e-7);
    }
    const auto point = worldPointFromText(text, GeoTie{{}, {52.0, 21.0}, 0.1});
    if (point) demand(std::isfinite(point->x) && std::isfinite(point->y));
}

void readBmp(const std::string& bytes) {
    const auto old = asOldBmp(bytes);
    if (old) demand(old->size() < bytes.size() && !asOldBmp(*old));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
    switch (data[0]) {
        case 's':
            readSiteText(text);
            break;
        case 't':
            readPlacement(text, "plan.toml");
            break;
        case 'y':
            readPlacement(text, "map.yaml");
            break;
        case 'w':
            readWorldFile(text);
            break;
        case 'c':
            readControlPoints(text);
            break;
        case 'g':
            readPlace(text);
            break;
        case 'b':
            readBmp(text);
            break;
        case 'p':
            readPicture(text);
            break;
        default:
            break;
    }
    return 0;
}
