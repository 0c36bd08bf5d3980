#pragma once

#include <rapidcheck.h>

#include <cstdint>

#include "core/site/site.h"

namespace hedr {

// Sites with everything that a site may hold, for properties. Numbers have all their digits.
inline double randomNumber(double most) {
    return most * static_cast<double>(*rc::gen::inRange<std::int64_t>(-(1LL << 53), 1LL << 53)) /
           static_cast<double>(1LL << 53);
}

inline double randomPositive(double most) { return std::abs(randomNumber(most)) + most * 1e-9; }

inline std::string randomName() {
    const auto letter = rc::gen::element<std::string>("a", "Z", " ", "\"", "\\", "'", "#", "\n",
                                                      "\t", "ä", "\xF0\x9F\x8F\xA0", "]", "=", ".");
    std::string name;
    for (const std::string& part : *rc::gen::container<std::vector<std::string>>(letter)) {
        name += part;
    }
    return name;
}

inline SitePlan randomPlan() {
    SitePlan plan;
    const auto folder = *rc::gen::element<std::string>("/sites/a/", "/sites/a/plans/", "/other/");
    plan.image_file = folder + 'i' + randomName() + ".png";
    plan.page = *rc::gen::inRange(1, 3);
    if (*rc::gen::arbitrary<bool>()) {
        plan.straightened.emplace();
        for (Point<Plan>& c : plan.straightened->quad.corners)
            c = {randomNumber(1e4), randomNumber(1e4)};
        if (*rc::gen::arbitrary<bool>()) plan.straightened->aspect = randomPositive(10.0);
    }
    if (*rc::gen::arbitrary<bool>()) plan.sha256 = std::string(64, *rc::gen::element('0', 'f'));
    plan.placement = {randomPositive(10.0),
                      {{randomNumber(1e6), randomNumber(1e6)}, randomNumber(100.0)}};
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
        plan.placed_by.points.push_back({randomName(),
                                         {randomNumber(1e4), randomNumber(1e4)},
                                         {randomNumber(1e6), randomNumber(1e6)}});
    }
    plan.placed_by.keep_scale = !plan.placed_by.points.empty() && *rc::gen::arbitrary<bool>();
    plan.placed_by.keep_rotation = !plan.placed_by.points.empty() && *rc::gen::arbitrary<bool>();
    plan.opacity = std::abs(randomNumber(1.0));
    plan.visible = *rc::gen::arbitrary<bool>();
    plan.locked = *rc::gen::arbitrary<bool>();
    plan.inverted_at_night = *rc::gen::arbitrary<bool>();
    plan.tells_direction = *rc::gen::arbitrary<bool>();
    if (*rc::gen::arbitrary<bool>()) {
        const Point<Plan> min{randomNumber(1e4), randomNumber(1e4)};
        plan.crop = PlanCrop{min, min + Vector<Plan>{randomPositive(1e4), randomPositive(1e4)}};
    }
    return plan;
}

inline WallStroke randomStroke() {
    WallStroke stroke{*rc::gen::element(WallPen::kWall, WallPen::kEraser), randomPositive(3.0), {}};
    const int points = *rc::gen::inRange(0, 20);
    for (int i = 0; i < points; ++i)
        stroke.points.push_back({randomNumber(1e3), randomNumber(1e3)});
    return stroke;
}

inline SiteFloor randomFloor() {
    SiteFloor floor{randomName(), {}, {}};
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i) floor.plans.push_back(randomPlan());
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i) floor.wall_strokes.push_back(randomStroke());
    return floor;
}

inline Site randomSite() {
    Site site;
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) site.floors.push_back(randomFloor());
    if (*rc::gen::arbitrary<bool>()) site.direction_rad = randomNumber(4.0);
    if (*rc::gen::arbitrary<bool>()) {
        site.geo_tie = GeoTie{{randomNumber(1e3), randomNumber(1e3)},
                              {randomNumber(90.0), randomNumber(180.0)},
                              randomNumber(4.0)};
    }
    return site;
}

}  // namespace hedr
