#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QWidget>
#include <vector>

#include "ui/site/alignment.h"
#include "ui/theme.h"

namespace hedr {

class RowArea;

// One control point of a list: its residual as a bar and in cm, and a way to take it out.
class ResidualRow : public QWidget {
    Q_OBJECT

  public:
    struct State {
        QString name{};  // empty: by its number
        double residual_m = 0.0;
        double longest_m = 0.0;  // of all rows: the length of a full bar
        bool worst = false;
        bool known = false;  // false with one point only
    };
    ResidualRow(std::size_t number, QWidget* parent);
    void setTheme(const Theme& theme);
    void setState(const State& state);

  signals:
    void removeWished();

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString name() const;

    std::size_t number_;
    State state_{};
    Theme theme_ = dayTheme();
    QPushButton* remove_;
};

// How well the points fit, and which of them to check.
class PointsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit PointsPanel(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    // `trouble`: what is wrong with what was typed or read last; empty: nothing.
    void show(const Alignment& alignment, const AlignmentFit& fit, const QString& trouble);

  signals:
    void removeWished(std::size_t point);
    void placeTyped(const QString& text);  // where the waiting point is on the map
    void fileWished();                     // points of a file
    void locksChanged(bool keep_scale, bool keep_rotation);

  private:
    void buildTyping();
    void setRows(std::size_t count);
    QString verdictOn(const Alignment& alignment, const AlignmentFit& fit) const;

    Theme theme_ = dayTheme();
    QLabel* rms_;
    QLabel* placement_;
    QWidget* list_;
    RowArea* scroll_;
    std::vector<ResidualRow*> rows_{};
    QLabel* verdict_;
    QWidget* typing_;
    QLineEdit* place_;
    QPushButton* use_;
    QPushButton* file_;
    QCheckBox* keep_scale_;
    QCheckBox* keep_rotation_;
};

}  // namespace hedr
