#include "app/tool/lost_times.h"

#include <iomanip>
#include <iostream>
#include <sstream>

namespace hedr::tool {

namespace {

constexpr std::size_t kMostLines = 5;

std::string seconds(double time_s) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << time_s << " s";
    return text.str();
}

}  // namespace

void tellLostTimes(const std::string& estimator, const LostTimes& lost) {
    const bool many = lost.times().size() > kMostLines;
    double sum_s = 0.0;
    for (const LostTime& time : lost.times()) {
        sum_s += time.until_s - time.from_s;
        if (many) continue;
        std::cerr << estimator << ": LOST LOCK from " << seconds(time.from_s) << " to "
                  << seconds(time.until_s) << ": the direction of the corridors was not known\n";
    }
    if (!many) return;
    std::cerr << estimator << ": LOST LOCK " << lost.times().size() << " times, " << seconds(sum_s)
              << " in all: the direction of the corridors was not known\n";
}

}  // namespace hedr::tool
