#include "core/site/raster/bmp_file.h"

#include <cpl_vsi.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>

#include "core/text/text_file.h"

namespace hedr {
namespace {

constexpr std::size_t kFileHeader = 14;
constexpr std::size_t kOldHeader = 40;
constexpr std::size_t kMasks = 12;  // behind an old header, within a new one
constexpr std::uint32_t kBitFields = 3;

std::uint32_t numberAt(const std::string& bytes, std::size_t at) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + at, sizeof number);  // little-endian, as we are
    return number;
}

void setNumber(std::string& bytes, std::size_t at, std::size_t number) {
    const auto small = static_cast<std::uint32_t>(number);
    std::memcpy(bytes.data() + at, &small, sizeof small);
}

bool isNewBmp(const std::string& file) {
    std::string head(kFileHeader + kOldHeader, '\0');
    std::ifstream in(file, std::ios::binary);
    if (!in.read(head.data(), static_cast<std::streamsize>(head.size()))) return false;
    const std::uint32_t header = numberAt(head, kFileHeader);
    return head.starts_with("BM") && (header == 108 || header == 124);
}

std::optional<std::string> asOldBmp(std::string bytes) {
    const std::size_t header = numberAt(bytes, kFileHeader);
    const std::size_t pixels = numberAt(bytes, 10);
    const bool masks = numberAt(bytes, 30) == kBitFields;
    const std::size_t kept = kOldHeader + (masks ? kMasks : 0);
    const std::size_t cut = header - kept;
    if (bytes.size() < kFileHeader + header || pixels < kFileHeader + header) return std::nullopt;
    bytes.erase(kFileHeader + kept, cut);
    setNumber(bytes, 2, bytes.size());
    setNumber(bytes, 10, pixels - cut);
    setNumber(bytes, kFileHeader, kOldHeader);
    return bytes;
}

}  // namespace

Dataset openNewBmp(const std::string& file) {
    if (!isNewBmp(file)) return nullptr;
    const auto bytes = readTextFile(file);
    const auto old = bytes ? asOldBmp(*bytes) : std::nullopt;
    if (!old) return nullptr;
    const std::string name =
        "/vsimem/" + std::to_string(reinterpret_cast<std::uintptr_t>(&*old)) + ".bmp";
    VSILFILE* out = VSIFOpenL(name.c_str(), "wb");
    if (!out) return nullptr;
    const bool whole = VSIFWriteL(old->data(), 1, old->size(), out) == old->size();
    VSIFCloseL(out);
    constexpr std::array<const char*, 2> kBmp{"BMP", nullptr};
    Dataset dataset(whole ? GDALDataset::Open(name.c_str(), GDAL_OF_RASTER, kBmp.data()) : nullptr);
    VSIUnlink(name.c_str());  // the dataset keeps what it has open
    return dataset;
}

}  // namespace hedr
