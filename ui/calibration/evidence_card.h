#pragma once

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <vector>

#include "core/calibration/evidence.h"
#include "ui/panels/card.h"

namespace hedr {

class EvidencePlotView;
class PlotLegend;

// The samples, one plot at a time; where there are several, one is chosen above.
class EvidenceCard : public Card {
    Q_OBJECT

  public:
    explicit EvidenceCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setRoomy(bool roomy);
    void show(const std::vector<EvidencePlot>& plots);
    // The tabs come and go; Tab goes to them from there.
    void setTabsAfter(QWidget* before) { before_tabs_ = before; }

  private:
    void makeTabs(const QStringList& titles);
    void showChosen();

    QLabel* caption_;
    QWidget* tabs_row_;
    QHBoxLayout* tabs_;
    QButtonGroup* group_;
    EvidencePlotView* plot_;
    PlotLegend* legend_;
    std::vector<EvidencePlot> plots_{};
    QStringList titles_{};
    QWidget* before_tabs_ = nullptr;
};

}  // namespace hedr
