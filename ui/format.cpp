#include "ui/format.h"

#include <QStringList>
#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

constexpr char16_t kNoBreakSpace = u'\u00A0';
constexpr char16_t kMinus = u'\u2212';

// Nothing but digits: never "-0.0", never "nan".
QString number(double value, int decimals) {
    if (!std::isfinite(value)) return QStringLiteral("–");
    QString text = QString::number(std::abs(value), 'f', decimals);
    const bool zero = text.count(u'0') + text.count(u'.') == text.size();
    if (value < 0.0 && !zero) text.prepend(QChar(kMinus));
    return text;
}

QString withUnit(const QString& value, const QString& unit) {
    return value + QChar(kNoBreakSpace) + unit;
}

}  // namespace

QString formatHeading(double heading_rad) {
    if (!std::isfinite(heading_rad)) return QStringLiteral("–");
    const long turn = std::lround(degFromRad(wrapAngle(heading_rad)));
    return QString::number((turn + 360) % 360) + QStringLiteral("°");
}

QString formatAngle(double angle_rad) {
    return number(degFromRad(angle_rad), 1) + QStringLiteral("°");
}

QString formatSpeed(double speed_m_s) {
    return withUnit(number(speed_m_s, 2), QStringLiteral("m/s"));
}

QString formatDistance(double distance_m) {
    if (std::abs(distance_m) >= 1000.0) {
        return withUnit(number(distance_m / 1000.0, 2), QStringLiteral("km"));
    }
    return withUnit(number(distance_m, 1), QStringLiteral("m"));
}

QString formatShort(double distance_m) {
    if (std::abs(distance_m) >= 1.0) return withUnit(number(distance_m, 2), QStringLiteral("m"));
    return withUnit(number(100.0 * distance_m, 0), QStringLiteral("cm"));
}

QString formatResolution(double resolution_m) {
    if (resolution_m >= 1.0) return withUnit(number(resolution_m, 2), QStringLiteral("m"));
    return withUnit(number(100.0 * resolution_m, 2), QStringLiteral("cm"));
}

QString formatDuration(double duration_s) {
    if (!std::isfinite(duration_s)) return QStringLiteral("–");
    const auto seconds = static_cast<long long>(std::max(0.0, duration_s));
    return QStringLiteral("%1:%2:%3")
        .arg(seconds / 3600, 2, 10, QChar('0'))
        .arg(seconds / 60 % 60, 2, 10, QChar('0'))
        .arg(seconds % 60, 2, 10, QChar('0'));
}

QString formatAge(double age_s) {
    const double whole_s = std::floor(std::max(0.0, age_s));
    if (whole_s < 100.0) return withUnit(number(whole_s, 0), QStringLiteral("s"));
    if (whole_s < 6000.0) {
        return withUnit(number(std::floor(whole_s / 60.0), 0), QStringLiteral("min"));
    }
    return withUnit(number(std::floor(whole_s / 3600.0), 0), QStringLiteral("h"));
}

QString formatDrift(double drift_rad_s) {
    QString value = number(degFromRad(drift_rad_s) * 60.0, 1);
    if (drift_rad_s > 0.0 && value != QStringLiteral("0.0")) value.prepend(u'+');
    return withUnit(value, QStringLiteral("°/min"));
}

QString formatMilliseconds(double duration_s) {
    if (duration_s < 0.9995) return withUnit(number(1e3 * duration_s, 0), QStringLiteral("ms"));
    return withUnit(number(duration_s, duration_s < 10.0 ? 1 : 0), QStringLiteral("s"));
}

QString formatBytes(std::uint64_t bytes) {
    static const QStringList units{"B", "kB", "MB", "GB", "TB"};
    auto value = static_cast<double>(bytes);
    qsizetype unit = 0;
    while (value >= 999.95 && unit + 1 < units.size()) {
        value /= 1000.0;
        ++unit;
    }
    return withUnit(number(value, unit == 0 ? 0 : 1), units[unit]);
}

QString formatLoss(double ratio) { return withUnit(number(100.0 * ratio, 1), QStringLiteral("%")); }

QString formatFrameRate(double frames_per_s) {
    return withUnit(number(frames_per_s, 0), QStringLiteral("Hz"));
}

QString formatClockOffset(double offset_s) {
    const QString amount = withUnit(number(offset_s, 3), QStringLiteral("s"));
    return offset_s < 0.0 ? amount : QLatin1Char('+') + amount;
}

QString formatRadioStrength(int dbm) {
    return withUnit(number(static_cast<double>(dbm), 0), QStringLiteral("dBm"));
}

}  // namespace hedr
