#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <array>
#include <map>
#include <optional>

#include "core/site/wall_stroke.h"
#include "ui/panels/card.h"

namespace hedr {

// The card beside the map while walls are drawn: pen or eraser, how wide, and what the colours say.
class WallsCard : public Card {
    Q_OBJECT

  public:
    explicit WallsCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;

    WallPen pen() const { return pen_; }
    double width_m() const;  // of the pen that is chosen
    void setVerdict(const QString& text);
    void setProgress(std::optional<double> progress);  // 0..1; none: nothing is being computed

  signals:
    void penChosen(hedr::WallPen pen);

  private:
    QPushButton* segment(const QString& text, const QString& tip, Qt::Key key);
    void addPens(QLayout& row);
    void addWidths(QLayout& row);
    void showChoice();

    WallPen pen_ = WallPen::kWall;
    std::map<WallPen, std::size_t> width_;  // each pen has its own
    std::map<WallPen, QPushButton*> pens_{};
    std::vector<QPushButton*> widths_{};
    QLabel* width_label_;
    std::array<QLabel*, 2> swatches_{};
    std::array<QLabel*, 2> colours_{};
    QLabel* verdict_;
    QProgressBar* bar_;
};

}  // namespace hedr
