#include "ui/trail_style.h"

#include <QCoreApplication>
#include <algorithm>

namespace hedr {
namespace {

constexpr double kPrimaryWidth_px = 3.0;

}  // namespace

const std::vector<TrailStyle>& trailStyles() {
    static const std::vector<TrailStyle> styles{
        {"hedr_bayes",
         QT_TRANSLATE_NOOP("TrailStyle", "Bayesian HEDR"),
         2.0,
         {9.0, 2.0, 2.0, 2.0},
         &Theme::hedr_bayes,
         true},
        {"hedr", QT_TRANSLATE_NOOP("TrailStyle", "HEDR"), 2.0, {10.0, 2.5}, &Theme::hedr, false},
        {"robot",
         QT_TRANSLATE_NOOP("TrailStyle", "Robot’s own HEDR"),
         3.0,
         {1.0, 1.4},
         &Theme::robot_trail,
         true},
        {"gyrodometry",
         QT_TRANSLATE_NOOP("TrailStyle", "Gyrodometry"),
         2.0,
         {7.0, 2.5},
         &Theme::gyrodometry,
         false},
        {"gyro",
         QT_TRANSLATE_NOOP("TrailStyle", "Gyro"),
         2.0,
         {5.0, 2.0, 1.0, 2.0},
         &Theme::gyro,
         false},
        {"gyro_kalman",
         QT_TRANSLATE_NOOP("TrailStyle", "Gyro, drift model"),
         2.0,
         {5.0, 2.0, 1.0, 2.0, 1.0, 2.0},
         &Theme::gyro,
         false},
        {"gh_gyro",
         QT_TRANSLATE_NOOP("TrailStyle", "GH gyro"),
         2.0,
         {9.0, 2.0, 1.0, 2.0},
         &Theme::gh_filter,
         false},
        {"gh_magnetometer",
         QT_TRANSLATE_NOOP("TrailStyle", "GH magnetometer"),
         2.0,
         {9.0, 2.0, 1.0, 2.0, 1.0, 2.0},
         &Theme::gh_filter,
         false},
        {"gh_combined",
         QT_TRANSLATE_NOOP("TrailStyle", "GH combined"),
         2.0,
         {9.0, 2.0, 4.0, 2.0},
         &Theme::gh_filter,
         false},
        {"odometry",
         QT_TRANSLATE_NOOP("TrailStyle", "Odometry"),
         2.0,
         {3.0, 2.0},
         &Theme::odometry,
         true},
    };
    return styles;
}

std::size_t trailRank(std::string_view name) {
    const auto& styles = trailStyles();
    const auto found = std::find_if(styles.begin(), styles.end(),
                                    [&](const TrailStyle& style) { return name == style.name; });
    return static_cast<std::size_t>(found - styles.begin());
}

const TrailStyle& trailStyle(std::string_view name) {
    static const TrailStyle other{"", "", 2.0, {1.0, 3.0}, &Theme::dim, true};
    const std::size_t rank = trailRank(name);
    return rank < trailStyles().size() ? trailStyles()[rank] : other;
}

QString trailLabel(std::string_view name) {
    const TrailStyle& style = trailStyle(name);
    if (*style.name == '\0') {
        return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    }
    return QCoreApplication::translate("TrailStyle", style.label);
}

QPen trailPen(std::string_view name, bool primary, const Theme& theme) {
    if (primary) {
        return {theme.accent, kPrimaryWidth_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
    }
    const TrailStyle& style = trailStyle(name);
    QPen pen(theme.*style.colour, style.width_px);
    pen.setCapStyle(Qt::FlatCap);
    pen.setJoinStyle(Qt::BevelJoin);
    pen.setDashPattern(QList<qreal>(style.dashes.begin(), style.dashes.end()));
    return pen;
}

}  // namespace hedr
