#pragma once

#include "ui/calibration/procedure_list.h"
#include "ui/panels/row_button.h"

namespace hedr {

// One line of the list of calibrations.
class ProcedureRow : public RowButton {
    Q_OBJECT

  public:
    explicit ProcedureRow(QWidget* parent);
    void show(const ProcedureEntry& entry);
    const QString& procedure() const { return entry_.procedure; }
    QSize sizeHint() const override { return {560, 64}; }
    QSize minimumSizeHint() const override { return {320, 64}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    ProcedureEntry entry_{};
};

}  // namespace hedr
