#pragma once

#include <QAbstractButton>

#include "ui/calibration/procedure_list.h"
#include "ui/theme.h"

namespace hedr {

// One line of the list of calibrations.
class ProcedureRow : public QAbstractButton {
    Q_OBJECT

  public:
    explicit ProcedureRow(QWidget* parent);
    void setTheme(const Theme& theme);
    void show(const ProcedureEntry& entry);
    const QString& procedure() const { return entry_.procedure; }
    QSize sizeHint() const override { return {560, 64}; }
    QSize minimumSizeHint() const override { return {320, 64}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;  // only Space is its own

  private:
    Theme theme_ = dayTheme();
    ProcedureEntry entry_{};
};

}  // namespace hedr
