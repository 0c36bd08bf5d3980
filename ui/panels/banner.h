#pragma once

#include <QPushButton>
#include <vector>

#include "ui/panels/card.h"

namespace hedr {

// What a banner tells: each has its shape and its colour.
enum class BannerTone { kNews, kWarning, kAlarm };

// One sentence above the map, with a shape that tells its kind. Where it must be acknowledged it
// has a button, and what else there is to read waits behind it, alarms first; otherwise it leaves
// by itself when its text is empty.
class Banner : public Card {
    Q_OBJECT

  public:
    explicit Banner(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setText(const QString& text, BannerTone tone);
    void setAcknowledgeable(bool acknowledgeable);
    // To be read, too: beside what is shown and waits, but not the same twice.
    void add(const QString& text, BannerTone tone);
    const QString& text() const { return text_; }
    QSize sizeWithin(int width) const;

  signals:
    void acknowledged();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    struct Message {
        QString text;
        BannerTone tone;
        friend bool operator==(const Message&, const Message&) = default;
    };

    void acknowledge();
    void copyLine();
    void showInstead(const Message& message);
    void showButtonText();
    void showCopyButton();
    int buttonWidth() const;
    int copyWidth() const;
    int buttonRoom() const;
    void placeButtons();
    void paintSign(QPainter& painter, const QPointF& middle) const;

    QString text_;
    BannerTone tone_ = BannerTone::kWarning;
    bool acknowledgeable_ = false;
    std::vector<Message> waiting_{};  // behind the one that is shown
    QPushButton* button_;
    QPushButton* copy_button_;  // where the text has a line to type
};

}  // namespace hedr
