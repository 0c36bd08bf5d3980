#pragma once

#include <QLabel>
#include <QStringList>
#include <QVBoxLayout>
#include <string_view>
#include <vector>

#include "core/calibration/history/vehicle_history.h"
#include "ui/calibration/scroll_box.h"
#include "ui/panels/row_button.h"
#include "ui/panels/row_list_card.h"
#include "ui/panels/status_tiles.h"

namespace hedr {

// Text of a file as it may be shown: cleaned, and with places to break a line in words that are
// longer than any line.
QString shownWords(std::string_view text, std::size_t longest_bytes = 200);
// "12 Nov 2026, 13:30 · Ada", without what is empty.
QString listed(QStringList facts);

// An entry of the history in words; of one that cannot be read what its name tells.
struct HistoryText {
    QString title{};  // "Wheels by driving"
    QString when{};   // "12 Nov 2026, 13:30", local
    QString who{};
    QString surface{};
    QString verdict{};  // "accepted, not taken over"
    Tone tone = Tone::kDim;
};
HistoryText historyText(const HistoryEntry& entry);

// One line of the history. It is checked while it is the chosen one, and only then a stop of Tab.
class HistoryRow : public RowButton {
    Q_OBJECT

  public:
    explicit HistoryRow(QWidget* parent);
    void show(const HistoryEntry& entry);
    void setChosen(bool chosen);
    const QString& entry() const { return entry_; }
    QSize sizeHint() const override { return {400, 64}; }
    QSize minimumSizeHint() const override { return {240, 64}; }

  signals:
    void reached();  // by the focus

  protected:
    void paintEvent(QPaintEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void nextCheckState() override {}  // which one is chosen is the list's to say

  private:
    void paintChosen(QPainter& painter) const;

    QString entry_{};
    HistoryText text_{};
};

// The history of a robot, the newest first. The row that has the focus is the chosen one.
class HistoryList : public RowListCard {
    Q_OBJECT

  public:
    explicit HistoryList(QWidget* parent);
    void setTheme(const Theme& theme) override;
    void setRoomy(bool roomy);
    // The earliest first, as they come; `entry` is the chosen one.
    void show(const std::vector<HistoryEntry>& entries, const QString& entry);
    void choose(const QString& entry);
    void focusChosen();

  signals:
    void chosen(const QString& entry);

  protected:
    std::vector<RowButton*> rows() const override;
    void reached(RowButton* row) override;

  private:
    void addRow();
    HistoryRow* chosenRow() const;

    QLabel* caption_;
    QLabel* empty_;
    QWidget* rows_area_;
    QVBoxLayout* rows_column_;
    ScrollBox* scroll_;
    std::vector<HistoryRow*> rows_{};
    std::size_t shown_ = 0;  // so many of the rows
};

}  // namespace hedr
