#include "tests/core/site/survey/desk_scene.h"

#include "tests/core/site/survey/jpeg_like.h"

namespace hedr::test {
namespace {

class Chance {
  public:
    explicit Chance(unsigned seed) : engine_(977 * seed + 1) { engine_.discard(10); }
    double between(double least, double most) {
        return least + (most - least) * (static_cast<double>(engine_() - 1) / 2147483646.0);
    }
    int upTo(int most) { return std::min(most, static_cast<int>(between(0.0, most + 1.0))); }

  private:
    std::minstd_rand engine_;
};

struct Rectangle {
    Point<Table> middle{};
    double width_m = 0.0;
    double height_m = 0.0;
    double angle_rad = 0.0;
    double grey = 0.0;
    double cosine = std::cos(angle_rad);
    double sine = std::sin(angle_rad);

    bool contains(Point<Table> p) const {
        const Vector<Table> off = p - middle;
        return std::abs(cosine * off.x + sine * off.y) < 0.5 * width_m &&
               std::abs(-sine * off.x + cosine * off.y) < 0.5 * height_m;
    }
};

// Noise of one number per cell of a grid, smoothly between.
double cloud(double x, double y) {
    const auto at = [](double column, double row) {
        const double wild = std::sin(column * 127.1 + row * 311.7) * 43758.5453;
        return wild - std::floor(wild);
    };
    const auto ease = [](double t) { return t * t * (3.0 - 2.0 * t); };
    const double column = std::floor(x);
    const double row = std::floor(y);
    const double u = ease(x - column);
    const double v = ease(y - row);
    return (1.0 - v) * ((1.0 - u) * at(column, row) + u * at(column + 1.0, row)) +
           v * ((1.0 - u) * at(column, row + 1.0) + u * at(column + 1.0, row + 1.0));
}

enum class PlanGround { kPlain, kWood, kCarpet, kTiles, kCount };

struct Desk {
    PlanGround ground{};
    double ground_grey = 90.0;
    Vector<Table> ground_turn{1.0, 0.0};
    Rectangle sheet{};
    std::vector<Rectangle> ink{};  // on the sheet
    std::vector<Rectangle> clutter{};
    std::vector<Rectangle> fingers{};

