#include "ui/map/plan_layer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "core/site/mip_pyramid.h"
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

// The coarsest level that is not enlarged.
std::size_t levelFor(const PlanImage& plan, double device_px_per_plan_px) {
    constexpr double kRounding = 1e-3;
    const double halvings =
        std::floor(-std::log2(std::max(1e-9, device_px_per_plan_px)) + kRounding);
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

// An edge of a part a few pixels farther out, where it lies best on a pixel of the screen.
int snappedEdge(int edge, int step, int limit, const std::function<double(int)>& screen_px) {
    constexpr int kTries = 12;
    const auto off = [&](int at) { return std::abs(std::remainder(screen_px(at), 1.0)); };
    int best = edge;
    for (int i = 0, at = edge; i < kTries && at != limit + step; ++i, at += step) {
        if (off(at) < off(best)) best = at;
    }
    return best;
}

// The part grown so that its edges lie on whole pixels of the screen, as near as it can be; only
// the edges of the image itself cannot be chosen.
QRect snapped(const QRect& part, const Transform<View, Plan>& view_from_level,
              const PlanLevel& level, double device_ratio) {
    const auto x = [&](int column) {
        return device_ratio * (view_from_level * Point<Plan>{static_cast<double>(column), 0.0}).x;
    };
    const auto y = [&](int row) {
        return device_ratio * (view_from_level * Point<Plan>{0.0, static_cast<double>(row)}).y;
    };
    const int left = snappedEdge(part.left(), -1, 0, x);
    const int top = snappedEdge(part.top(), -1, 0, y);
    const int right = snappedEdge(part.left() + part.width(), 1, level.width_px, x);
    const int bottom = snappedEdge(part.top() + part.height(), 1, level.height_px, y);
    return {left, top, right - left, bottom - top};
}

bool isUprightAndNotEnlarged(const Transform<View, Plan>& view_from_level, double device_ratio) {
    const Eigen::Matrix2d& m = view_from_level.linear();
    return m(0, 1) == 0.0 && m(0, 0) > 0.0 && m(1, 1) > 0.0 &&
           device_ratio * view_from_level.scale() <= 1.0;
}

std::optional<Crop> cropOf(const PlanLevel& level, const QRect& part) {
    if (level.pixels) return Crop{level, part.topLeft(), part};
    auto read = readPart(level, {part.left(), part.top(), part.width(), part.height()});
    if (!read) return std::nullopt;
    return Crop{std::move(*read), {0, 0}, part};
}

QImage imageOf(const Crop& crop, const Theme& theme) {
    return crop.pixels.channels == 1 ? greyImage(crop, theme) : colourImage(crop, theme);
}

// The crop at the size that it has on the screen: its pixels are averaged, whole ones remain.
QImage averagedImage(const Crop& crop, const QSize& size, const Theme& theme) {
    const PlanPart part{crop.from.x(), crop.from.y(), crop.part.width(), crop.part.height()};
    const PlanLevel averaged = areaAveraged(crop.pixels, part, size.width(), size.height());
    return imageOf({averaged, {0, 0}, QRect({0, 0}, size)}, theme);
}

// Upright, on whole pixels of the screen: where the image itself ends between two of them, it is
// up to half a pixel beside its place, but sharp.
void drawUpright(QPainter& painter, const Crop& crop, const Theme& theme,
                 const Transform<View, Plan>& view_from_level) {
    const double device_ratio = painter.device()->devicePixelRatioF();
    const QRectF exact = toQt(view_from_level).mapRect(QRectF(crop.part));
    const QPoint first = (exact.topLeft() * device_ratio).toPoint();
    const QPoint end = (exact.bottomRight() * device_ratio).toPoint();
    const QSize size = QSize(end.x() - first.x(), end.y() - first.y()).expandedTo({1, 1});
    QImage image = averagedImage(crop, size, theme);
    image.setDevicePixelRatio(device_ratio);
    painter.drawImage(QPointF(first) / device_ratio, image);
}

void drawCrop(QPainter& painter, const Crop& crop, const Theme& theme,
              const Transform<View, Plan>& view_from_level) {
    const double device_ratio = painter.device()->devicePixelRatioF();
    if (isUprightAndNotEnlarged(view_from_level, device_ratio)) {
        return drawUpright(painter, crop, theme, view_from_level);
    }
    const double scale = device_ratio * view_from_level.scale();
    // Turned pixels lie between those of the screen whatever one does; nothing is left out of them
    // where they are as large.
    const auto shrunk = [&](int side) {
        return std::max(1, static_cast<int>(std::lround(side * std::min(1.0, scale))));
    };
    const QSize size(shrunk(crop.part.width()), shrunk(crop.part.height()));
    const QImage image =
        size == crop.part.size() ? imageOf(crop, theme) : averagedImage(crop, size, theme);
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setTransform(toQt(view_from_level), true);
    painter.drawImage(QRectF(crop.part), image);
    painter.restore();
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
    for (std::size_t i = levelFor(plan, device_ratio * view_from_plan.scale());
         i < plan.levels.size(); ++i) {
        const Transform<View, Plan> view_from_level = view_from_plan * planFromLevel(i);
        QRect part = visiblePart(view_from_level, plan.levels[i], view);
        if (part.isEmpty()) return;
        if (isUprightAndNotEnlarged(view_from_level, device_ratio)) {
            part = snapped(part, view_from_level, plan.levels[i], device_ratio);
        }
        const auto crop = cropOf(plan.levels[i], part);
        if (!crop) continue;
        drawCrop(painter, *crop, theme, view_from_level);
        return;
    }
}

WorldBox planBounds(const PlanImage& plan) { return planBounds(MapPlan{plan}); }

WorldBox planBounds(const MapPlan& plan) {
    const PlanLevel& size = plan.image.levels.front();
    const PlanCrop whole{{0.0, 0.0},
                         {static_cast<double>(size.width_px), static_cast<double>(size.height_px)}};
    const auto [min, max] = plan.crop.value_or(whole);
    const auto world_from_plan = plan.image.worldFromPlan();
    return boxAround({world_from_plan * min, world_from_plan * Point<Plan>{max.x, min.y},
                      world_from_plan * Point<Plan>{min.x, max.y}, world_from_plan * max});
}

}  // namespace hedr
