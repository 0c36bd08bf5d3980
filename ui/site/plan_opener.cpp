#include "ui/site/plan_opener.h"

#include <QFileInfo>
#include <utility>

#include "ui/panels/card.h"
#include "ui/site/open_plan_dialog.h"
#include "ui/site/page_card.h"
#include "ui/site/recent_plans_card.h"

namespace hedr {
namespace {

QStringList existing(QStringList files) {
    files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
    return files;
}

}  // namespace

PlanOpener::PlanOpener(QWidget* map, QWidget* window)
    : QObject(window),
      window_(window),
      recent_(new RecentPlansCard(map)),
      pages_(new PageCard(map)) {
    connect(recent_, &RecentPlansCard::fileChosen, this,
            [this](const QString& file) { offer({file}); });
    connect(recent_, &RecentPlansCard::anotherWished, this, [this] {
        showCard(nullptr);
        openDialog();
    });
    connect(recent_, &RecentPlansCard::closeWished, this, &PlanOpener::closeCard);
    connect(pages_, &PageCard::closeWished, this, &PlanOpener::closeCard);
    connect(pages_, &PageCard::chosen, this, &PlanOpener::choose);
    connect(&glancer_, &PlanGlancer::glanced, this, &PlanOpener::give);
}

void PlanOpener::setTheme(const Theme& theme) {
    theme_ = theme;
    recent_->setTheme(theme);
    pages_->setTheme(theme);
}

// A disk that is gone may take its time to say so: not on the GUI thread.
void PlanOpener::ask() {
    if (card_) return closeCard();
    if (recent_files_.isEmpty()) {
        openDialog();
        return;
    }
    recent_job_.start([files = recent_files_](const PlanProgress&) { return existing(files); },
                      [this](const QStringList& files) { showRecent(files); });
}

void PlanOpener::showRecent(const QStringList& files) {
    if (files.isEmpty()) {
        openDialog();
        return;
    }
    recent_->setFiles(files);
    std::vector<PlanFileWish> wanted;
    for (const QString& file : files) wanted.push_back({.file = file});
    glancer_.want(std::move(wanted));
    showCard(recent_);
    recent_->focusFirst();
}

void PlanOpener::askForSite() {
    if (card_) closeCard();
    openDialog()->showSitesOnly();
}

OpenPlanDialog* PlanOpener::openDialog() {
    auto* dialog = new OpenPlanDialog(glancer_, theme_, window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (!recent_files_.isEmpty()) dialog->setDirectory(QFileInfo(recent_files_.front()).path());
    connect(dialog, &QFileDialog::filesSelected, this, &PlanOpener::offer);
    dialog->open();
    return dialog;
}

void PlanOpener::offer(const QStringList& files) {
    offered_.insert(offered_.end(), files.begin(), files.end());
    if (card_ == recent_) showCard(nullptr);
    if (!pages_job_.running() && !card_) askForPages();
}

void PlanOpener::askForPages() {
    if (offered_.empty()) return;
    const QString file = offered_.front();
    offered_.pop_front();
    pages_job_.start([file](const PlanProgress&) { return pagesToChooseFrom(file); },
                     [this, file](const std::vector<QString>& pages) {
                         pages.empty() ? choose({.file = file}) : showPages(file, pages);
                     });
}

void PlanOpener::showPages(const QString& file, const std::vector<QString>& pages) {
    pages_->setFile(file, pages);
    std::vector<PlanFileWish> wanted;
    for (int page = 1; page <= static_cast<int>(pages.size()); ++page) {
        wanted.push_back({.file = file, .choice = {.page = page}});
    }
    glancer_.want(std::move(wanted));
    showCard(pages_);
    pages_->focusFirst();
}

void PlanOpener::choose(const PlanFileWish& wish) {
    emit chosen(wish);
    closeCard();
}

void PlanOpener::closeCard() {
    showCard(nullptr);
    askForPages();
}

void PlanOpener::showCard(Card* card) {
    if (!card) glancer_.want({});
    if (card_) card_->setVisible(false);
    card_ = card;
    if (card_) card_->setVisible(true);
    emit cardChanged();
}

void PlanOpener::give(const PlanFileWish& file, const PlanGlance& glance) {
    recent_->setGlance(file.file, glance);
    pages_->setGlance(file, glance);
}

}  // namespace hedr
