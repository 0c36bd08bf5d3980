#pragma once

#include <filesystem>

namespace hedr {

// What a plan is for the benchmarks: walls on paper that is not quite even, like a scan.
struct PlanFile {
    int side_px = 10'000;
    int channels = 1;            // 1 grey, 3 colour
    const char* driver = "PNG";  // of GDAL
    bool tiled = false;          // with overviews
};

// Made at its first use in this run, in the folder for temporary files.
const std::filesystem::path& planFile(const PlanFile& wanted);

}  // namespace hedr
