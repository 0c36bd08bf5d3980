#include "core/site/raster/ground_overlay.h"

#include <cpl_minixml.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "core/geometry/angle.h"
#include "core/site/plan_format.h"
#include "core/site/raster/raster_picture.h"
#include "core/text/number.h"
#include "core/text/text_file.h"

namespace hedr {
namespace {

struct Overlay {
    std::string image;  // a path, or GDAL's name of a file in an archive
    bool archived = false;
    double north_deg = 0.0;
    double south_deg = 0.0;
    double east_deg = 0.0;
    double west_deg = 0.0;
    double rotation_deg = 0.0;  // counter-clockwise, about the middle
};

std::string archiveName(const std::filesystem::path& file) { return "/vsizip/" + file.string(); }

struct FileCloser {
    void operator()(VSILFILE* file) const { (void)VSIFCloseL(file); }
};

struct XmlDeleter {
    void operator()(CPLXMLNode* node) const { CPLDestroyXMLNode(node); }
};

Result<double> degrees(CPLXMLNode* box, const char* key, const std::string& path) {
    const char* text = CPLGetXMLValue(box, key, nullptr);
    if (!text) return fail(ErrorCode::kMissingKey, path, key);
    const auto value = parseNumber(text);
    if (value && std::isfinite(*value) && std::abs(*value) <= 360.0) return *value;
    return fail(ErrorCode::kBadValue, path, std::string(key) + " must be a number of degrees");
}

Result<void> readBox(CPLXMLNode* box, Overlay& overlay, const std::string& path) {
    const std::array<std::pair<const char*, double*>, 4> fields = {{{"north", &overlay.north_deg},
                                                                    {"south", &overlay.south_deg},
                                                                    {"east", &overlay.east_deg},
                                                                    {"west", &overlay.west_deg}}};
    for (const auto& [key, field] : fields) {
        const auto value = degrees(box, key, path);
        if (!value) return tl::make_unexpected(value.error());
        *field = *value;
    }
    if (CPLGetXMLNode(box, "rotation")) {
        const auto value = degrees(box, "rotation", path);
        if (!value) return tl::make_unexpected(value.error());
        overlay.rotation_deg = *value;
    }
    if (overlay.north_deg > 90.0 || overlay.south_deg < -90.0 ||
        overlay.north_deg <= overlay.south_deg || overlay.east_deg <= overlay.west_deg) {
        return fail(ErrorCode::kBadValue, path, "LatLonBox has no area on the globe");
    }
    return {};
}

// The name of the KML in an archive; doc.kml where there are several.
std::optional<std::string> documentIn(const std::string& archive) {
    const CPLStringList names(VSIReadDir(archive.c_str()));
    std::optional<std::string> found;
    for (int i = 0; i < names.size(); ++i) {
        const std::string name = names[i];
        if (!name.ends_with(".kml")) continue;
        if (!found || name == "doc.kml") found = name;
    }
    return found;
}

Result<std::string> readArchived(const std::filesystem::path& file) {
    constexpr std::size_t kLongest = std::size_t{4} << 20;  // what is packed may be a bomb
    const std::string archive = archiveName(file);
    const auto document = documentIn(archive);
    if (!document) return fail(ErrorCode::kNotAnImage, file.string(), "the archive has no .kml");
    const std::unique_ptr<VSILFILE, FileCloser> in(
        VSIFOpenL((archive + '/' + *document).c_str(), "rb"));
    std::string text(kLongest, '\0');
    if (in) text.resize(VSIFReadL(text.data(), 1, text.size(), in.get()));
    if (!in || text.size() == kLongest) {
        return fail(ErrorCode::kBadFormat, file.string(), *document + " cannot be unpacked");
    }
    return text;
}

Result<Overlay> readOverlay(const std::filesystem::path& file) {
    const bool archived = isArchivedOverlay(file);
    const GdalReason quiet;
    const auto text = archived ? readArchived(file) : readTextFile(file);
    if (!text) return tl::make_unexpected(text.error());
    const std::string path = file.string();
    const GdalReason reason;
    const std::unique_ptr<CPLXMLNode, XmlDeleter> tree(CPLParseXMLString(text->c_str()));
    if (!tree) return fail(ErrorCode::kBadFormat, path, reason.text());
    CPLStripXMLNamespace(tree.get(), nullptr, TRUE);
    CPLXMLNode* overlay_node = CPLSearchXMLNode(tree.get(), "=GroundOverlay");
    if (!overlay_node) return fail(ErrorCode::kMissingKey, path, "GroundOverlay");
    const char* image = CPLGetXMLValue(overlay_node, "Icon.href", nullptr);
    if (!image) return fail(ErrorCode::kMissingKey, path, "Icon/href");
    CPLXMLNode* box = CPLGetXMLNode(overlay_node, "LatLonBox");
    if (!box) return fail(ErrorCode::kMissingKey, path, "LatLonBox");
    Overlay overlay{
        .image = archived ? archiveName(file) + '/' + image : (file.parent_path() / image).string(),
        .archived = archived};
    const auto read = readBox(box, overlay, path);
    if (!read) return tl::make_unexpected(read.error());
    return overlay;
}

// The box turned about its middle, where degrees of longitude are as long as those of latitude.
Georeference placeOf(const Overlay& overlay, int width_px, int height_px) {
    const Eigen::Vector2d middle(0.5 * (overlay.west_deg + overlay.east_deg),
                                 0.5 * (overlay.south_deg + overlay.north_deg));
    const double stretch = std::cos(radFromDeg(middle.y()));
    const double c = std::cos(radFromDeg(overlay.rotation_deg));
    const double s = std::sin(radFromDeg(overlay.rotation_deg));
    Eigen::Matrix2d turn;
    turn << c, -s / stretch, s * stretch, c;
    Eigen::Matrix2d size;
    size << (overlay.east_deg - overlay.west_deg) / width_px, 0.0, 0.0,
        -(overlay.north_deg - overlay.south_deg) / height_px;
    const Eigen::Matrix2d linear = turn * size;
    const Eigen::Vector2d half(0.5 * width_px, 0.5 * height_px);
    return {{linear, middle - linear * half}, globeInDegrees()};
}

Result<Dataset> openImage(const Overlay& overlay, const std::filesystem::path& file,
                          const GdalReason& reason) {
    if (auto checked = checkPlanFile(overlay.image); !overlay.archived && !checked) {
        checked.error().detail = "named in " + file.string();
        return tl::make_unexpected(checked.error());
    }
    return openRaster(overlay.image, reason);
}

}  // namespace

Result<Picture> loadGroundOverlay(const std::filesystem::path& file, const PictureJob& job) {
    const auto overlay = readOverlay(file);
    if (!overlay) return tl::make_unexpected(overlay.error());
    const GdalReason reason;
    auto image = openImage(*overlay, file, reason);
    if (!image) return tl::make_unexpected(image.error());
    const Georeference where =
        placeOf(*overlay, (*image)->GetRasterXSize(), (*image)->GetRasterYSize());
    return pictureOf(std::move(*image), where, overlay->image, job);
}

Result<PlanDescription> describeGroundOverlay(const std::filesystem::path& file) {
    const auto overlay = readOverlay(file);
    if (!overlay) return tl::make_unexpected(overlay.error());
    const GdalReason reason;
    return openImage(*overlay, file, reason).map([&](const Dataset& image) {
        return PlanDescription{isArchivedOverlay(file) ? "KMZ" : "KML",
                               {{image->GetRasterXSize(), image->GetRasterYSize()}}};
    });
}

}  // namespace hedr
