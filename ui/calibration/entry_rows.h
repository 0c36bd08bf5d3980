#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "ui/calibration/calibration_view.h"

namespace hedr {

// What the operator may type in or tick, a line each. What is being typed is never overwritten.
class EntryRows : public QWidget {
    Q_OBJECT

  public:
    explicit EntryRows(QWidget* parent = nullptr);
    void show(const std::vector<PageEntry>& entries);

  signals:
    void edited(int index, const QString& text);

  private:
    struct Row {
        QLabel* label;
        QLineEdit* field;
        QCheckBox* box;  // instead of both
    };
    void addRow();
    void fill(int index, const PageEntry& entry);

    QVBoxLayout* column_;
    std::vector<Row> rows_{};
};

}  // namespace hedr
