#include "core/site/raster/bmp_file.h"

#include <array>
#include <fstream>
#include <string>

#include "core/site/raster/bmp_header.h"
#include "core/site/raster/memory_file.h"
#include "core/text/text_file.h"

namespace hedr {
namespace {

constexpr std::size_t kHead = 64;

std::string headOf(const std::string& file) {
    std::string head(kHead, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    return head;
}

}  // namespace

Dataset openNewBmp(const std::string& file) {
    if (!isNewBmp(headOf(file))) return nullptr;
    const auto bytes = readTextFile(file);
    const auto old = bytes ? asOldBmp(*bytes) : std::nullopt;
    if (!old) return nullptr;
    const MemoryFile memory;  // the dataset keeps what it has open
    VSILFILE* out = VSIFOpenL(memory.name().c_str(), "wb");
    if (!out) return nullptr;
    const bool whole = VSIFWriteL(old->data(), 1, old->size(), out) == old->size();
    VSIFCloseL(out);
    if (!whole) return nullptr;
    constexpr std::array<const char*, 2> kBmp{"BMP", nullptr};
    return Dataset(GDALDataset::Open(memory.name().c_str(), GDAL_OF_RASTER, kBmp.data()));
}

}  // namespace hedr
