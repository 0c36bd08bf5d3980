#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <vector>

#include "ui/link/request_board.h"
#include "ui/live_model.h"
#include "ui/panels/titled_card.h"

namespace hedr {

// What can be asked of the robot: its parameters, read and written, and commands. A parameter that
// was typed over is marked until it is written and read back.
class RobotCard : public TitledCard {
    Q_OBJECT

  public:
    explicit RobotCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    // `whose`: the robot's call sign where there are several; `refusal`: why nothing can be asked,
    // empty where it can.
    void show(const RequestBoard& board, const QString& whose, const QString& refusal);

  signals:
    void asked(const hedr::Request& request);
    void poseWished();  // the robot shall take over ours
    void cancelWished();

  private:
    struct Row {
        ParameterMeaning meaning;
        QLabel* name;
        QLineEdit* value;
        QLabel* state;
        QString shown{};  // the robot's value, as it stands in the field
    };
    void addRow(const ParameterMeaning& meaning, QGridLayout& grid);
    void layOut(QGridLayout& grid);
    void showRow(Row& row, const RequestBoard& board);
    void showCommand(const RequestBoard& board);
    void readAtFirst(const RequestBoard& board);
    void readAll();
    void writeChanged();
    bool changed(const Row& row) const;
    void updateButtons();

    QLabel* refusal_;
    std::vector<Row> rows_;
    QPushButton* read_;
    QPushButton* write_;
    std::vector<QPushButton*> commands_;
    QLabel* outcome_;
    QPushButton* cancel_;
    bool read_at_first_ = false;  // asked, and not heard of since
    bool busy_ = false;
    bool refused_ = false;
};

}  // namespace hedr
