#include "ui/map/plan_layer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "ui/map/qt_geometry.h"

namespace hedr {
namespace {

int mixed(int from, int to, int weight_of_255) {
    return from + ((to - from) * weight_of_255 + (to >= from ? 127 : -127)) / 255;
}

// How much of the walls' colour a darkness gets at night. Light on dark reads worse than dark on
// light, so grey labels and thin walls get most of it; next to white nothing is added, which keeps
// the paper even.
using NightLift = std::array<int, 256>;
NightLift nightLift() {
    constexpr int kToe = 8;
    NightLift lift{};
    for (int darkness = 0; darkness < 256; ++darkness) {
        const double rest = 1.0 - std::max(0, darkness - kToe) / (255.0 - kToe);
        lift[static_cast<std::size_t>(darkness)] =
            static_cast<int>(std::lround(255.0 * (1.0 - std::pow(rest, 5.0))));
    }
    return lift;
}

// Pixels that are drawn: `part` of a level, in the level's own pixels.
struct Crop {
    PlanLevel pixels;  // of the whole level or of the part alone
    QPoint from;       // where the part begins in `pixels`
    QRect part;
};

// Row of a crop's pixels.
const std::uint8_t* rowOf(const Crop& crop, int row) {
    const auto pixel = static_cast<std::size_t>(crop.from.y() + row) *
                           static_cast<std::size_t>(crop.pixels.width_px) +
                       static_cast<std::size_t>(crop.from.x());
    return crop.pixels.pixels->data() + pixel * static_cast<std::size_t>(crop.pixels.channels);
}

QImage greyImage(const Crop& crop, const Theme& theme) {
    const PlanColours colours = planColours(theme);
    QImage image(crop.part.size(), QImage::Format_RGB32);
    for (int y = 0; y < image.height(); ++y) {
        const std::uint8_t* from = rowOf(crop, y);
        auto* to = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x) to[x] = colours[from[x]];
    }
    return image;
}

QImage colourImage(const Crop& crop, const Theme& theme) {
    QImage image(crop.part.size(), QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < image.height(); ++y) {
        const std::uint8_t* from = rowOf(crop, y);
        auto* to = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x, from += 4) {
            to[x] = qPremultiply(themedColour(qRgba(from[2], from[1], from[0], from[3]), theme));
        }
    }
    return image;
}

std::size_t nearestLevel(const PlanImage& plan, double device_px_per_plan_px) {
    const double halvings = std::round(-std::log2(std::max(1e-9, device_px_per_plan_px)));
    const double last = static_cast<double>(plan.levels.size() - 1);
    return static_cast<std::size_t>(std::clamp(halvings, 0.0, last));
}

Transform<Plan, Plan> planFromLevel(std::size_t level) {
    const double factor = std::exp2(static_cast<double>(level));
    return {factor * Eigen::Matrix2d::Identity(), Eigen::Vector2d::Zero()};
}

QRect visiblePart(const Transform<View, Plan>& view_from_level, const PlanLevel& level,
                  const ViewTransform& view) {
    const QRectF seen =
        toQt(view_from_level).inverted().mapRect(QRectF(0, 0, view.width_px, view.height_px));
    return seen.intersected(QRectF(0, 0, level.width_px, level.height_px))
        .toAlignedRect()
        .adjusted(-2, -2, 2, 2)
        .intersected(QRect(0, 0, level.width_px, level.height_px));
}

std::optional<Crop> cropOf(const PlanLevel& level, const QRect& part) {
    if (level.pixels) return Crop{level, part.topLeft(), part};
    auto read = readPart(level, {part.left(), part.top(), part.width(), part.height()});
    if (!read) return std::nullopt;
    return Crop{std::move(*read), {0, 0}, part};
}

}  // namespace

PlanColours planColours(const Theme& theme) {
    PlanColours colours;
    const NightLift lift = nightLift();
    for (int grey = 0; grey < 256; ++grey) {
        const int darkness = 255 - grey;
        const int ink =
            theme.name == ThemeName::kNight ? lift[static_cast<std::size_t>(darkness)] : darkness;
        colours[static_cast<std::size_t>(grey)] =
            qRgb(mixed(theme.paper.red(), theme.wall.red(), ink),
                 mixed(theme.paper.green(), theme.wall.green(), ink),
                 mixed(theme.paper.blue(), theme.wall.blue(), ink));
    }
    return colours;
}

QRgb themedColour(QRgb colour, const Theme& theme) {
    if (theme.name == ThemeName::kDay) return colour;
    const int r = qRed(colour);
    const int g = qGreen(colour);
    const int b = qBlue(colour);
    // Lightness turned over, hue kept: white becomes 0 and black 255, then both get the theme's.
    const auto [least, most] = std::minmax({r, g, b});
    const int turned = 255 - most - least;
    // Greys are lifted; a tint of a room would only glare.
    static const NightLift lift = nightLift();
    const int grey_of_32 = std::clamp(52 - (most - least), 0, 32);
    const auto ink = [&](int channel) {
        const int darkness = channel + turned;
        return darkness + (lift[static_cast<std::size_t>(darkness)] - darkness) * grey_of_32 / 32;
    };
    return qRgba(mixed(theme.paper.red(), theme.wall.red(), ink(r)),
                 mixed(theme.paper.green(), theme.wall.green(), ink(g)),
                 mixed(theme.paper.blue(), theme.wall.blue(), ink(b)), qAlpha(colour));
}

void drawPlan(QPainter& painter, const PlanImage& plan, const Theme& theme,
              const ViewTransform& view) {
    if (plan.levels.empty()) return;
    const Transform<View, Plan> view_from_plan = view.viewFromWorld() * plan.worldFromPlan();
    const double device_ratio = painter.device()->devicePixelRatioF();
    // Where a level is not there, in a preview or because its file has gone, a coarser one is.
    for (std::size_t i = nearestLevel(plan, device_ratio * view_from_plan.scale());
         i < plan.levels.size(); ++i) {
        const Transform<View, Plan> view_from_level = view_from_plan * planFromLevel(i);
        const QRect part = visiblePart(view_from_level, plan.levels[i], view);
        if (part.isEmpty()) return;
        const auto crop = cropOf(plan.levels[i], part);
        if (!crop) continue;
        painter.save();
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.setTransform(toQt(view_from_level), true);
        painter.drawImage(part.topLeft(), crop->pixels.channels == 1 ? greyImage(*crop, theme)
                                                                     : colourImage(*crop, theme));
        painter.restore();
        return;
    }
}

WorldBox planBounds(const PlanImage& plan) {
    const auto world_from_plan = plan.worldFromPlan();
    const auto width = static_cast<double>(plan.levels.front().width_px);
    const auto height = static_cast<double>(plan.levels.front().height_px);
    return boxAround(
        {world_from_plan * Point<Plan>{0.0, 0.0}, world_from_plan * Point<Plan>{width, 0.0},
         world_from_plan * Point<Plan>{0.0, height}, world_from_plan * Point<Plan>{width, height}});
}

}  // namespace hedr
