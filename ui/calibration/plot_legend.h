#pragma once

#include <QWidget>
#include <vector>

#include "core/calibration/evidence.h"
#include "ui/theme.h"

namespace hedr {

struct SeriesStyle;

// What the colours and shapes of a plot mean, in as many lines as it takes.
class PlotLegend : public QWidget {
    Q_OBJECT

  public:
    explicit PlotLegend(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void show(const EvidencePlot& plot);
    int heightForWidth(int width_px) const override;
    QSize sizeHint() const override { return {240, heightForWidth(240)}; }
    QSize minimumSizeHint() const override { return {0, heightForWidth(width())}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    std::vector<QRect> places(int width_px, const std::vector<SeriesStyle>& entries) const;

    Theme theme_ = dayTheme();
    EvidencePlot names_{};  // of the series, without their samples
};

}  // namespace hedr
