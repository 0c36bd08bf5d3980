#pragma once

#include <QAbstractButton>
#include <QVBoxLayout>
#include <set>
#include <string>
#include <vector>

#include "ui/live_model.h"
#include "ui/panels/card.h"

namespace hedr {

// One trail's line, name and distance from the primary one. A click hides the trail.
class LegendRow : public QAbstractButton {
    Q_OBJECT

  public:
    LegendRow(const std::string& name, QWidget* parent);
    void setTheme(const Theme& theme);
    void setApart(const QString& apart);
    void setCompact(bool compact);  // line and name only
    const std::string& name() const { return name_; }
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    std::string name_;
    QString apart_;
    bool compact_ = false;
    Theme theme_ = dayTheme();
};

// Which trail is which.
class Legend : public Card {
    Q_OBJECT

  public:
    explicit Legend(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void show(const LiveModel& model);
    void setCompact(bool compact);  // for a narrow map: names without distances

  signals:
    void trailHidden(const std::string& name, bool hidden);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void build(const LiveModel& model);
    void fitToRows();
    void setTrailHidden(const std::string& name, bool hidden);

    QVBoxLayout* column_;
    std::vector<LegendRow*> rows_;
    std::set<std::string> hidden_;
    bool compact_ = false;
};

}  // namespace hedr
