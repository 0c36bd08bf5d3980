#pragma once

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QString>
#include <QVBoxLayout>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/calibration/history/vehicle_history.h"
#include "core/calibration/history/vehicle_update.h"
#include "core/robot/vehicle.h"
#include "ui/calibration/calibration_view.h"
#include "ui/theme.h"

namespace hedr {

class HistoryCard;
class HistoryList;
class PageHeader;

struct HistoryView {
    QString robot{};                      // "PackBot 3"
    QString vehicle_file{};               // whose history it is
    std::vector<HistoryEntry> entries{};  // the earliest first, as loadHistory gives them
    std::optional<Vehicle> now{};         // as the vehicle file has it; none: it cannot be read
    QString news{};                       // what came of the last wish
};

// What was found when: the calibrations of a robot, one of them in detail beside what its vehicle
// file says now. It reads and writes no file; it says which entry shall be restored or exported.
class HistoryPage : public QWidget {
    Q_OBJECT

  public:
    explicit HistoryPage(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    // The chosen entry stays chosen where it is still there; else it is the newest.
    void show(const HistoryView& view);
    void focusFirst();  // the list; where that is empty, the way back

  signals:
    void closed();
    void restoreWished(const QString& entry, hedr::RestoreTo to);
    void exportWished(const QString& entry);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;  // Esc leaves

  private:
    void layOut();
    void choose(const QString& entry);
    void showChosen();
    void showState(QPushButton& button, const PageButton& state);
    void fitList();
    const HistoryEntry* chosenEntry() const;  // nullptr: there is none

    Theme theme_ = dayTheme();
    HistoryView view_{};
    QString chosen_{};
    PageHeader* header_;
    HistoryList* list_;
    HistoryCard* card_;
    QPushButton* back_;
    QPushButton* export_;
    QPushButton* before_;
    QPushButton* after_;
    QLabel* promise_;
    QHBoxLayout* cards_;
    QHBoxLayout* buttons_;
    QVBoxLayout* below_header_;
};

}  // namespace hedr
