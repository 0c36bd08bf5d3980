#include "tests/bench/plan_files.h"

#include <gdal_priv.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace hedr {
namespace {

namespace fs = std::filesystem;

struct Scratch {
    Scratch() : folder(fs::temp_directory_path() / ("hedr_bench_" + std::to_string(getpid()))) {
        fs::create_directories(folder);
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    fs::path folder;
    std::map<std::string, fs::path> made;
};

// A tiled file to write rows into; other formats are copied from it.
GDALDatasetUniquePtr writeRows(const fs::path& file, const PlanFile& plan) {
    std::vector<char*> options = {const_cast<char*>("TILED=YES"),
                                  const_cast<char*>("INTERLEAVE=PIXEL"), nullptr};
    GDALDatasetUniquePtr rows(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), plan.side_px, plan.side_px, plan.channels, GDT_Byte, options.data()));
    std::vector<std::uint8_t> row(static_cast<std::size_t>(plan.side_px * plan.channels));
    std::uint32_t noise = 1;
    for (int y = 0; y < plan.side_px; ++y) {
        for (int x = 0; x < plan.side_px; ++x) {
            noise = noise * 1664525U + 1013904223U;
            const bool wall = x % 400 < 6 || y % 300 < 6;
            const auto value = static_cast<std::uint8_t>(wall ? 60 : 250 - (noise >> 29U));
            for (int c = 0; c < plan.channels; ++c) {
                // The paper is a little yellow.
                row[static_cast<std::size_t>(x * plan.channels + c)] =
                    static_cast<std::uint8_t>(c == 2 ? value - 9 : value);
            }
        }
        const CPLErr written =
            rows->RasterIO(GF_Write, 0, y, plan.side_px, 1, row.data(), plan.side_px, 1, GDT_Byte,
                           plan.channels, nullptr, plan.channels, 0, 1, nullptr);
        if (written != CE_None) std::abort();
    }
    return rows;
}

fs::path makePlan(const fs::path& name, const PlanFile& plan) {
    GDALAllRegister();
    const fs::path tiled = fs::path(name).replace_extension(".tif");
    GDALDatasetUniquePtr rows = writeRows(tiled, plan);
    if (plan.tiled) {
        std::vector<int> factors;
        for (int f = 2; plan.side_px / f >= 256; f *= 2) factors.push_back(f);
        rows->BuildOverviews("AVERAGE", static_cast<int>(factors.size()), factors.data(), 0,
                             nullptr, nullptr, nullptr);
        return tiled;
    }
    GDALDatasetUniquePtr copy(
        GetGDALDriverManager()
            ->GetDriverByName(plan.driver)
            ->CreateCopy(name.c_str(), rows.get(), FALSE, nullptr, nullptr, nullptr));
    copy.reset();
    rows.reset();
    fs::remove(tiled);
    return name;
}

}  // namespace

const fs::path& planFile(const PlanFile& wanted) {
    static Scratch scratch;
    const std::string name = std::string(wanted.driver) + (wanted.tiled ? "tiled" : "") +
                             std::to_string(wanted.side_px) + 'x' + std::to_string(wanted.channels);
    fs::path& file = scratch.made[name];
    if (file.empty()) file = makePlan(scratch.folder / name, wanted);
    return file;
}

}  // namespace hedr
