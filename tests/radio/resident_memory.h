#pragma once

#include <unistd.h>

#include <fstream>

namespace hedr {

// Of this process.
inline double residentMegabytes() {
    std::ifstream statm("/proc/self/statm");
    double total_pages = 0.0;
    double resident_pages = 0.0;
    statm >> total_pages >> resident_pages;
    return 1e-6 * resident_pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

}  // namespace hedr
