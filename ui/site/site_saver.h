#pragma once

#include <QObject>

#include "core/site/plan_copy.h"
#include "ui/site/save_dialog.h"

namespace hedr {

class SiteModel;

// The way from "save" to the file that is meant: a copy of a plan for another program, the site.
class SiteSaver : public QObject {
    Q_OBJECT

  public:
    SiteSaver(const SiteModel& site, QWidget* window);

    void setTheme(const Theme& theme) { theme_ = theme; }
    void askForCopy(std::size_t plan, PlanCopyKind kind);  // of the floor that is shown
    void askForSite();

  signals:
    void copyChosen(const hedr::PlanCopy& copy);
    void siteChosen(const QString& file);
    void refused(const QString& why);  // in one sentence

  private:
    SaveDialog* ask(const SaveQuestion& question);

    const SiteModel& site_;
    QWidget* window_;
    Theme theme_ = dayTheme();
};

}  // namespace hedr
