#pragma once

#include <QLabel>
#include <QString>
#include <QVBoxLayout>
#include <optional>
#include <vector>

#include "core/calibration/calibration.h"
#include "ui/calibration/scroll_box.h"
#include "ui/panels/row_list_card.h"

namespace hedr {

class ProcedureRow;

// A calibration that can be done, and how it went the last time.
struct ProcedureEntry {
    QString procedure;  // by which it is known to the program
    QString title;      // "Gyro bias"
    QString purpose;    // one line of what it is for
    QString last{};     // "12 Nov, accepted"; empty: never
    std::optional<Verdict> verdict{};
};

// Which calibration to do.
class ProcedureList : public RowListCard {
    Q_OBJECT

  public:
    explicit ProcedureList(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void show(const std::vector<ProcedureEntry>& entries);

  signals:
    void chosen(const QString& procedure);

  protected:
    std::vector<RowButton*> rows() const override;
    void reached(RowButton* row) override;

  private:
    QLabel* title_;
    QWidget* rows_area_;
    QVBoxLayout* rows_column_;
    ScrollBox* scroll_;
    std::vector<ProcedureRow*> rows_{};
};

}  // namespace hedr
