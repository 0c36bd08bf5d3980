#pragma once

#include <QAbstractButton>
#include <QImage>

#include "ui/theme.h"

namespace hedr {

// A floor of the list: a small picture of it, its name, and what is on it.
class FloorRow : public QAbstractButton {
    Q_OBJECT

  public:
    static constexpr int kHeight_px = 60;
    static constexpr QSize kPicture{72, 48};

    explicit FloorRow(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void setFloor(const QString& name, const QString& note, bool shown);
    void setPicture(const QImage& picture);
    QSize sizeHint() const override { return {280, kHeight_px}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    Theme theme_ = dayTheme();
    QString note_;
    QImage picture_;
};

}  // namespace hedr
