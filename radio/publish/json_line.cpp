#include "radio/publish/json_line.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>

#include "core/geometry/angle.h"
#include "core/text/clean_text.h"
#include "radio/link/link_age.h"

namespace hedr {

namespace {

// Digits that mean nothing only make the line longer.
double rounded(double value, double parts) { return std::round(value * parts) / parts; }

QString text(const std::string& raw) { return QString::fromStdString(cleanText(raw)); }

QString linkWord(double age_s) {
    if (age_s >= kLostAfter_s) return QStringLiteral("lost");
    return age_s >= kStaleAfter_s ? QStringLiteral("stale") : QStringLiteral("live");
}

void addVariance(QJsonObject& object, const PoseVariance& variance) {
    if (!variance.known()) return;
    const auto add = [&](const char* key, float value) {
        object[QLatin1String(key)] = rounded(static_cast<double>(value), 1e9);
    };
    add("var_x_m2", variance.var_x_m2);
    add("cov_xy_m2", variance.cov_xy_m2);
    add("var_y_m2", variance.var_y_m2);
    add("var_heading_rad2", variance.var_heading_rad2);
}

void addGlobe(QJsonObject& object, const PublishedPose& pose) {
    const auto globe = onGlobe(pose);
    if (!globe) return;
    object[QLatin1String("latitude_deg")] = rounded(globe->at.latitude_deg, 1e9);
    object[QLatin1String("longitude_deg")] = rounded(globe->at.longitude_deg, 1e9);
    object[QLatin1String("bearing_deg")] = rounded(globe->bearing_deg, 1e3);
}

}  // namespace

Result<QByteArray> jsonLine(const PublishedPose& pose, const PublishTime& time) {
    if (!isFinite(pose)) return fail(ErrorCode::kNoData, pose.call_sign, "its pose is no number");
    const double age_s = ageOf(pose, time);
    QJsonObject object{
        {QStringLiteral("call_sign"), text(pose.call_sign)},
        {QStringLiteral("time"), utcText(momentOf(pose, time))},
        {QStringLiteral("age_s"), rounded(age_s, 1e3)},
        {QStringLiteral("link"), linkWord(age_s)},
        {QStringLiteral("x_m"), rounded(pose.pose.position.x, 1e4)},
        {QStringLiteral("y_m"), rounded(pose.pose.position.y, 1e4)},
        {QStringLiteral("heading_rad"), rounded(wrapAngle(pose.pose.heading_rad), 1e6)},
        {QStringLiteral("speed_m_s"), rounded(pose.speed_m_s, 1e4)},
        {QStringLiteral("trust"), QLatin1String(trustWord(pose.trust))}};
    if (!pose.estimator.empty()) object[QLatin1String("estimator")] = text(pose.estimator);
    if (!pose.floor.empty()) object[QLatin1String("floor")] = text(pose.floor);
    addVariance(object, pose.variance);
    addGlobe(object, pose);
    return QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
}

}  // namespace hedr
