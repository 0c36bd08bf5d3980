#include "core/site/raster/gdal_file.h"

#include <cpl_error.h>

#include <array>
#include <mutex>

#include "core/site/raster/bmp_file.h"
#include "core/site/raster/companions.h"

namespace hedr {
namespace {

// Tiles that GDAL keeps. By default that is a share of the machine's memory, and an image that is
// read once would stay in it beside our own pixels.
constexpr GIntBig kTileCacheBytes = GIntBig{64} << 20;

constexpr std::array<const char*, 14> kDrivers = {"PNG",     "JPEG",        "BMP", "GTiff", "WEBP",
                                                  "GIF",     "BIGGIF",      "PNM", "HEIF",  "PDF",
                                                  "MBTiles", "JP2OpenJPEG", "TGA", nullptr};

// Those that open nothing beside an image but what they are told of; the others go and look.
constexpr std::array<const char*, 6> kHeedingDrivers = {"PNG", "JPEG",   "WEBP",
                                                        "GIF", "BIGGIF", nullptr};

void registerOnce() {
    static std::once_flag once;
    std::call_once(once, [] {
        GDALAllRegister();
        GDALSetCacheMax64(kTileCacheBytes);
    });
}

void CPL_STDCALL rememberReason(CPLErr severity, CPLErrorNum, const char* message) {
    static_cast<GdalReason*>(CPLGetErrorHandlerUserData())
        ->remember(severity >= CE_Failure, message);
}

bool isUnknown(const GdalReason& reason) {
    return reason.text().empty() || reason.text().find("not recognized") != std::string::npos;
}

}  // namespace

GdalReason::GdalReason() {
    registerOnce();
    CPLPushErrorHandlerEx(&rememberReason, this);
}

void GdalReason::remember(bool failure, const std::string& message) {
    if (message.find("Premature end of JPEG") != std::string::npos) cut_off_ = true;
    if (failure) text_ = message;
}

GdalReason::~GdalReason() { CPLPopErrorHandler(); }

GdalWords::GdalWords(std::vector<std::string> words) : words_(std::move(words)) {
    for (std::string& word : words_) pointers_.push_back(word.data());
    pointers_.push_back(nullptr);
}

Result<Dataset> openRaster(const std::string& name, const GdalReason& reason,
                           std::vector<std::string> options) {
    GdalWords words(std::move(options));
    Companions beside = companionsOf(name);
    const bool wary = beside.special.has_value();
    // An empty list would mean that GDAL is to look itself.
    const bool told = !beside.regular.empty();
    GdalWords siblings(std::move(beside.regular));
    Dataset dataset(GDALDataset::Open(name.c_str(), GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR,
                                      wary ? kHeedingDrivers.data() : kDrivers.data(), words.get(),
                                      told ? siblings.get() : nullptr));
    if (!dataset) dataset = openNewBmp(name);
    if (dataset) return dataset;
    if (wary && isUnknown(reason)) {
        return fail(ErrorCode::kFileUnreadable, name,
                    "move " + *beside.special + " beside it away: it is not a regular file");
    }
    return notAnImage(name, reason);
}

tl::unexpected<Error> notAnImage(const std::string& path, const GdalReason& reason) {
    return fail(ErrorCode::kNotAnImage, path,
                isUnknown(reason) ? "not a known image format" : reason.text());
}

bool isFormat(GDALDataset& dataset, const char* driver) {
    return dataset.GetDriver() && std::string(driver) == dataset.GetDriver()->GetDescription();
}

}  // namespace hedr
