#include "core/site/plan_format.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string>

#include "core/site/plain_pnm.h"

namespace hedr {
namespace {

constexpr std::size_t kHeadBytes = 1024;

std::string headOf(const std::filesystem::path& file) {
    std::string head(kHeadBytes, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    return head;
}

bool hasExtension(const std::filesystem::path& file, const char* wanted) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == wanted;
}

// A drawing begins with the pair "0, SECTION", a comment (999) or, binary, with its own sentence.
bool looksLikeDxf(const std::string& head) {
    if (head.starts_with("AutoCAD Binary DXF")) return true;
    const std::size_t zero = head.find_first_not_of(" \t\r\n");
    return zero != std::string::npos && head[zero] == '0' &&
           head.substr(zero, 16).find("SECTION") != std::string::npos;
}

}  // namespace

PlanFormat planFormatOf(const std::filesystem::path& file) {
    if (isPlainPnm(file)) return PlanFormat::kPlainPnm;
    const std::string head = headOf(file);
    if (head.find("%PDF-") != std::string::npos) return PlanFormat::kPdf;
    const std::size_t first = head.find_first_not_of("\xEF\xBB\xBF \t\r\n");
    if (first != std::string::npos && head[first] == '<') {
        if (head.find("<kml") != std::string::npos) return PlanFormat::kGroundOverlay;
        if (head.find("<svg") != std::string::npos || hasExtension(file, ".svg")) {
            return PlanFormat::kSvg;
        }
        if (hasExtension(file, ".kml")) return PlanFormat::kGroundOverlay;
    }
    if (isArchivedOverlay(file)) return PlanFormat::kGroundOverlay;
    if (looksLikeDxf(head) || hasExtension(file, ".dxf")) return PlanFormat::kDxf;
    return PlanFormat::kRaster;
}

bool isArchivedOverlay(const std::filesystem::path& file) {
    return hasExtension(file, ".kmz") && headOf(file).starts_with("PK\x03\x04");
}

Result<void> checkPlanFile(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) return fail(ErrorCode::kFileMissing, file.string());
    if (!std::filesystem::is_regular_file(status)) {
        return fail(ErrorCode::kFileUnreadable, file.string(), "not a regular file");
    }
    if (!std::ifstream(file, std::ios::binary)) {
        return fail(ErrorCode::kFileUnreadable, file.string(), "cannot be opened for reading");
    }
    if (std::filesystem::file_size(file, error) == 0) {
        return fail(ErrorCode::kFileEmpty, file.string());
    }
    return {};
}

}  // namespace hedr
