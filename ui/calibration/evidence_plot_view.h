#pragma once

#include <QWidget>
#include <vector>

#include "core/calibration/evidence.h"
#include "ui/theme.h"

namespace hedr {

struct PlotFrame;
struct SeriesStyle;

// Draws the evidence of a calibration, in the units that are read. Many samples cost no more than
// there are pixels to show them.
class EvidencePlotView : public QWidget {
    Q_OBJECT

  public:
    explicit EvidencePlotView(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void show(const EvidencePlot& plot);
    QSize minimumSizeHint() const override { return {240, 160}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void paintGrid(QPainter& painter, const PlotFrame& frame) const;
    void paintLabels(QPainter& painter, const PlotFrame& frame) const;
    void paintSeries(QPainter& painter, const PlotFrame& frame) const;
    std::vector<QPointF> pixels(const PlotFrame& frame, const std::vector<double>& x,
                                const std::vector<double>& y) const;
    void paintOne(QPainter& painter, const PlotFrame& frame, const EvidenceSeries& series,
                  const SeriesStyle& style) const;
    void paintField(QPainter& painter, const PlotFrame& frame, const EvidenceSeries& series,
                    const SeriesStyle& style) const;
    void paintLine(QPainter& painter, const PlotFrame& frame, const EvidenceSeries& series,
                   const SeriesStyle& style) const;
    void paintMarks(QPainter& painter, const PlotFrame& frame, const EvidenceSeries& series,
                    const SeriesStyle& style) const;
    void paintCloud(QPainter& painter, const PlotFrame& frame, const EvidenceSeries& series,
                    const SeriesStyle& style) const;

    Theme theme_ = dayTheme();
    EvidencePlot plot_{};
};

}  // namespace hedr
