#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <map>
#include <string>

#include "core/site/site.h"
#include "ui/background_job.h"

namespace hedr {

class MainWindow;
class SiteModel;

// Reads the images of the window's site, and keeps the site in its file: the operator never has to
// think of saving. The file lies beside the first image, or where the operator has opened or saved
// one; where nothing can be written, in the program's own folder.
class SiteKeeper : public QObject {
    Q_OBJECT

  public:
    SiteKeeper(MainWindow& window, QObject* parent);
    ~SiteKeeper() override;

    // An image or a placement file; or a site file, which takes the place of the site there is, as
    // the one does that was kept of an image.
    void open(const std::filesystem::path& file);
    void saveAs(const std::filesystem::path& file);
    void cancel();

  signals:
    void planLoaded(const hedr::PlanImage& plan);
    void failed(const hedr::Error& error);

  private:
    void openImage(const std::filesystem::path& file);
    void openSite(const std::filesystem::path& file);
    void loadMissing();
    void keep();
    void save();
    Site withHashes(Site site) const;

    MainWindow& window_;
    SiteModel& site_;
    BackgroundJob loading_;
    BackgroundJob hashing_;
    std::filesystem::path site_file_{};  // empty: nothing to keep yet
    std::map<std::filesystem::path, std::string> hashes_{};
    bool opening_ = false;
    QTimer save_timer_;
};

// Where a site is kept that was opened as an image: beside it, or, where that cannot be written, in
// the program's own folder.
std::filesystem::path siteFileBeside(const std::filesystem::path& image);
std::filesystem::path siteFileInOwnFolder(const std::filesystem::path& image);

}  // namespace hedr
