#include "radio/publish/nmea_sentence.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace hedr {

namespace {

constexpr double kKnots_per_m_s = 3600.0 / 1852.0;

template <class... Values>
std::string printed(const char* format, Values... values) {
    std::array<char, 128> text{};
    const int length = std::snprintf(text.data(), text.size(), format, values...);
    return {text.data(), static_cast<std::size_t>(length)};
}

// Rounded once, as a whole: 59.999999 minutes become the next degree, never 60 minutes.
std::string degreesAndMinutes(double deg, int degree_digits, char positive, char negative) {
    constexpr std::int64_t kPerMinute = 100'000;
    constexpr std::int64_t kPerDegree = 60 * kPerMinute;
    const std::int64_t parts = std::llround(std::abs(deg) * static_cast<double>(kPerDegree));
    const std::int64_t minutes = parts % kPerDegree;
    return printed(
        "%0*lld%02lld.%05lld,%c", degree_digits, static_cast<long long>(parts / kPerDegree),
        static_cast<long long>(minutes / kPerMinute), static_cast<long long>(minutes % kPerMinute),
        deg < 0.0 && parts != 0 ? negative : positive);
}

// Tenths of a degree; 359.96 is 0.0 again.
std::string angle(double deg) {
    const std::int64_t tenths = std::llround(deg * 10.0) % 3600;
    return printed("%lld.%lld", static_cast<long long>(tenths / 10),
                   static_cast<long long>(tenths % 10));
}

struct CivilTime {
    std::string day;   // ddmmyy
    std::string time;  // hhmmss.ss
};

// Cut, not rounded: 59.999 s never become 60.00.
CivilTime civilTime(std::chrono::system_clock::time_point moment) {
    using Hundredths = std::chrono::duration<std::int64_t, std::centi>;
    const auto day = std::chrono::floor<std::chrono::days>(moment);
    const std::chrono::year_month_day date(day);
    const std::chrono::hh_mm_ss clock(std::chrono::floor<Hundredths>(moment - day));
    return {printed("%02u%02u%02d", static_cast<unsigned>(date.day()),
                    static_cast<unsigned>(date.month()), static_cast<int>(date.year()) % 100),
            printed("%02d%02d%02d.%02d", static_cast<int>(clock.hours().count()),
                    static_cast<int>(clock.minutes().count()),
                    static_cast<int>(clock.seconds().count()),
                    static_cast<int>(clock.subseconds().count()))};
}

std::string nothingKnown(const CivilTime& now) {
    return nmeaSentence("GPRMC," + now.time + ",V,,,,,,," + now.day + ",,,N") +
           nmeaSentence("GPGGA," + now.time + ",,,,,0,00,,,M,,M,,");
}

}  // namespace

std::string nmeaSentence(std::string_view body) {
    unsigned checksum = 0;
    for (const char each : body) checksum ^= static_cast<unsigned char>(each);
    return std::string("$").append(body) + printed("*%02X\r\n", checksum);
}

std::string nmeaLatitude(double latitude_deg) {
    return degreesAndMinutes(latitude_deg, 2, 'N', 'S');
}

std::string nmeaLongitude(double longitude_deg) {
    return degreesAndMinutes(longitude_deg, 3, 'E', 'W');
}

std::string nmeaSentences(const std::optional<PublishedPose>& pose, const PublishTime& time) {
    if (!pose || !isFinite(*pose) || isStale(*pose, time)) return nothingKnown(civilTime(time.utc));
    const auto globe = onGlobe(*pose);
    if (!globe) return nothingKnown(civilTime(time.utc));
    const CivilTime then = civilTime(momentOf(*pose, time));
    const std::string place =
        nmeaLatitude(globe->at.latitude_deg) + ',' + nmeaLongitude(globe->at.longitude_deg);
    const std::string speed = printed("%.2f", std::abs(pose->speed_m_s) * kKnots_per_m_s);
    // "GP" is the talker that every program reads; that no satellite was asked say E and 6.
    return nmeaSentence("GPRMC," + then.time + ",A," + place + ',' + speed + ',' +
                        angle(globe->course_deg) + ',' + then.day + ",,,E") +
           nmeaSentence("GPGGA," + then.time + ',' + place + ",6,00,,,M,,M,,") +
           nmeaSentence("GPHDT," + angle(globe->bearing_deg) + ",T");
}

}  // namespace hedr
