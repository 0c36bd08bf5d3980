#include "core/site/raster/raster_pixels.h"

#include <gdal_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/site/raster/blank_pixels.h"
#include "core/site/raster/packed_pixels.h"

namespace hedr {
namespace {

struct ProgressState {
    const PlanProgress& report;
    bool canceled = false;
};

int CPL_STDCALL onProgress(double share, const char*, void* state_ptr) {
    auto& state = *static_cast<ProgressState*>(state_ptr);
    if (!state.report(share)) state.canceled = true;
    return state.canceled ? FALSE : TRUE;
}

bool isGreyPalette(const GDALColorTable& palette) {
    for (int i = 0; i < palette.GetColorEntryCount(); ++i) {
        const GDALColorEntry& entry = *palette.GetColorEntry(i);
        if (entry.c1 != entry.c2 || entry.c2 != entry.c3 || entry.c4 != 255) return false;
    }
    return true;
}

int bitsOf(GDALRasterBand& band) {
    const char* bits = band.GetMetadataItem("NBITS", "IMAGE_STRUCTURE");
    return bits ? std::atoi(bits) : GDALGetDataTypeSizeBits(band.GetRasterDataType());
}

// The options of gdal_translate that make a view of 8-bit grey or colour; none where it is one.
std::vector<std::string> viewOptions(GDALDataset& dataset) {
    GDALRasterBand& band = *dataset.GetRasterBand(1);
    if (const GDALColorTable* palette = band.GetColorTable()) {
        return {"-expand", isGreyPalette(*palette) ? "gray" : "rgba"};
    }
    const GDALDataType type = band.GetRasterDataType();
    if (type == GDT_Byte && bitsOf(band) == 8) return {};
    if (type == GDT_Byte || type == GDT_UInt16) {
        const std::string white = std::to_string((1 << bitsOf(band)) - 1);
        return {"-ot", "Byte", "-scale", "0", white, "0", "255"};
    }
    return {"-ot", "Byte", "-scale"};
}

// Bands in the order of BGRA, or one for grey.
std::vector<int> bandsOf(GDALDataset& dataset) {
    std::vector<int> colours;
    std::array<int, 3> blue_green_red{};
    for (int i = 1; i <= dataset.GetRasterCount(); ++i) {
        const GDALColorInterp meaning = dataset.GetRasterBand(i)->GetColorInterpretation();
        if (meaning == GCI_BlueBand) blue_green_red[0] = i;
        if (meaning == GCI_GreenBand) blue_green_red[1] = i;
        if (meaning == GCI_RedBand) blue_green_red[2] = i;
        if (meaning != GCI_AlphaBand) colours.push_back(i);
    }
    if (colours.size() < 3) return {1};
    if (blue_green_red[0] * blue_green_red[1] * blue_green_red[2] == 0) {
        return {colours[2], colours[1], colours[0]};
    }
    return {blue_green_red.begin(), blue_green_red.end()};
}

// What may be read in the file's own order, side by side.
Packing packingOf(GDALDataset& dataset) {
    const int count = dataset.GetRasterCount();
    if (count != 3 && count != 4) return Packing::kNone;
    if (count == 4) {
        if (dataset.GetRasterBand(1)->GetColorInterpretation() == GCI_CyanBand) {
            return Packing::kCmyk;
        }
        const bool alpha = dataset.GetRasterBand(4)->GetColorInterpretation() == GCI_AlphaBand;
        if (!alpha) return Packing::kNone;
    }
    if (bandsOf(dataset) != std::vector{3, 2, 1}) return Packing::kNone;
    return count == 3 ? Packing::kRgb : Packing::kRgba;
}

bool isWhite(const std::vector<std::uint8_t>& pixels) {
    return std::ranges::all_of(pixels, [](std::uint8_t value) { return value == 255; });
}

bool isWhole(const RasterWindow& window, GDALDataset& dataset) {
    return window.width >= dataset.GetRasterXSize() && window.height >= dataset.GetRasterYSize();
}

bool isScaled(const RasterWindow& window) {
    return window.width != window.width_px || window.height != window.height_px;
}

GDALRasterIOExtraArg extraOf(const RasterWindow& window, ProgressState& progress) {
    GDALRasterIOExtraArg extra;
    INIT_RASTERIO_EXTRA_ARG(extra);
    if (progress.report) {
        extra.pfnProgress = &onProgress;
        extra.pProgressData = &progress;
    }
    if (!isScaled(window)) return extra;
    extra.eResampleAlg = GRIORA_Average;
    extra.bFloatingPointWindowValidity = TRUE;
    extra.dfXOff = window.left;
    extra.dfYOff = window.top;
    extra.dfXSize = window.width;
    extra.dfYSize = window.height;
    return extra;
}

struct PixelBox {
    int left;
    int top;
    int width;
    int height;
};

// The dataset's pixels that a window touches.
PixelBox boxOf(const RasterWindow& window, int width, int height) {
    const int left = std::clamp(static_cast<int>(window.left), 0, width - 1);
    const int top = std::clamp(static_cast<int>(window.top), 0, height - 1);
    const double right = std::ceil(window.left + window.width);
    const double bottom = std::ceil(window.top + window.height);
    return {left, top, std::clamp(static_cast<int>(right) - left, 1, width - left),
            std::clamp(static_cast<int>(bottom) - top, 1, height - top)};
}

// Reads some bands, or all where `bands` is empty, side by side into pixels of `stride` bytes.
bool readBands(GDALDataset& dataset, const RasterWindow& window, std::vector<int> bands,
               std::uint8_t* pixels, int stride, ProgressState& progress) {
    GDALRasterIOExtraArg extra = extraOf(window, progress);
    const PixelBox box = boxOf(window, dataset.GetRasterXSize(), dataset.GetRasterYSize());
    const int count = bands.empty() ? dataset.GetRasterCount() : static_cast<int>(bands.size());
    return dataset.RasterIO(GF_Read, box.left, box.top, box.width, box.height, pixels,
                            window.width_px, window.height_px, GDT_Byte, count,
                            bands.empty() ? nullptr : bands.data(), stride,
                            static_cast<GSpacing>(stride) * window.width_px, 1, &extra) == CE_None;
}

// What is transparent shows the paper below.
bool layOnWhite(GDALDataset& dataset, const RasterWindow& window, std::vector<std::uint8_t>& pixels,
                int channels) {
    GDALRasterBand& band = *dataset.GetRasterBand(1);
    const int flags = band.GetMaskFlags();
    if ((flags & GMF_PER_DATASET) == 0 || (flags & GMF_ALL_VALID) != 0) return true;
    // Row by row where that is possible, so that the mask takes no room.
    const int rows = isScaled(window) ? window.height_px : 1;
    std::vector<std::uint8_t> opacity(static_cast<std::size_t>(window.width_px) *
                                      static_cast<std::size_t>(rows));
    PixelBox box = boxOf(window, dataset.GetRasterXSize(), dataset.GetRasterYSize());
    if (rows == 1) box.height = 1;
    std::uint8_t* value = pixels.data();
    for (int row = 0; row < window.height_px; row += rows, ++box.top) {
        if (band.GetMaskBand()->RasterIO(GF_Read, box.left, box.top, box.width, box.height,
                                         opacity.data(), window.width_px, rows, GDT_Byte, 0, 0,
                                         nullptr) != CE_None) {
            return false;
        }
        for (const unsigned alpha : opacity) {
            for (int i = 0; i < channels; ++i, ++value) *value = onWhite(*value, alpha);
        }
    }
    return true;
}

// GDAL decodes PNG and JPEG in one pass where all bands are taken in the file's own order.
bool readPixels(GDALDataset& dataset, const RasterWindow& window, std::vector<std::uint8_t>& pixels,
                ProgressState& progress) {
    const Packing packing = packingOf(dataset);
    if (packing == Packing::kNone) {
        const std::vector<int> bands = bandsOf(dataset);
        const int channels = bands.size() == 1 ? 1 : 4;
        return readBands(dataset, window, bands, pixels.data(), channels, progress) &&
               layOnWhite(dataset, window, pixels, channels);
    }
    const int packed = dataset.GetRasterCount();
    if (!readBands(dataset, window, {}, pixels.data(), packed, progress)) return false;
    unpack(pixels, packing);
    return packing != Packing::kRgb || layOnWhite(dataset, window, pixels, 4);
}

}  // namespace

RasterWindow wholeWindow(GDALDataset& dataset) {
    const int width = dataset.GetRasterXSize();
    const int height = dataset.GetRasterYSize();
    return {0.0, 0.0, static_cast<double>(width), static_cast<double>(height), width, height};
}

Dataset asBytes(Dataset source) {
    std::vector<std::string> words = viewOptions(*source);
    if (words.empty()) return source;
    words.insert(words.begin(), {"-of", "VRT"});
    GdalWords arguments(std::move(words));
    GDALTranslateOptions* options = GDALTranslateOptionsNew(arguments.get(), nullptr);
    int usage_error = 0;
    Dataset view(GDALDataset::FromHandle(
        GDALTranslate("", GDALDataset::ToHandle(source.get()), options, &usage_error)));
    GDALTranslateOptionsFree(options);
    return view;  // it holds its own reference to the source
}

int channelsOf(GDALDataset& dataset) { return bandsOf(dataset).size() == 1 ? 1 : 4; }

Result<PlanLevel> readWindow(GDALDataset& dataset, const RasterWindow& window,
                             const std::string& path, const PlanProgress& progress) {
    const GdalReason reason;
    const int channels = channelsOf(dataset);
    const auto pixels = blankPixels(window.width_px, window.height_px, channels, path);
    if (!pixels) return tl::make_unexpected(pixels.error());
    ProgressState state{progress};
    const bool read = readPixels(dataset, window, **pixels, state);
    if (state.canceled) return fail(ErrorCode::kCanceled, path);
    if (reason.cutOff()) {
        return fail(ErrorCode::kNotAnImage, path, "damaged or cut off: it ends too early");
    }
    if (!read) return fail(ErrorCode::kNotAnImage, path, "damaged or cut off: " + reason.text());
    // Of a tile of an MBTiles GDAL complains, leaves it white and goes on. A part may well be
    // white.
    if (!reason.text().empty() && isWhole(window, dataset) && isWhite(**pixels)) {
        return fail(ErrorCode::kNotAnImage, path,
                    "damaged: nothing that is on it could be read (" + reason.text() + ")");
    }
    return PlanLevel{window.width_px, window.height_px, channels, *pixels};
}

}  // namespace hedr
