#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <vector>

#include "radio/publish/pose_publisher.h"
#include "ui/panels/titled_card.h"

namespace hedr {

// Which other programs are told where the robots are. Everything is off until the operator switches
// it on, also after the next start.
class PublishCard : public TitledCard {
    Q_OBJECT

  public:
    explicit PublishCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void show(const std::vector<PublishState>& states);  // of what is on

  signals:
    void targetsWished(const std::vector<hedr::PublishTarget>& targets);

  private:
    struct Row {
        PublishKind kind;
        QCheckBox* on;
        QLineEdit* address;
        QLabel* state;
    };
    void addRow(PublishKind kind);
    void wish();
    void showRow(const Row& row, const PublishState* state);
    void say(const Row& row, const QString& text, bool trouble);

    QLabel* what_;
    std::vector<Row> rows_;
};

}  // namespace hedr
