#pragma once

#include <QWidget>
#include <optional>

#include "core/calibration/evidence.h"
#include "core/calibration/proof.h"
#include "ui/calibration/parameter_words.h"
#include "ui/panels/status_tiles.h"
#include "ui/theme.h"

namespace hedr {

// A part of the result: painted, so that figures stay where they are while they run. Its words are
// its accessible text. Where there is little room it is less high.
class ResultRow : public QWidget {
  public:
    struct Heights {
        int roomy_px;
        int tight_px;
    };

    ResultRow(Heights heights, QWidget* parent);
    void setTheme(const Theme& theme);
    void setRoomy(bool roomy);
    // Where a second column begins, which the rows have in common.
    void setSecondColumn(double from_px);

  protected:
    const Theme& theme() const { return theme_; }
    bool isRoomy() const { return roomy_; }
    double secondColumn() const { return second_column_px_; }
    void say(const QString& name, const QString& words);

  private:
    Theme theme_ = dayTheme();
    Heights heights_;
    bool roomy_ = true;
    double second_column_px_ = 0.0;
};

// A parameter as it was found: name, large value, margin, and what it was.
class FoundRow : public ResultRow {
  public:
    explicit FoundRow(QWidget* parent);
    void show(const FoundParameter& found);
    double valueWidth() const;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    FoundText text_{};
};

// A figure beside the result.
class FigureRow : public ResultRow {
  public:
    explicit FigureRow(QWidget* parent);
    void show(const EvidenceFigure& figure);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString value_{};
    QString interval_{};
};

// How far the held-out parts are off with the old and with the new values. Its room is kept where
// there is nothing to prove with yet.
class ProofBars : public ResultRow {
  public:
    explicit ProofBars(QWidget* parent);
    void show(const std::optional<Proof>& proof, Tone tone);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void paintBar(QPainter& painter, double top, double share, const QColor& colour,
                  const QString& words) const;

    double before_share_ = 1.0;  // of the longer bar
    double after_share_ = 0.0;
    QString before_{};  // "was 0.205 m"; empty without a proof
    QString after_{};
    Tone tone_ = Tone::kPlain;
};

}  // namespace hedr
