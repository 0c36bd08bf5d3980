#pragma once

#include <QObject>
#include <QRect>
#include <QStringList>
#include <deque>
#include <vector>

#include "ui/background_job.h"
#include "ui/site/plan_glancer.h"
#include "ui/theme.h"

namespace hedr {

class Card;
class OpenPlanDialog;
class PageCard;
class RecentPlansCard;

// The way from "open a plan" to the file, the page and the scale that are meant: recent plans, the
// file dialog, the pages of a file. At most one of its cards is open.
class PlanOpener : public QObject {
    Q_OBJECT

  public:
    PlanOpener(QWidget* map, QWidget* window);  // the cards lie on the map

    void setTheme(const Theme& theme);
    void setRecentFiles(const QStringList& files) { recent_files_ = files; }
    void ask();  // or, where a card is open, closes it
    void askForSite();
    void offer(const QStringList& files);     // to be opened, one after the other
    Card* openCard() const { return card_; }  // nullptr: none

  signals:
    void chosen(const hedr::PlanFileWish& wish);
    void cardChanged();  // also its size

  private:
    void showRecent(const QStringList& files);
    OpenPlanDialog* openDialog();
    void askForPages();  // of the next file that is offered
    void showPages(const QString& file, const std::vector<QString>& pages);
    void choose(const PlanFileWish& wish);
    void closeCard();           // and goes on with what else is offered
    void showCard(Card* card);  // nullptr: none
    void give(const PlanFileWish& file, const PlanGlance& glance);

    QWidget* window_;
    Theme theme_ = dayTheme();
    QStringList recent_files_{};
    std::deque<QString> offered_{};
    PlanGlancer glancer_;
    BackgroundJob recent_job_;
    BackgroundJob pages_job_;
    RecentPlansCard* recent_;
    PageCard* pages_;
    Card* card_ = nullptr;
};

}  // namespace hedr
