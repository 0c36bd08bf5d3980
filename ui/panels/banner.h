#pragma once

#include <QPushButton>

#include "ui/panels/card.h"

namespace hedr {

// What a banner tells: each has its shape and its colour.
enum class BannerTone { kNews, kWarning, kAlarm };

// One sentence above the map, with a shape that tells its kind. Where it must be acknowledged it
// has a button; otherwise it leaves by itself when its text is empty.
class Banner : public Card {
    Q_OBJECT

  public:
    explicit Banner(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setText(const QString& text, BannerTone tone);
    void setAcknowledgeable(bool acknowledgeable);
    const QString& text() const { return text_; }
    QSize sizeWithin(int width) const;

  signals:
    void acknowledged();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    int buttonRoom() const;
    void paintSign(QPainter& painter, const QPointF& middle) const;

    QString text_;
    BannerTone tone_ = BannerTone::kWarning;
    bool acknowledgeable_ = false;
    QPushButton* button_;
};

}  // namespace hedr
