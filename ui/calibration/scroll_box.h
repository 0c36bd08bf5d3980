#pragma once

#include <QScrollArea>

namespace hedr {

// A part of a card that scrolls where there is no room for all of it; then it can be reached by
// Tab, so that the arrows scroll it.
class ScrollBox : public QScrollArea {
    Q_OBJECT

  public:
    // How far it goes into the margins of its card on both sides, so that its content is in line
    // with the rest of the card, and the frame of the focus and the bar touch no words.
    static constexpr int kReach_px = 8;

    // The content has its layout.
    ScrollBox(QWidget* content, QWidget* parent);
    // All of what it holds, where there is room. QScrollArea wishes for a part only.
    QSize sizeHint() const override;
    // Also when everything finds its place a little later, until the operator scrolls.
    void keepInSight(const QWidget* row);

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void bringIntoSight();

    const QWidget* in_sight_ = nullptr;
};

}  // namespace hedr
