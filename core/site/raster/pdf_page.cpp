#include "core/site/raster/pdf_page.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/site/raster/raster_picture.h"

namespace hedr {
namespace {

constexpr double kInch_mm = 25.4;
constexpr double kMeasuringDpi = 300.0;

tl::unexpected<Error> pdfError(const std::string& path, const Error& error) {
    if (error.code == ErrorCode::kFileUnreadable) return tl::make_unexpected(error);
    const std::string& why = error.detail;
    const bool locked = why.find("assword") != std::string::npos;
    return fail(ErrorCode::kNotAnImage, path,
                locked ? "the PDF is protected by a password" : "damaged PDF: " + why);
}

Result<Dataset> openPage(const std::filesystem::path& file, int page, double dpi,
                         const GdalReason& reason) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << "DPI=" << dpi;
    auto dataset =
        openRaster("PDF:" + std::to_string(page) + ':' + file.string(), reason, {text.str()});
    if (!dataset) return pdfError(file.string(), dataset.error());
    return dataset;
}

Result<int> pageCount(const std::filesystem::path& file, const GdalReason& reason) {
    const auto document = openRaster(file.string(), reason);
    if (!document) return pdfError(file.string(), document.error());
    char** pages = (*document)->GetMetadata("SUBDATASETS");
    return std::max(1, CSLCount(pages) / 2);  // a name and a description each
}

PlanPage pageOf(GDALDataset& measured, const PictureJob& job) {
    const double to_mm = kInch_mm / kMeasuringDpi;
    PlanPage page;
    page.paper_width_mm = to_mm * measured.GetRasterXSize();
    page.paper_height_mm = to_mm * measured.GetRasterYSize();
    const double dpi = dpiOf(job, std::max(page.paper_width_mm, page.paper_height_mm));
    page.width_px = static_cast<int>(std::lround(page.paper_width_mm / kInch_mm * dpi));
    page.height_px = static_cast<int>(std::lround(page.paper_height_mm / kInch_mm * dpi));
    return page;
}

}  // namespace

Result<Picture> loadPdf(const std::filesystem::path& file, const PictureJob& job) {
    const GdalReason reason;
    const auto pages = pageCount(file, reason);
    if (!pages) return tl::make_unexpected(pages.error());
    const int number = job.choice.page;
    if (number < 1 || number > *pages) {
        return fail(ErrorCode::kBadValue, file.string(),
                    "there is no page " + std::to_string(number) + ", the last one is " +
                        std::to_string(*pages));
    }
    const auto measured = openPage(file, number, kMeasuringDpi, reason);
    if (!measured) return tl::make_unexpected(measured.error());
    const PlanPage page = pageOf(**measured, job);
    const double dpi = dpiOf(job, std::max(page.paper_width_mm, page.paper_height_mm));
    auto opened = openPage(file, number, dpi, reason);
    if (!opened) return tl::make_unexpected(opened.error());
    constexpr int kLongestSide_px =
        65500;  // what is longer is no plan; GDAL has a least resolution
    const int width_px = (*opened)->GetRasterXSize();
    const int height_px = (*opened)->GetRasterYSize();
    if (std::max(width_px, height_px) > kLongestSide_px) {
        return fail(ErrorCode::kImageTooLarge, file.string(),
                    std::to_string(width_px) + " x " + std::to_string(height_px) + " pixels");
    }
    const auto where = georeferenceOf(**opened, file.string());
    if (!where) return tl::make_unexpected(where.error());
    auto picture = pictureOf(std::move(*opened), *where, file.string(), job);
    if (picture && !picture->placement) {
        picture->placement = PlanPlacement{.resolution_m = pageResolution_m(job.choice, dpi)};
    }
    return picture;
}

Result<PlanDescription> describePdf(const std::filesystem::path& file, const PictureJob& job) {
    const GdalReason reason;
    const auto pages = pageCount(file, reason);
    if (!pages) return tl::make_unexpected(pages.error());
    PlanDescription description{"PDF", {}};
    for (int number = 1; number <= *pages; ++number) {
        const auto measured = openPage(file, number, kMeasuringDpi, reason);
        if (!measured) return tl::make_unexpected(measured.error());
        description.pages.push_back(pageOf(**measured, job));
    }
    return description;
}

}  // namespace hedr
