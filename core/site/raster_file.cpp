#include "core/site/raster_file.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <gdal_utils.h>

#include <array>
#include <new>
#include <string>
#include <system_error>
#include <utility>

namespace hedr {
namespace {

constexpr double kMostPixels = 1.2e9;
constexpr double kPyramidShare = 4.0 / 3.0;  // of all levels, to the full size
constexpr double kMostOfMemory = 0.8;

// Not GDALClose: that would close a dataset that a view on it still refers to.
struct DatasetReleaser {
    void operator()(GDALDataset* dataset) const { dataset->Release(); }
};
using Dataset = std::unique_ptr<GDALDataset, DatasetReleaser>;

// Keeps GDAL quiet on this thread and remembers what it would have printed last.
class GdalReason {
  public:
    GdalReason() { CPLPushErrorHandlerEx(&GdalReason::remember, &text_); }
    ~GdalReason() { CPLPopErrorHandler(); }
    GdalReason(const GdalReason&) = delete;
    GdalReason& operator=(const GdalReason&) = delete;

    const std::string& text() const { return text_; }

  private:
    static void CPL_STDCALL remember(CPLErr severity, CPLErrorNum, const char* message) {
        if (severity < CE_Failure) return;
        *static_cast<std::string*>(CPLGetErrorHandlerUserData()) = message;
    }

    std::string text_;
};

struct ProgressState {
    const PlanProgress& report;
    bool canceled = false;
};

int CPL_STDCALL onProgress(double share, const char*, void* state_ptr) {
    auto& state = *static_cast<ProgressState*>(state_ptr);
    if (!state.report(share)) state.canceled = true;
    return state.canceled ? FALSE : TRUE;
}

Result<void> checkFile(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) return fail(ErrorCode::kFileMissing, file.string());
    if (!std::filesystem::is_regular_file(status)) {
        return fail(ErrorCode::kFileUnreadable, file.string(), "not a regular file");
    }
    if (VSILFILE* opened = VSIFOpenL(file.c_str(), "rb")) {
        VSIFCloseL(opened);
        return {};
    }
    return fail(ErrorCode::kFileUnreadable, file.string(), "cannot be opened for reading");
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

Dataset asBytes(Dataset source) {
    std::vector<std::string> words = viewOptions(*source);
    if (words.empty()) return source;
    words.insert(words.begin(), {"-of", "VRT"});
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    GDALTranslateOptions* options = GDALTranslateOptionsNew(arguments.data(), nullptr);
    int usage_error = 0;
    Dataset view(GDALDataset::FromHandle(
        GDALTranslate("", GDALDataset::ToHandle(source.get()), options, &usage_error)));
    GDALTranslateOptionsFree(options);
    return view;  // the view holds its own reference to the source
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

bool fits(GDALDataset& dataset, std::size_t channels) {
    const double pixels = static_cast<double>(dataset.GetRasterXSize()) * dataset.GetRasterYSize();
    const double bytes = kPyramidShare * pixels * static_cast<double>(channels);
    const auto memory = static_cast<double>(CPLGetUsablePhysicalRAM());
    return pixels <= kMostPixels && (memory <= 0.0 || bytes <= kMostOfMemory * memory);
}

// Reads some bands, or all where `bands` is empty, side by side into pixels of `stride` bytes.
bool readBands(GDALDataset& dataset, std::vector<int> bands, std::uint8_t* pixels, int stride,
               ProgressState& progress) {
    GDALRasterIOExtraArg extra;
    INIT_RASTERIO_EXTRA_ARG(extra);
    if (progress.report) {
        extra.pfnProgress = &onProgress;
        extra.pProgressData = &progress;
    }
    const int width = dataset.GetRasterXSize();
    const int height = dataset.GetRasterYSize();
    const int count = bands.empty() ? dataset.GetRasterCount() : static_cast<int>(bands.size());
    return dataset.RasterIO(GF_Read, 0, 0, width, height, pixels, width, height, GDT_Byte, count,
                            bands.empty() ? nullptr : bands.data(), stride,
                            static_cast<GSpacing>(stride) * width, 1, &extra) == CE_None;
}

std::uint8_t onWhite(unsigned value, unsigned opacity) {
    if (opacity == 255) return static_cast<std::uint8_t>(value);
    return static_cast<std::uint8_t>((value * opacity + 255U * (255U - opacity) + 127U) / 255U);
}

// What is transparent shows the paper below.
bool layOnWhite(GDALDataset& dataset, std::vector<std::uint8_t>& pixels, int channels) {
    GDALRasterBand& band = *dataset.GetRasterBand(1);
    const int flags = band.GetMaskFlags();
    if ((flags & GMF_PER_DATASET) == 0 || (flags & GMF_ALL_VALID) != 0) return true;
    const int width = dataset.GetRasterXSize();
    std::vector<std::uint8_t> opacity(static_cast<std::size_t>(width));
    std::uint8_t* value = pixels.data();
    for (int row = 0; row < dataset.GetRasterYSize(); ++row) {
        if (band.GetMaskBand()->RasterIO(GF_Read, 0, row, width, 1, opacity.data(), width, 1,
                                         GDT_Byte, 0, 0, nullptr) != CE_None) {
            return false;
        }
        for (const unsigned alpha : opacity) {
            for (int i = 0; i < channels; ++i, ++value) *value = onWhite(*value, alpha);
        }
    }
    return true;
}

// RGB, or RGBA, packed at the front of `pixels`, becomes BGRA on white in the same place.
void unpack(std::vector<std::uint8_t>& pixels, std::size_t packed_channels) {
    for (std::size_t i = pixels.size() / 4; i-- > 0;) {
        const std::uint8_t* from = &pixels[packed_channels * i];
        const unsigned red = from[0];
        const unsigned green = from[1];
        const unsigned blue = from[2];
        const unsigned alpha = packed_channels == 4 ? from[3] : 255;
        std::uint8_t* to = &pixels[4 * i];
        to[0] = onWhite(blue, alpha);
        to[1] = onWhite(green, alpha);
        to[2] = onWhite(red, alpha);
        to[3] = 255;
    }
}

bool isPackedColour(GDALDataset& dataset, const std::vector<int>& bands) {
    const int count = dataset.GetRasterCount();
    const bool alpha_last =
        count == 4 && dataset.GetRasterBand(4)->GetColorInterpretation() == GCI_AlphaBand;
    return bands == std::vector{3, 2, 1} && (count == 3 || alpha_last);
}

// GDAL decodes PNG and JPEG in one pass where all bands are taken in the file's own order.
bool readPixels(GDALDataset& dataset, const std::vector<int>& bands,
                std::vector<std::uint8_t>& pixels, int channels, ProgressState& progress) {
    if (!isPackedColour(dataset, bands)) {
        return readBands(dataset, bands, pixels.data(), channels, progress) &&
               layOnWhite(dataset, pixels, channels);
    }
    const int packed = dataset.GetRasterCount();
    if (!readBands(dataset, {}, pixels.data(), packed, progress)) return false;
    unpack(pixels, static_cast<std::size_t>(packed));
    return packed == 4 || layOnWhite(dataset, pixels, channels);
}

tl::unexpected<Error> notAnImage(const std::filesystem::path& file, const GdalReason& reason) {
    const bool unknown =
        reason.text().empty() || reason.text().find("not recognized") != std::string::npos;
    return fail(ErrorCode::kNotAnImage, file.string(),
                unknown ? "not a known image format" : reason.text());
}

// An image of white pixels to read into. Error: kImageTooLarge.
Result<std::shared_ptr<std::vector<std::uint8_t>>> blankPixels(GDALDataset& dataset, int channels,
                                                               const std::string& path) {
    const auto too_large = [&] {
        return fail(ErrorCode::kImageTooLarge, path,
                    std::to_string(dataset.GetRasterXSize()) + " x " +
                        std::to_string(dataset.GetRasterYSize()) + " pixels");
    };
    if (!fits(dataset, static_cast<std::size_t>(channels))) return too_large();
    try {
        return std::make_shared<std::vector<std::uint8_t>>(
            static_cast<std::size_t>(dataset.GetRasterXSize()) *
                static_cast<std::size_t>(dataset.GetRasterYSize()) *
                static_cast<std::size_t>(channels),
            std::uint8_t{255});
    } catch (const std::bad_alloc&) {
        return too_large();
    }
}

}  // namespace

Result<PlanLevel> readRaster(const std::filesystem::path& file, const PlanProgress& progress) {
    if (const auto checked = checkFile(file); !checked) {
        return tl::make_unexpected(checked.error());
    }
    GDALAllRegister();
    const GdalReason reason;
    Dataset source(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR));
    if (!source || source->GetRasterCount() == 0) return notAnImage(file, reason);
    const Dataset dataset = asBytes(std::move(source));
    if (!dataset) return notAnImage(file, reason);

