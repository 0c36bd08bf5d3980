#pragma once

#include <QLabel>
#include <QPushButton>

#include "ui/panels/card.h"

namespace hedr {

// Says something that can be answered in two ways. It lies on the map and stops nothing.
class ChoiceNote : public Card {
    Q_OBJECT

  public:
    struct Answer {
        QString text;
        QString tip;
    };

    ChoiceNote(const Answer& first, const Answer& second, QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setText(const QString& text);
    int widthWithin(int width_px) const;

  signals:
    void firstChosen();
    void secondChosen();

  private:
    QLabel* text_;
    QPushButton* first_;
    QPushButton* second_;
};

}  // namespace hedr
