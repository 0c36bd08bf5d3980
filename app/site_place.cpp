#include "app/site_place.h"

#include <QCryptographicHash>
#include <QDir>
#include <QStandardPaths>
#include <string>

#include "core/site/site_file.h"

namespace hedr {

namespace fs = std::filesystem;

fs::path siteFileBeside(const fs::path& image) { return image.string() + kSiteFileExtension; }

fs::path siteFileInOwnFolder(const fs::path& image) {
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/sites");
    (void)folder.mkpath(".");
    const QByteArray whole_path = QByteArray::fromStdString(image.string());
    const QByteArray mark =
        QCryptographicHash::hash(whole_path, QCryptographicHash::Sha1).toHex().left(8);
    const std::string name = image.filename().string() + '-' + mark.toStdString();
    return folder.filePath(QString::fromStdString(name + kSiteFileExtension)).toStdString();
}

fs::path unusedSiteFile(const fs::path& image) {
    std::error_code ignored;
    return fs::exists(siteFileBeside(image), ignored) ? siteFileInOwnFolder(image)
                                                      : siteFileBeside(image);
}

std::optional<fs::path> keptSiteOf(const fs::path& image) {
    for (const fs::path& file : {siteFileBeside(image), siteFileInOwnFolder(image)}) {
        std::error_code ignored;
        if (fs::is_regular_file(file, ignored)) return file;
    }
    return std::nullopt;
}

}  // namespace hedr
