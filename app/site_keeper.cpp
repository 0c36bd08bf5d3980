#include "app/site_keeper.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "app/site_place.h"
#include "core/site/image_hash.h"
#include "core/site/site_file.h"
#include "core/site/survey/rectified_plan.h"
#include "core/text/file_hash.h"
#include "ui/error_text.h"
#include "ui/main_window.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

constexpr int kKeepAfter_ms = 500;  // changes come in bursts

bool isSiteFile(const fs::path& file) { return file.string().ends_with(kSiteFileExtension); }

// The pixels of a plan of a site: of its file, and as the site shows them.
struct LoadedPlan {
    PlanImage file{};
    PlanImage shown{};
};

Result<LoadedPlan> loadSitePlan(const SitePlan& plan, const PlanProgress& progress) {
    const auto image = loadPlan(plan.image_file, progress, {}, {.page = plan.page});
    if (!image) return tl::make_unexpected(image.error());
    if (!plan.straightened) return LoadedPlan{*image, *image};
    return rectifiedPlan(*image, *plan.straightened, progress).map([&](PlanImage&& flat) {
        return LoadedPlan{*image, std::move(flat)};
    });
}

bool lacksHashes(const Site& site) {
    return std::ranges::any_of(site.floors, [](const SiteFloor& floor) {
        return std::ranges::any_of(floor.plans,
                                   [](const SitePlan& plan) { return plan.sha256.empty(); });
    });
}

}  // namespace

struct SiteKeeper::Opened {
    std::optional<Site> site{};
    fs::path site_file{};
    std::optional<PlanImage> image{};
};

SiteKeeper::SiteKeeper(MainWindow& window, QObject* parent)
    : QObject(parent), window_(window), site_(window.desk().site()) {
    keep_timer_.setSingleShot(true);
    connect(&keep_timer_, &QTimer::timeout, this, &SiteKeeper::keep);
    connect(&site_, &SiteModel::kept, this, &SiteKeeper::keepSoon);
    connect(&loading_, &BackgroundJob::progressed, this,
            [this](double share) { window_.showPlanProgress(share); });
}

SiteKeeper::~SiteKeeper() {
    if (keep_timer_.isActive()) keep();
}

void SiteKeeper::open(const PlanFileWish& wish) {
    waiting_.push_back(wish);
    if (!loading_.running()) openNext();
}

void SiteKeeper::cancel() {
    waiting_.clear();
    loading_.cancel();
    withdrawPreview();
    for (const SitePlan& plan : site_.plansWithoutImage()) unreadable_.push_back(plan);
    window_.showPlanProgress(std::nullopt);
}

void SiteKeeper::openNext() {
    if (waiting_.empty()) return loadNextMissing();
    const PlanFileWish wish = waiting_.front();
    waiting_.pop_front();
    window_.showPlanProgress(0.0);
    const bool nothing_yet = std::ranges::all_of(
        site_.site().floors, [](const SiteFloor& f) { return f.plans.empty(); });
    const auto preview = [this, page = wish.choice.page,
                          job = loading_.job()](const PlanImage& coarse) {
        QMetaObject::invokeMethod(this, [this, page, job, coarse] {
            if (loading_.running() && job + 1 == loading_.job()) show(coarse, page);
        });
    };
    loading_.start(
        [wish, nothing_yet, preview](const PlanProgress& progress) -> Result<Opened> {
            const fs::path file = fs::absolute(wish.file.toStdString());
            const auto site_file = isSiteFile(file) ? std::optional(file)
                                   : nothing_yet    ? keptSiteOf(file)
                                                    : std::nullopt;
            if (site_file) {
                return readSite(*site_file).map([&](Site&& site) {
                    return Opened{.site = std::move(site), .site_file = *site_file};
                });
            }
            return loadPlan(file, progress, preview, wish.choice).map([](PlanImage&& image) {
                return Opened{.image = std::move(image)};
            });
        },
        [this, wish](Result<Opened> opened) { take(wish, std::move(opened)); });
}

void SiteKeeper::take(const PlanFileWish& wish, Result<Opened> opened) {
    window_.showPlanProgress(std::nullopt);
    if (!opened) {
        withdrawPreview();
        emit failed(opened.error());
        return openNext();
    }
    emit this->opened(wish);
    if (opened->site) return openSite(*opened->site, opened->site_file);
    if (opened->image) {
        adding_ = true;
        window_.setPlan(*opened->image, wish.choice.page);
        preview_.reset();
        adding_ = false;
        emit imageAdded(*opened->image);
    }
    openNext();
}

// A first coarse view, so that nobody waits for the whole image.
void SiteKeeper::show(const PlanImage& coarse, int page) {
    if (site_.image({.image_file = coarse.image_file, .page = page})) return;  // finer than this
    adding_ = true;
    if (window_.setPlan(coarse, page)) {
        preview_ = Preview{coarse.image_file, page, site_.floorIndex()};
    }
    adding_ = false;
}

