#pragma once

#include <QImage>

#include "ui/panels/row_button.h"

namespace hedr {

// One line of a list of plans: a small picture, a name, and below it where it is.
class PlanRow : public RowButton {
    Q_OBJECT

  public:
    PlanRow(const QString& icon, const QString& name, const QString& detail, QWidget* parent);
    void setPicture(const QImage& picture);  // in the place of the icon
    QSize sizeHint() const override { return {400, 64}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void paintPicture(QPainter& painter, const QRect& place) const;

    QString icon_;
    QString detail_;
    QImage picture_;
};

}  // namespace hedr
