#pragma once

#include <QFileDialog>
#include <QLabel>

#include "ui/site/plan_glance.h"

namespace hedr {

class PlanGlancer;

// Chooses files of plans, and shows at its side what is in the one that is marked.
class OpenPlanDialog : public QFileDialog {
    Q_OBJECT

  public:
    // `glancer` looks at the files; it outlives the dialog.
    OpenPlanDialog(PlanGlancer& glancer, const Theme& theme, QWidget* parent = nullptr);

    void showSitesOnly();  // at first

  private:
    void addPane();
    void look(const QString& file);
    void show(const PlanFileWish& file, const PlanGlance& glance);

    PlanGlancer& glancer_;
    Theme theme_;
    QLabel* picture_;
    QLabel* name_;
    QLabel* words_;
    QString file_{};
};

// What may be chosen: everything that is a plan, its kinds, everything.
QStringList planNameFilters();

}  // namespace hedr
