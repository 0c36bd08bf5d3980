#pragma once

#include <QAbstractButton>
#include <string>

#include "ui/robot_mark.h"
#include "ui/theme.h"

namespace hedr {

struct LegendRowState {
    bool shown = true;
    bool primary = false;
    bool lost = false;  // its heading has lost the building
    QString apart{};    // from the primary trail
    RobotShape robot = RobotShape::kArrow;
    friend bool operator==(const LegendRowState&, const LegendRowState&) = default;
};

// A click is a wish: what is marked changes when the model says so.
class LegendButton : public QAbstractButton {
    Q_OBJECT

  public:
    explicit LegendButton(QWidget* parent);
    void setTheme(const Theme& theme);
    virtual void setState(const LegendRowState& state);

  protected:
    void nextCheckState() override {}
    void paintFocus(QPainter& painter) const;
    const Theme& theme() const { return theme_; }
    const LegendRowState& state() const { return state_; }

  private:
    Theme theme_ = dayTheme();
    LegendRowState state_{};
};

// The robot's shape on the trail that carries it, a ring on the others: a click makes this one
// carry it. Dead while the trail is hidden.
class PrimaryMark : public LegendButton {
    Q_OBJECT

  public:
    PrimaryMark(const std::string& trail, QWidget* parent);
    void setState(const LegendRowState& state) override;

  protected:
    void paintEvent(QPaintEvent* event) override;
};

// A trail's line, name and distance from the primary one. A click shows or hides it.
class TrailToggle : public LegendButton {
    Q_OBJECT

  public:
    TrailToggle(const std::string& trail, QWidget* parent);
    void setState(const LegendRowState& state) override;
    void setCompact(bool compact);  // line and name only
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString rightText() const;

    std::string trail_;
    bool compact_ = false;
};

class LegendRow : public QWidget {
    Q_OBJECT

  public:
    static constexpr int kHeight_px = 48;

    LegendRow(const std::string& trail, QWidget* parent);
    void setTheme(const Theme& theme);
    void setState(const LegendRowState& state);
    void setCompact(bool compact);
    void setFolded(bool folded) { folded_ = folded; }
    bool folded() const { return folded_; }  // waits behind "more"
    const std::string& trail() const { return trail_; }
    const LegendRowState& state() const { return state_; }
    PrimaryMark* mark() const { return mark_; }
    TrailToggle* toggle() const { return toggle_; }
    QSize sizeHint() const override;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    std::string trail_;
    LegendRowState state_{};
    bool folded_ = false;
    PrimaryMark* mark_;
    TrailToggle* toggle_;
};

}  // namespace hedr