    double groundAt(Point<Table> p) const {
        const double c = ground_turn.x;
        const double s = ground_turn.y;
        const double x = c * p.x + s * p.y + 3.0;
        const double y = -s * p.x + c * p.y + 3.0;
        switch (ground) {
            case PlanGround::kWood: {
                const double ring = y * 90.0 + 3.0 * cloud(4.0 * x, 12.0 * y);
                const bool joint = std::fmod(y, 0.11) < 0.002;
                return (joint ? 0.6 : 0.85 + 0.3 * cloud(3.0 * x, ring)) * ground_grey;
            }
            case PlanGround::kCarpet:
                return (0.6 + 0.8 * cloud(500.0 * x, 500.0 * y)) * ground_grey;
            case PlanGround::kTiles: {
                const bool joint = std::fmod(x, 0.2) < 0.005 || std::fmod(y, 0.2) < 0.005;
                return (joint ? 0.65 : 1.0) * ground_grey;
            }
            default:
                return ground_grey;
        }
    }
    double operator()(Point<Table> p) const {
        for (const Rectangle& finger : fingers) {
            if (finger.contains(p)) return finger.grey;
        }
        if (sheet.contains(p)) {
            for (const Rectangle& line : ink) {
                if (line.contains(p)) return line.grey;
            }
            return sheet.grey;
        }
        for (const Rectangle& thing : clutter) {
            if (thing.contains(p)) return thing.grey;
        }
        return groundAt(p);
    }
};

// Outer walls with doors, inner walls, some writing.
void drawPlan(Desk& desk, double width_m, double height_m, Chance& chance) {
    const double wall_m = chance.between(0.0012, 0.004);
    const double grey = chance.between(25.0, 70.0);
    const auto wall = [&](double x0, double y0, double x1, double y1) {
        desk.ink.push_back({{0.5 * (x0 + x1), 0.5 * (y0 + y1)},
                            std::abs(x1 - x0) + wall_m,
                            std::abs(y1 - y0) + wall_m,
                            0.0,
                            grey});
    };
    const double x = 0.5 * (width_m - wall_m);
    const double y = 0.5 * (height_m - wall_m);
    const auto sideWithDoor = [&](bool level, double at, double half) {
        const double door = chance.between(-0.7, 0.5) * half;
        const double end = door + 0.15 * half;
        if (level) {
            wall(-half, at, door, at);
            wall(end, at, half, at);
        } else {
            wall(at, -half, at, door);
            wall(at, end, at, half);
        }
    };
    sideWithDoor(true, -y, x);
    sideWithDoor(true, y, x);
    sideWithDoor(false, -x, y);
    sideWithDoor(false, x, y);
    for (int i = 0; i < 5; ++i) {
        const double at = chance.between(-0.7, 0.7);
        const double from = chance.between(-1.0, 0.3);
        if (i % 2 == 0) {
            wall(at * x, from * y, at * x, (from + 0.7) * y);
        } else {
            wall(from * x, at * y, (from + 0.7) * x, at * y);
        }
    }
    for (int i = 0; i < 40; ++i) {  // letters
        const double left = (i % 8) * 0.0035 + ((i / 8) % 2 == 0 ? -0.6 : 0.2) * x;
        const double top = (-0.6 + 0.3 * (i / 8)) * y;
        desk.ink.push_back({{left, top}, 0.002, 0.0007 * (1 + i % 4), 0.4 * (i % 3), grey});
    }
}

void scatter(Desk& desk, Chance& chance) {
    for (int i = 0; i < 5; ++i) {
        const double angle = chance.between(0.0, 2.0 * kPi);
        const double far_m =
            0.5 * std::hypot(desk.sheet.width_m, desk.sheet.height_m) + chance.between(0.0, 0.1);
        const bool pen = i % 2 == 0;
        desk.clutter.push_back({{far_m * std::cos(angle), far_m * std::sin(angle)},
                                pen ? 0.14 : chance.between(0.08, 0.2),
                                pen ? 0.009 : chance.between(0.05, 0.15),
                                chance.between(0.0, kPi),
                                chance.between(20.0, 200.0)});
    }
}

void layHand(Desk& desk, Chance& chance) {
    const double side = chance.upTo(1) == 0 ? -1.0 : 1.0;
    const double y = chance.between(-0.25, 0.25) * desk.sheet.height_m;
    for (int i = 0; i < 4; ++i) {
        desk.fingers.push_back(
            {{side * (0.5 * desk.sheet.width_m + 0.01 - 0.004 * (i % 3)), y + 0.017 * i},
             0.08,
             0.0155,
             0.1 * side,
             130.0 + 6.0 * i});
    }
}

Desk deskOf(const DeskOptions& options, DeskPhoto& photo, Chance& chance) {
    Desk desk;
    const bool wide = chance.upTo(3) != 0;
    photo.width_m = wide ? 0.297 : 0.21;
    photo.height_m = wide ? 0.21 : 0.297;
    desk.ground = static_cast<PlanGround>(chance.upTo(static_cast<int>(PlanGround::kCount) - 1));
    desk.ground_grey = chance.between(35.0, 160.0);
    const double turn_rad = chance.between(0.0, kPi);
    desk.ground_turn = {std::cos(turn_rad), std::sin(turn_rad)};
    if (options.no_sheet) return desk;
    desk.sheet = {{}, photo.width_m, photo.height_m, 0.0, chance.between(205.0, 240.0)};
    drawPlan(desk, 0.8 * photo.width_m, 0.8 * photo.height_m, chance);
    if (options.close) desk.sheet.width_m = desk.sheet.height_m = 10.0;
    if (options.clutter) scatter(desk, chance);
    if (options.hand) layHand(desk, chance);
    return desk;
}

PhoneCamera cameraOver(const DeskOptions& options, const DeskPhoto& photo, Chance& chance) {
    PhoneCamera camera;
    camera.width_px = 1000;
    camera.height_px = 750;
    camera.focal_mm = chance.between(24.0, 28.0);
    camera.principal_px = {chance.between(-4.0, 4.0), chance.between(-4.0, 4.0)};
    camera.tilt_rad = radFromDeg(options.tilt_deg);
    camera.azimuth_rad = chance.between(-kPi, kPi);
    camera.roll_rad = chance.between(-0.5, 0.5);
    const double share = options.close ? 0.8 : 1.0;
    camera = framing(camera, share * photo.width_m, share * photo.height_m);
    camera.distance_m *= options.close ? 1.0 : chance.between(1.0, 1.3);
    if (options.corner_outside) {
        Quad sheet = quadOf(camera, photo.width_m, photo.height_m);
        std::ranges::sort(sheet.corners, {}, &Point<Plan>::x);
        const double next = 0.5 * (sheet.corners[0].x + sheet.corners[1].x);
        camera.principal_px.x -= std::min(sheet.corners[0].x + 0.02 * camera.width_px, next);
    }
    return camera;
}

}  // namespace

DeskPhoto deskPhoto(const DeskOptions& options, unsigned seed) {
    Chance chance(seed);
    DeskPhoto photo;
    const Desk desk = deskOf(options, photo, chance);
    photo.camera = cameraOver(options, photo, chance);
    const double bearing = chance.between(0.0, 2.0 * kPi);
    const double uneven = chance.between(0.1, 0.5);
    const double shadow = options.hard_shadow ? chance.between(0.5, 0.75) : 1.0;
    const auto light = [&](Point<Plan> p) {
        const double across = ((p.x / photo.camera.width_px - 0.5) * std::cos(bearing) +
                               (p.y / photo.camera.height_px - 0.5) * std::sin(bearing));
        const double edge = std::clamp(0.5 + 60.0 * (across + 0.1), 0.0, 1.0);
        return (1.0 - uneven * (across + 0.5)) * (shadow + (1.0 - shadow) * edge);
    };
    photo.image = jpegLike(photoOf(photo.camera, desk, light, 4.0, seed, 2), 80);
    photo.sheet = orderedQuad(quadOf(photo.camera, photo.width_m, photo.height_m).corners);
    photo.drawing =
        orderedQuad(quadOf(photo.camera, 0.8 * photo.width_m, 0.8 * photo.height_m).corners);
    return photo;
}

double cornerError(const Quad& found, const Quad& truth, double diagonal_px) {
    double least = 1.0;
    for (std::size_t turn = 0; turn < 4; ++turn) {
        double worst = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
            worst = std::max(worst, (found.corners[(i + turn) % 4] - truth.corners[i]).length());
        }
        least = std::min(least, worst / diagonal_px);
    }
    return least;
}

}  // namespace hedr::test
