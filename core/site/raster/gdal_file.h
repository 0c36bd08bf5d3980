#pragma once

#include <gdal_priv.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"

namespace hedr {

// Not GDALClose: that would close a dataset that a view on it still refers to.
struct DatasetReleaser {
    void operator()(GDALDataset* dataset) const { dataset->Release(); }
};
using Dataset = std::unique_ptr<GDALDataset, DatasetReleaser>;

// Keeps GDAL quiet on this thread and remembers what it would have printed last.
class GdalReason {
  public:
    GdalReason();
    ~GdalReason();
    GdalReason(const GdalReason&) = delete;
    GdalReason& operator=(const GdalReason&) = delete;

    const std::string& text() const { return text_; }
    // A JPEG ended too early: GDAL fills it up with grey and only warns.
    bool cutOff() const { return cut_off_; }
    void remember(bool failure, const std::string& message);

  private:
    std::string text_;
    bool cut_off_ = false;
};

// Words for GDAL's functions, which take arrays of pointers that end with a null.
class GdalWords {
  public:
    explicit GdalWords(std::vector<std::string> words);
    char** get() { return pointers_.data(); }

  private:
    std::vector<std::string> words_;
    std::vector<char*> pointers_;
};

// Opens a raster of the formats that plans come in, and of no others: a file must not make GDAL
// ask a server or read other files. `name` is a path or the name of a page. A pipe or a device
// named like a companion (plan.pgw) is passed over, and where the format's reader would open it all
// the same, the image is refused. Errors: kNotAnImage, kFileUnreadable.
Result<Dataset> openRaster(const std::string& name, const GdalReason& reason,
                           std::vector<std::string> options = {});

// What GDAL complained of, as an error of that file.
tl::unexpected<Error> notAnImage(const std::string& path, const GdalReason& reason);

bool isFormat(GDALDataset& dataset, const char* driver);

}  // namespace hedr
