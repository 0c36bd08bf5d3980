#include "tests/bench/memory.h"

#include <fstream>
#include <string>

namespace hedr {
namespace {

double statusLine_bytes(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(key)) return 1024.0 * std::stod(line.substr(key.size()));
    }
    return 0.0;
}

}  // namespace

double peakMemory_bytes() { return statusLine_bytes("VmHWM:"); }

double memory_bytes() { return statusLine_bytes("VmRSS:"); }

void forgetPeak() { std::ofstream("/proc/self/clear_refs") << "5"; }

}  // namespace hedr