    const std::vector<int> bands = bandsOf(*dataset);
    const int channels = bands.size() == 1 ? 1 : 4;
    const auto pixels = blankPixels(*dataset, channels, file.string());
    if (!pixels) return tl::make_unexpected(pixels.error());
    ProgressState state{progress};
    const bool read = readPixels(*dataset, bands, **pixels, channels, state);
    if (state.canceled) return fail(ErrorCode::kCanceled, file.string());
    if (!read) return notAnImage(file, reason);
    return PlanLevel{dataset->GetRasterXSize(), dataset->GetRasterYSize(), channels, *pixels};
}

Result<void> savePlanImage(const PlanLevel& image, const std::filesystem::path& png_file) {
    GDALAllRegister();
    const GdalReason reason;
    const int bands = image.channels == 1 ? 1 : 3;
    GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
    GDALDriver* png = GetGDALDriverManager()->GetDriverByName("PNG");
    if (!memory || !png)
        return fail(ErrorCode::kFileUnwritable, png_file.string(), "no PNG driver");
    const Dataset picture(
        memory->Create("", image.width_px, image.height_px, bands, GDT_Byte, nullptr));
    std::array<int, 3> order = {3, 2, 1};
    if (bands == 1) order[0] = 1;
    auto* pixels = const_cast<std::uint8_t*>(image.pixels->data());  // GDAL only reads them
    const bool copied =
        picture &&
        picture->RasterIO(GF_Write, 0, 0, image.width_px, image.height_px, pixels, image.width_px,
                          image.height_px, GDT_Byte, bands, order.data(), image.channels,
                          static_cast<GSpacing>(image.channels) * image.width_px, 1,
                          nullptr) == CE_None;
    const Dataset written(
        copied ? png->CreateCopy(png_file.c_str(), picture.get(), FALSE, nullptr, nullptr, nullptr)
               : nullptr);
    if (!written) return fail(ErrorCode::kFileUnwritable, png_file.string(), reason.text());
    return {};
}

}  // namespace hedr
