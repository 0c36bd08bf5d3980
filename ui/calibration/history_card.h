#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <optional>
#include <string>
#include <vector>

#include "core/calibration/history/vehicle_history.h"
#include "core/robot/vehicle.h"
#include "ui/calibration/scroll_box.h"
#include "ui/panels/card.h"

namespace hedr {

class VerdictBox;

// A number of the vehicle file through a calibration, as it is read. All in one unit, with as many
// decimals; "–" where it is not known.
struct HistoryLine {
    QString name{};  // "Left wheel, mm"
    QString before{};
    QString found{};
    QString note{};  // "± 0.0021", and whether it stays; may be empty
    QString now{};   // as the vehicle file has it
    friend bool operator==(const HistoryLine&, const HistoryLine&) = default;
};
// What was found; where nothing was, the numbers that were changed all the same: it was restored.
std::vector<HistoryLine> historyLines(const CalibrationRecord& record,
                                      const std::optional<Vehicle>& now);

// One entry of the history: the numbers before, as they were found and now, and all that is known
// of them. The verdict always is in sight.
class HistoryCard : public Card {
    Q_OBJECT

  public:
    explicit HistoryCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setRoomy(bool roomy);
    void show(const HistoryEntry& entry, const std::optional<Vehicle>& now);

  private:
    struct Row {
        QLabel* name;
        QLabel* before;
        QLabel* found;
        QLabel* now;
        QLabel* note;  // below what was found
        void setVisible(bool visible) const;
    };

    void layOut();
    void addRow();
    void showLines(const std::vector<HistoryLine>& lines, const QString& found);
    void showRecord(const CalibrationRecord& record, const std::optional<Vehicle>& now);
    void showDamage();

    QLabel* caption_;
    QLabel* title_;
    QWidget* rows_area_;
    QVBoxLayout* rows_column_;
    QGridLayout* grid_;
    QLabel* remarks_;
    QLabel* facts_;
    ScrollBox* scroll_;
    VerdictBox* verdict_;
    std::string entry_{};      // its name
    std::vector<Row> rows_{};  // the first one says what the columns are
};

}  // namespace hedr
