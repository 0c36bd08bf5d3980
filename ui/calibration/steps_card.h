#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <vector>

#include "ui/calibration/calibration_view.h"
#include "ui/calibration/scroll_box.h"
#include "ui/panels/card.h"

namespace hedr {

class EntryRows;
class StepRow;

// What to do, and how much is known already.
class StepsCard : public Card {
    Q_OBJECT

  public:
    explicit StepsCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setRoomy(bool roomy);
    void show(const CalibrationView& view);
    QWidget* lastInTabOrder() const { return procedure_action_; }

  signals:
    void procedureActionRequested();
    void entryEdited(int index, const QString& text);

  private:
    void showSteps(const std::vector<CalibrationStep>& steps);
    void showProgress(const CalibrationView& view);

    QLabel* caption_;
    QWidget* rows_area_;
    QVBoxLayout* rows_column_;
    EntryRows* entries_;
    ScrollBox* scroll_;
    QLabel* progress_title_;
    QLabel* percent_;
    QProgressBar* bar_;
    QLabel* known_;
    QPushButton* procedure_action_;
    std::vector<StepRow*> rows_{};
    std::size_t next_ = 0;  // the step to do
};

}  // namespace hedr
