#include "radio/publish/cot_event.h"

#include <QUuid>
#include <QXmlStreamWriter>
#include <cmath>

#include "core/text/clean_text.h"
#include "radio/link/link_age.h"

namespace hedr {

namespace {

// Friendly, ground, equipment, vehicle. The tree of types, that of MIL-STD-2525B, has no unmanned
// ground vehicle; "a-f-G-U-C", the usual one, would be a unit of people.
constexpr QLatin1String kType("a-f-G-E-V");
// Machine generated, by inertial navigation: the nearest to dead reckoning by wheels and gyro.
constexpr QLatin1String kHow("m-n");
constexpr QLatin1String kUnknown("9999999.0");  // as the schema wants it written

constexpr std::size_t kLongestNameBytes = 64;

// Two code points that are UTF-8 and yet must not be in XML.
QString xmlText(const std::string& text) {
    QString clean = QString::fromStdString(cleanText(text, kLongestNameBytes));
    clean.replace(QChar(0xFFFE), QChar(QChar::ReplacementCharacter));
    clean.replace(QChar(0xFFFF), QChar(QChar::ReplacementCharacter));
    return clean;
}

void write(QXmlStreamWriter& xml, const char* attribute, const QString& value) {
    xml.writeAttribute(QLatin1String(attribute), value);
}

QString fixed(double value, int decimals) { return QString::number(value, 'f', decimals); }

QString remarks(const PublishedPose& pose) {
    QString text = QStringLiteral("dead reckoning, trust ") + QLatin1String(trustWord(pose.trust));
    if (!pose.floor.empty()) text += QStringLiteral(", floor ") + xmlText(pose.floor);
    return text;
}

void writePoint(QXmlStreamWriter& xml, const PublishedPose& pose, const LatLon& at) {
    const auto sigma_m = sigmaOf(pose);
    xml.writeEmptyElement(QStringLiteral("point"));
    write(xml, "lat", fixed(at.latitude_deg, 8));
    write(xml, "lon", fixed(at.longitude_deg, 8));
    write(xml, "hae", kUnknown);
    write(xml, "ce", sigma_m ? fixed(*sigma_m, 2) : QString(kUnknown));
    write(xml, "le", kUnknown);
}

void writeDetail(QXmlStreamWriter& xml, const PublishedPose& pose, double course_deg) {
    xml.writeStartElement(QStringLiteral("detail"));
    xml.writeEmptyElement(QStringLiteral("contact"));
    write(xml, "callsign", xmlText(pose.call_sign));
    xml.writeEmptyElement(QStringLiteral("track"));
    write(xml, "course", fixed(course_deg, 2));
    write(xml, "speed", fixed(std::abs(pose.speed_m_s), 2));
    xml.writeTextElement(QStringLiteral("remarks"), remarks(pose));
    xml.writeEndElement();
}

}  // namespace

QString cotUid(const std::string& call_sign, const QByteArray& station) {
    static const QUuid robots(QStringLiteral("{6c0d0c3e-6f6b-5a55-9f3f-2f0f6b1c7a10}"));
    return QStringLiteral("hedr-") +
           QUuid::createUuidV5(robots, station + '/' + QByteArray::fromStdString(call_sign))
               .toString(QUuid::WithoutBraces);
}

Result<QByteArray> cotEvent(const PublishedPose& pose, const PublishTime& time,
                            const QByteArray& station) {
    if (!isFinite(pose)) return fail(ErrorCode::kNoData, pose.call_sign, "its pose is no number");
    if (isStale(pose, time)) return fail(ErrorCode::kNoData, pose.call_sign, "its pose is stale");
    const auto globe = onGlobe(pose);
    if (!globe) return tl::make_unexpected(globe.error());
    const auto start = momentOf(pose, time);
    const auto life = std::chrono::duration<double>(kLostAfter_s);
    const auto stale =
        start + std::chrono::duration_cast<std::chrono::system_clock::duration>(life);
    QByteArray bytes;
    QXmlStreamWriter xml(&bytes);
    xml.writeStartDocument();
    xml.writeStartElement(QStringLiteral("event"));
    write(xml, "version", QLatin1String("2.0"));
    write(xml, "uid", cotUid(pose.call_sign, station));
    write(xml, "type", kType);
    write(xml, "how", kHow);
    write(xml, "time", utcText(time.utc));
    write(xml, "start", utcText(start));
    write(xml, "stale", utcText(stale));
    writePoint(xml, pose, globe->at);
    writeDetail(xml, pose, globe->course_deg);
    xml.writeEndDocument();
    return bytes;
}

}  // namespace hedr
