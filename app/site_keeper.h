#pragma once

#include <QObject>
#include <QTimer>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/site/site.h"
#include "ui/background_job.h"
#include "ui/plan_file_wish.h"

namespace hedr {

class MainWindow;
class SiteModel;

// Reads the images of the window's site, and keeps the site in a file, so that the operator never
// has to think of saving: beside the first image, or where he opened one; where nothing can be
// written there, in the program's own folder.
class SiteKeeper : public QObject {
    Q_OBJECT

  public:
    SiteKeeper(MainWindow& window, QObject* parent);
    ~SiteKeeper() override;

    // After those that are being opened: an image, which is put on top, or with an empty window the
    // site that was kept of it; or a site file, which takes the place of the site there is.
    void open(const PlanFileWish& wish);
    void openSite(const Site& site, const std::filesystem::path& site_file);
    // Keeps the site in that file from now on; where it cannot be written, where it was kept.
    void saveAs(const std::filesystem::path& site_file);
    void cancel();

  signals:
    void opened(const hedr::PlanFileWish& wish);
    void saved(const QString& site_file);  // as the operator wished
    void imageAdded(const hedr::PlanImage& plan);
    void failed(const hedr::Error& error);

  private:
    struct Opened;  // a site, or an image
    // The image that is seen already, but not loaded yet.
    struct Preview {
        std::filesystem::path file{};
        int page = 1;
        std::size_t floor = 0;
    };

    void openNext();
    void show(const PlanImage& coarse, int page);
    void withdrawPreview();
    void take(const PlanFileWish& wish, Result<Opened> opened);
    void loadNextMissing();
    void give(const SitePlan& plan, const PlanImage& file, const PlanImage& shown);
    void miss(const SitePlan& plan, const Error& why);
    void checkNextHash();
    void tellChangedImages();
    void keepSoon();
    void keep();
    Site siteWithHashes() const;

    MainWindow& window_;
    SiteModel& site_;
    BackgroundJob loading_;
    BackgroundJob hashing_;
    std::deque<PlanFileWish> waiting_{};
    std::vector<SitePlan> unreadable_{};
    std::map<std::filesystem::path, Result<std::string>>
        hashes_{};                       // of the images as they are now
    std::filesystem::path site_file_{};  // empty: nothing to keep yet
    bool named_by_operator_ = false;     // that file: he must know when it can no longer be written
    std::optional<Preview> preview_{};
    bool adding_ = false;     // an image alone is nothing to keep
    bool hash_owed_ = false;  // kept before the images were read through
    QTimer keep_timer_;
};

}  // namespace hedr