void SiteKeeper::withdrawPreview() {
    if (!preview_) return;
    adding_ = true;
    window_.desk().withdrawImage(preview_->file, preview_->page, preview_->floor);
    adding_ = false;
    preview_.reset();
}

void SiteKeeper::openSite(const Site& site, const fs::path& site_file) {
    if (keep_timer_.isActive()) keep();
    adding_ = true;
    site_file_ = site_file;
    named_by_operator_ = false;
    unreadable_.clear();
    hashes_.clear();
    site_.open(site);
    adding_ = false;
    openNext();
}

// One after the other, and all there are before the hashes: they are to be seen first.
void SiteKeeper::loadNextMissing() {
    window_.showPlanProgress(std::nullopt);
    std::vector<SitePlan> missing = site_.plansWithoutImage();
    std::erase_if(missing, [&](const SitePlan& plan) {
        return std::ranges::find(unreadable_, plan) != unreadable_.end();
    });
    if (missing.empty()) return checkNextHash();
    const SitePlan plan = missing.front();
    window_.showPlanProgress(0.0);
    loading_.start([plan](const PlanProgress& progress) { return loadSitePlan(plan, progress); },
                   [this, plan](const Result<LoadedPlan>& loaded) {
                       loaded ? give(plan, loaded->file, loaded->shown)
                              : miss(plan, loaded.error());
                       openNext();
                   });
}

void SiteKeeper::give(const SitePlan& plan, const PlanImage& file, const PlanImage& shown) {
    SitePlan as_photo = plan;
    as_photo.straightened.reset();
    site_.giveImage(as_photo, file);
    site_.giveImage(plan, shown);
    window_.fitMap();
}

void SiteKeeper::miss(const SitePlan& plan, const Error& why) {
    unreadable_.push_back(plan);
    site_.warn(plan, errorText(why));
    emit failed(why);
}

// Whether the images are what they were when they were aligned.
void SiteKeeper::checkNextHash() {
    if (hashing_.running()) return;
    for (const SiteFloor& floor : site_.site().floors) {
        for (const SitePlan& plan : floor.plans) {
            if (hashes_.contains(plan.image_file) || !site_.image(plan)) continue;
            hashing_.start([file = plan.image_file](
                               const PlanProgress& progress) { return fileHash(file, progress); },
                           [this, plan](const Result<std::string>& hash) {
                               hashes_.insert_or_assign(plan.image_file, hash);
                               if (hash_owed_) keepSoon();
                               checkNextHash();
                           });
            return;
        }
    }
    tellChangedImages();
}

void SiteKeeper::tellChangedImages() {
    const auto known = [this](const fs::path& file) -> Result<std::string> {
        const auto hash = hashes_.find(file);
        if (hash == hashes_.end()) return fail(ErrorCode::kCanceled, file.string());
        return hash->second;
    };
    for (const ChangedImage& image : changedImages(site_.site(), known)) {
        const SitePlan& plan = site_.site().floors.at(image.floor).plans.at(image.plan);
        if (!site_.warning(plan).isEmpty()) continue;  // told already
        const Error changed{ErrorCode::kFileChanged, image.image_file.string(), {}};
        site_.warn(plan, errorText(changed));
        emit failed(changed);
    }
}

void SiteKeeper::keepSoon() {
    checkNextHash();
    if (adding_ && site_file_.empty()) return;
    if (!adding_) keep_timer_.start(kKeepAfter_ms);
}

void SiteKeeper::keep() {
    keep_timer_.stop();
    const Site site = siteWithHashes();
    hash_owed_ = lacksHashes(site);
    const auto with_plan =
        std::ranges::find_if(site.floors, [](const SiteFloor& f) { return !f.plans.empty(); });
    if (site_file_.empty() && with_plan == site.floors.end()) return;
    if (site_file_.empty()) site_file_ = unusedSiteFile(with_plan->plans.front().image_file);
    const auto kept = writeSite(site, site_file_);
    if (!kept && named_by_operator_) emit failed(kept.error());
    if (kept || with_plan == site.floors.end()) return;
    named_by_operator_ = false;
    site_file_ = siteFileInOwnFolder(with_plan->plans.front().image_file);
    if (const auto written = writeSite(site, site_file_); !written) emit failed(written.error());
}

void SiteKeeper::saveAs(const fs::path& site_file) {
    const fs::path whole = fs::absolute(site_file);
    const Site site = siteWithHashes();
    if (const auto written = writeSite(site, whole); !written) {
        return emit failed(written.error());
    }
    hash_owed_ = lacksHashes(site);
    keep_timer_.stop();
    site_file_ = whole;
    named_by_operator_ = true;
    emit saved(QString::fromStdString(whole.string()));
}

Site SiteKeeper::siteWithHashes() const {
    Site site = site_.settled();
    for (SiteFloor& floor : site.floors) {
        for (SitePlan& plan : floor.plans) {
            const auto known = hashes_.find(plan.image_file);
            if (!plan.sha256.empty() || known == hashes_.end()) continue;
            plan.sha256 = known->second.value_or(std::string());
        }
    }
    return site;
}

}  // namespace hedr
