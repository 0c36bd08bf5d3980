#pragma once

#include <QAbstractButton>
#include <QImage>

#include "ui/theme.h"

namespace hedr {

// One line of a list of plans: a small picture, a name, and below it where it is.
class PlanRow : public QAbstractButton {
    Q_OBJECT

  public:
    PlanRow(const QString& icon, const QString& name, const QString& detail, QWidget* parent);
    void setTheme(const Theme& theme);
    void setPicture(const QImage& picture);  // in the place of the icon
    QSize sizeHint() const override { return {400, 64}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;  // only Space is its own

  private:
    void paintPicture(QPainter& painter, const QRect& place) const;

    Theme theme_ = dayTheme();
    QString icon_;
    QString detail_;
    QImage picture_;
};

}  // namespace hedr
