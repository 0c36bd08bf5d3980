#pragma once

#include <QString>
#include <cstdint>

namespace hedr {

// SI numbers as an operator reads them. A space inside does not break; minus is a true minus.

QString formatHeading(double heading_rad);      // "270°": counter-clockwise from +x, 0..359
QString formatAngle(double angle_rad);          // "0.8°"
QString formatSpeed(double speed_m_s);          // "0.62 m/s"
QString formatDistance(double distance_m);      // "0.6 m", "1.24 km"
QString formatShort(double distance_m);         // "9 cm", "1.25 m": of residuals
QString formatResolution(double resolution_m);  // "5.08 cm": of a pixel
QString formatDuration(double duration_s);      // "00:18:42"
QString formatAge(double age_s);                // "7 s", "2 min", "3 h"
QString formatDrift(double drift_rad_s);        // "+3.1 °/min"
QString formatMilliseconds(double duration_s);  // "38 ms", "1.2 s"
QString formatBytes(std::uint64_t bytes);       // "3.1 MB"
QString formatLoss(double ratio);               // "0.4 %"
QString formatFrameRate(double frames_per_s);   // "120 Hz"
QString formatClockOffset(double offset_s);     // "+3.214 s"
QString formatRadioStrength(int dbm);           // "−71 dBm"

}  // namespace hedr
