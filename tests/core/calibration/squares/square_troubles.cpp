#include "tests/core/calibration/squares/square_troubles.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hedr {

namespace {

using Ends = std::vector<UmbmarkEnd>;

void changeAll(Ends& ends, double xx, double xy, double yx, double yy) {
    for (UmbmarkEnd& end : ends) {
        end.way = {xx * end.way.x + xy * end.way.y, yx * end.way.x + yy * end.way.y};
    }
}

void shift(UmbmarkEnd& end, double largest_m, Random& random) {
    end.way.x += random.uniform(-largest_m, largest_m);
    end.way.y += random.uniform(-largest_m, largest_m);
}

std::size_t anyOf(std::size_t count, Random& random) {
    return static_cast<std::size_t>(random.uniform() * static_cast<double>(count));
}

struct Trouble {
    const char* name;
    void (*drive)(SquareDrives&, Random&);
    void (*spoil)(DrivenSquares&, Random&);
};

void driveAsUsual(SquareDrives&, Random&) {}
void spoilNothing(DrivenSquares&, Random&) {}

const std::array kTroubles{
    Trouble{"none", driveAsUsual, spoilNothing},
    Trouble{"y to the right", driveAsUsual,
            [](DrivenSquares& d, Random&) { changeAll(d.ends, 1.0, 0.0, 0.0, -1.0); }},
    Trouble{"x to the back", driveAsUsual,
            [](DrivenSquares& d, Random&) { changeAll(d.ends, -1.0, 0.0, 0.0, 1.0); }},
    Trouble{"axes askew", driveAsUsual,
            [](DrivenSquares& d, Random& random) {
                const double angle = random.uniform(-0.5, 0.5);
                changeAll(d.ends, std::cos(angle), -std::sin(angle), std::sin(angle),
                          std::cos(angle));
            }},
    Trouble{"another corner of the robot", driveAsUsual,
            [](DrivenSquares& d, Random& random) {
                UmbmarkEnd offset;
                shift(offset, 0.2, random);
                for (UmbmarkEnd& end : d.ends) end.way = end.way + offset.way;
            }},
    Trouble{"a mark that was moved", driveAsUsual,
            [](DrivenSquares& d, Random& random) {
                UmbmarkEnd offset;
                shift(offset, 0.2, random);
                const std::size_t from = anyOf(d.ends.size(), random);
                for (std::size_t i = from; i < d.ends.size(); ++i)
                    d.ends[i].way = d.ends[i].way + offset.way;
            }},
    Trouble{"one to three wrong ends", driveAsUsual,
            [](DrivenSquares& d, Random& random) {
                for (std::size_t i = 0; i <= anyOf(3, random); ++i)
                    shift(d.ends[anyOf(d.ends.size(), random)], 0.5, random);
            }},
    Trouble{"ends shuffled", driveAsUsual,
            [](DrivenSquares& d, Random& random) {
                for (UmbmarkEnd& end : d.ends)
                    std::swap(end.way, d.ends[anyOf(d.ends.size(), random)].way);
            }},
    Trouble{"ends one run late", driveAsUsual,
            [](DrivenSquares& d, Random&) {
                for (UmbmarkEnd& end : d.ends) ++end.run;
            }},
    Trouble{"in centimetres", driveAsUsual,
            [](DrivenSquares& d, Random&) { changeAll(d.ends, 100.0, 0.0, 0.0, 100.0); }},
    Trouble{"paced, not taped", [](SquareDrives& s, Random&) { s.tape_m = 0.1; }, spoilNothing},
    Trouble{
        "rounded to 10 cm", driveAsUsual,
        [](DrivenSquares& d, Random&) {
            for (UmbmarkEnd& end : d.ends)
                end.way = {0.1 * std::round(10.0 * end.way.x), 0.1 * std::round(10.0 * end.way.y)};
        }},
    Trouble{"slip",
            [](SquareDrives& s, Random& random) {
                s.slip_share = random.uniform(0.0, 0.2);
                s.slip = random.uniform(0.0, 0.2);
            },
            spoilNothing},
    Trouble{
        "rough floor",
        [](SquareDrives& s, Random& random) { s.unevenness_m_sqrtm = random.uniform(0.0, 3e-3); },
        spoilNothing},
    Trouble{"few",
            [](SquareDrives& s, Random& random) {
                s.clockwise = 1 + static_cast<int>(anyOf(3, random));
                s.counter_clockwise = 1 + static_cast<int>(anyOf(3, random));
            },
            spoilNothing},
    Trouble{"one way only", [](SquareDrives& s, Random&) { s.counter_clockwise = 0; },
            spoilNothing},
    Trouble{"reports without numbers", driveAsUsual,
            [](DrivenSquares& d, Random& random) {
                for (SensorReport& report : d.sets[0].reports) {
                    if (random.uniform() < 0.02)
                        report.robot_time_s = std::numeric_limits<double>::quiet_NaN();
                }
            }},
    Trouble{"reports lost", driveAsUsual,
            [](DrivenSquares& d, Random& random) {
                std::erase_if(d.sets[0].reports,
                              [&](const SensorReport&) { return random.uniform() < 0.03; });
            }},
};

}  // namespace

TroubledSquares troubledSquares(Random& random) {
    SquareDrives drives;
    const double size = std::array{0.0, 0.02, 0.2, 1.0}[anyOf(4, random)];
    drives.diameter_ratio = 1.0 + size * random.uniform(-0.02, 0.02);
    drives.wheelbase_ratio = 1.0 + size * random.uniform(-0.04, 0.04);
    drives.along_tape = random.uniform() < 0.3;
    drives.in_turns = random.uniform() < 0.7;
    const Trouble& trouble = kTroubles[anyOf(kTroubles.size(), random)];
    trouble.drive(drives, random);
    TroubledSquares troubled{drive(drives, random), realWheels(drives), trouble.name};
    // On a floor where wheels slip they turn the robot as if they stood wider apart.
    troubled.real.wheelbase_m /= 1.0 - drives.slip_share * drives.slip;
    trouble.spoil(troubled.driven, random);
    return troubled;
}

bool isInside(const Vector<Robot>& point, const std::vector<double>& outline_x,
              const std::vector<double>& outline_y) {
    bool inside = false;
    for (std::size_t i = 0, j = outline_x.size() - 1; i < outline_x.size(); j = i++) {
        if ((outline_y[i] > point.y) == (outline_y[j] > point.y)) continue;
        const double share = (point.y - outline_y[i]) / (outline_y[j] - outline_y[i]);
        if (point.x < outline_x[i] + share * (outline_x[j] - outline_x[i])) inside = !inside;
    }
    return inside;
}

}  // namespace hedr
