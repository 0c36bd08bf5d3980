#pragma once

#include <QAbstractButton>
#include <map>

#include "ui/actions.h"
#include "ui/panels/card.h"

namespace hedr {

// One entry of the rail: an icon above a word.
class RailButton : public QAbstractButton {
    Q_OBJECT

  public:
    explicit RailButton(QWidget* parent);
    void setTheme(const Theme& theme);
    void setEntry(const ActionEntry& entry);
    QSize sizeHint() const override { return {64, 64}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    Theme theme_ = dayTheme();
    QString icon_;
};

// The actions that an operator needs at hand, on the left side of the map.
class Rail : public Card {
    Q_OBJECT

  public:
    explicit Rail(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setFollowing(bool following);

  signals:
    void triggered(hedr::ActionId id);

  private:
    std::map<ActionId, RailButton*> buttons_;
};

}  // namespace hedr
