#pragma once

#include <QLabel>
#include <QVBoxLayout>
#include <vector>

#include "core/calibration/calibration.h"
#include "ui/calibration/scroll_box.h"
#include "ui/panels/card.h"

namespace hedr {

class FigureRow;
class FoundRow;
class ProofBars;
class VerdictBox;

// What was found, what proves it, and the verdict, which always is in sight.
class ResultCard : public Card {
    Q_OBJECT

  public:
    explicit ResultCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setRoomy(bool roomy);
    void show(const Calibration& calibration);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void alignColumns();

    QLabel* caption_;
    QWidget* rows_area_;
    QVBoxLayout* rows_column_;
    QVBoxLayout* found_column_;
    QVBoxLayout* figures_column_;
    QFrame* line_;
    QLabel* proof_title_;
    ProofBars* proof_;
    QLabel* remarks_;
    ScrollBox* scroll_;
    VerdictBox* verdict_;
    std::vector<FoundRow*> found_{};
    std::vector<FigureRow*> figures_{};
    bool roomy_ = true;
};

}  // namespace hedr
