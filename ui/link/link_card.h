#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <vector>

#include "ui/link/link_figures.h"
#include "ui/link/link_plot.h"
#include "ui/panels/titled_card.h"

namespace hedr {

// The link in figures, now and as it was. Opened by a click on the tile LINK.
class LinkCard : public TitledCard {
    Q_OBJECT

  public:
    explicit LinkCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    // `whose`: the robot's call sign where there are several.
    void show(const LiveModel& model, const QString& whose);

  private:
    struct Row {
        QLabel* label;
        QLabel* value;
    };
    void showFigures(const std::vector<LinkFigure>& figures);
    void chooseSpan(std::size_t index);

    QGridLayout* figures_;
    LinkPlot* plot_;
    std::vector<Row> rows_;
    std::vector<QPushButton*> spans_;
    std::size_t span_ = 0;
};

}  // namespace hedr
