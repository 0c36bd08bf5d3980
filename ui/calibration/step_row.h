#pragma once

#include <QLabel>
#include <QWidget>

#include "core/calibration/evidence.h"
#include "ui/theme.h"

namespace hedr {

// One step of what there is to do: its number in a circle, or a check mark where it is done.
class StepRow : public QWidget {
    Q_OBJECT

  public:
    enum class State { kDone, kNow, kLater };

    StepRow(int number, QWidget* parent);
    void setTheme(const Theme& theme);
    void show(const CalibrationStep& step, State state);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    int number_;
    State state_ = State::kLater;
    Theme theme_ = dayTheme();
    QLabel* title_;
    QLabel* detail_;
};

}  // namespace hedr
