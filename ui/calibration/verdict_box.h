#pragma once

#include <QLabel>
#include <QWidget>

#include "ui/calibration/verdict_text.h"
#include "ui/theme.h"

namespace hedr {

// What lies below the words of a verdict: a breath of its colour.
QColor verdictGround(Tone tone, const Theme& theme);

// The verdict in its colour, with its mark, word and reason.
class VerdictBox : public QWidget {
    Q_OBJECT

  public:
    explicit VerdictBox(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void show(const VerdictText& text);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    Theme theme_ = dayTheme();
    VerdictText text_{};
    QLabel* word_;
    QLabel* interval_;
    QLabel* reason_;
};

}  // namespace hedr
