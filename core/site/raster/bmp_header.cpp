#include "core/site/raster/bmp_header.h"

#include <cstdint>
#include <cstring>

namespace hedr {
namespace {

constexpr std::size_t kFileHeader = 14;
constexpr std::size_t kOldHeader = 40;
constexpr std::size_t kMasks = 12;  // behind an old header, within a new one
constexpr std::uint32_t kBitFields = 3;

std::uint32_t numberAt(std::string_view bytes, std::size_t at) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + at, sizeof number);  // little-endian, as we are
    return number;
}

void setNumber(std::string& bytes, std::size_t at, std::size_t number) {
    const auto small = static_cast<std::uint32_t>(number);
    std::memcpy(bytes.data() + at, &small, sizeof small);
}

}  // namespace

bool isNewBmp(std::string_view bytes) {
    if (bytes.size() < kFileHeader + kOldHeader || !bytes.starts_with("BM")) return false;
    const std::uint32_t header = numberAt(bytes, kFileHeader);
    return header == 108 || header == 124;
}

std::optional<std::string> asOldBmp(std::string bytes) {
    if (!isNewBmp(bytes)) return std::nullopt;
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

}  // namespace hedr
