#include "core/site/raster/companions.h"

#include <cpl_string.h>

namespace hedr {
namespace {

namespace fs = std::filesystem;

bool isNamedLike(const std::string& name, const std::string& start) {
    return EQUALN(name.c_str(), start.c_str(), start.size());
}

}  // namespace

Companions companionsOf(const fs::path& image) {
    Companions found;
    std::error_code error;
    const std::string start = image.stem().string() + '.';
    const fs::path folder = image.has_parent_path() ? image.parent_path() : fs::path(".");
    for (fs::directory_iterator file(folder, error), end; !error && file != end;
         file.increment(error)) {
        std::string name = file->path().filename().string();
        if (!isNamedLike(name, start)) continue;
        std::error_code dangling;
        const fs::file_status status = file->status(dangling);
        if (fs::is_regular_file(status)) {
            found.regular.push_back(std::move(name));
        } else if (fs::is_other(status)) {
            found.special = std::move(name);
        }
    }
    return found;
}

}  // namespace hedr
