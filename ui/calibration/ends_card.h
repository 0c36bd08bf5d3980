#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <vector>

#include "ui/calibration/clicked_ends.h"
#include "ui/panels/card.h"

namespace hedr {

// The ends of square drives that were clicked last, a line each, and where the pointer is.
class EndsCard : public Card {
    Q_OBJECT

  public:
    explicit EndsCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    // `pointer`: where it is; none: not on the map. `trouble`: what to mind first; may be empty.
    void show(const ClickedEnds& ends, std::optional<Point<World>> pointer, const QString& trouble);

  signals:
    void skipWished();

  private:
    struct Row {
        QLabel* run;
        QLabel* x;
        QLabel* y;
    };
    void addRow();
    void fill(const Row& row, const QString& run, std::optional<Vector<Robot>> way);

    QLabel* advice_;
    QGridLayout* grid_;
    std::vector<Row> rows_{};
    QPushButton* skip_;
};

}  // namespace hedr
