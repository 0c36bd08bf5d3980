#pragma once

#include <QWidget>

#include "ui/theme.h"

namespace hedr {

// The strip above a calibration: which one, of which robot, where it stands.
class PageHeader : public QWidget {
    Q_OBJECT

  public:
    explicit PageHeader(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void setMargin(int margin_px);
    void show(const QString& title, const QString& context);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    Theme theme_ = dayTheme();
    int margin_px_ = 32;
    QString title_{};
    QString context_{};
};

}  // namespace hedr
