#pragma once

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/panels/card.h"

namespace hedr {

// A card that is called and closed again: its title, a cross beside it, and below what derives.
class TitledCard : public Card {
    Q_OBJECT

  public:
    TitledCard(const QString& title, QWidget* parent);
    void setTheme(const Theme& theme) override;

  signals:
    void closeWished();  // by the cross, or by Esc

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    // `whose`: a robot's call sign where there are several; empty: the title alone.
    void sayWhose(const QString& whose);
    QVBoxLayout& column() { return *column_; }

  private:
    QString text_;
    QLabel* title_;
    QPushButton* close_;
    QVBoxLayout* column_;
};

}  // namespace hedr
