#include "ui/calibration/evidence_plot_view.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/calibration/plot_frame.h"
#include "ui/calibration/plot_thinning.h"
#include "ui/calibration/series_style.h"
#include "ui/fonts.h"

namespace hedr {
namespace {

using Shape = EvidenceSeries::Shape;

QString nameOf(const EvidenceAxis& axis, const ReadUnit& unit) {
    const QString name = QString::fromStdString(axis.name);
    return unit.name.isEmpty() || name.isEmpty() ? name + unit.name
                                                 : name + QStringLiteral(", ") + unit.name;
}

// So many marks that they are no longer told apart.
bool isCloud(const EvidenceSeries& series) { return series.x.size() > 1000; }

double sharp(double pixel) { return std::floor(pixel) + 0.5; }

}  // namespace

EvidencePlotView::EvidencePlotView(QWidget* parent) : QWidget(parent) {}

void EvidencePlotView::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void EvidencePlotView::show(const EvidencePlot& plot) {
    plot_ = plot;
    setAccessibleName(QString::fromStdString(plot.title));
    update();
}

void EvidencePlotView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!showsAnything(plot_)) {
        painter.setFont(uiFont(15));
        painter.setPen(theme_.dim);
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("The plot comes as soon as there is something to show."));
        return;
    }
    const PlotFrame frame = plotFrame(plot_, size());
    paintGrid(painter, frame);
    paintLabels(painter, frame);
    painter.setClipRect(frame.area.adjusted(-8, -8, 8, 8));
    paintSeries(painter, frame);
}

void EvidencePlotView::paintGrid(QPainter& painter, const PlotFrame& frame) const {
    const auto column = [&](double value) {
        const double at = sharp(frame.x.pixelOf(value));
        painter.drawLine(QPointF(at, frame.area.top()), QPointF(at, frame.area.bottom()));
    };
    const auto row = [&](double value) {
        const double at = sharp(frame.y.pixelOf(value));
        painter.drawLine(QPointF(frame.area.left(), at), QPointF(frame.area.right(), at));
    };
    QColor faint = theme_.hairline;
    faint.setAlphaF(0.4F);
    painter.setPen(QPen(faint, 1.0));
    for (const double tick : frame.x.minorTicks()) column(tick);
    for (const double tick : frame.y.minorTicks()) row(tick);
    painter.setPen(QPen(theme_.hairline, 1.0));
    for (const double tick : frame.x.ticks()) column(tick);
    for (const double tick : frame.y.ticks()) row(tick);
    painter.setPen(QPen(theme_.hairline, 2.0));
    if (!frame.x.logarithmic && frame.x.low < 0.0 && frame.x.high > 0.0) column(0.0);
    if (!frame.y.logarithmic && frame.y.low < 0.0 && frame.y.high > 0.0) row(0.0);
}

void EvidencePlotView::paintLabels(QPainter& painter, const PlotFrame& frame) const {
    painter.setFont(uiFont(kPlotLabel_px));
    painter.setPen(theme_.dim);
    FigureType type(painter.font());
    for (const double tick : frame.x.ticks()) {
        const QString label = frame.x.label(tick);
        const double left = frame.x.pixelOf(tick) - 0.5 * type.width(label);
        type.draw(painter, {left, frame.area.bottom() + 20.0}, label);
    }
    for (const double tick : frame.y.ticks()) {
        const QString label = frame.y.label(tick);
        type.draw(painter,
                  {frame.area.left() - 8.0 - type.width(label), frame.y.pixelOf(tick) + 4.5},
                  label);
    }
    const QFontMetricsF metrics(painter.font());
    const auto fitting = [&](const EvidenceAxis& axis, const ReadUnit& unit) {
        return metrics.elidedText(nameOf(axis, unit), Qt::ElideRight, width());
    };
    painter.drawText(QPointF(0.0, 12.0), fitting(plot_.y, frame.y_unit));
    painter.drawText(QRectF(0.0, height() - 20.0, frame.area.right(), 20.0),
                     Qt::AlignRight | Qt::AlignVCenter, fitting(plot_.x, frame.x_unit));
}

// Fields first, then clouds of samples, the lines upon them, and marks that are few last.
void EvidencePlotView::paintSeries(QPainter& painter, const PlotFrame& frame) const {
    const std::vector<SeriesStyle> styles = seriesStyles(plot_, theme_);
    const auto depth = [&](std::size_t i) {
        const Shape shape = styles[i].shape;
        if (isField(shape)) return 0;
        if (!isMark(shape)) return 2;
        return isCloud(plot_.series[i]) ? 1 : 3;
    };
    for (int now = 0; now <= 3; ++now) {
        for (std::size_t i = 0; i < styles.size(); ++i) {
            if (depth(i) == now) paintOne(painter, frame, plot_.series[i], styles[i]);
        }
    }
}

void EvidencePlotView::paintOne(QPainter& painter, const PlotFrame& frame,
                                const EvidenceSeries& series, const SeriesStyle& style) const {
    if (isField(style.shape)) return paintField(painter, frame, series, style);
    if (!isMark(style.shape)) return paintLine(painter, frame, series, style);
    if (isCloud(series)) return paintCloud(painter, frame, series, style);
    paintMarks(painter, frame, series, style);
}

std::vector<QPointF> EvidencePlotView::pixels(const PlotFrame& frame, const std::vector<double>& x,
                                              const std::vector<double>& y) const {
    const std::size_t count = std::min(x.size(), y.size());
    std::vector<QPointF> points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const bool shown = canShow(plot_.x, x[i]) && canShow(plot_.y, y[i]);
        points.push_back(shown ? QPointF(frame.x.pixelOf(x[i] * frame.x_unit.per_si),
                                         frame.y.pixelOf(y[i] * frame.y_unit.per_si))
                               : QPointF(qQNaN(), qQNaN()));
    }
    return points;
}

void EvidencePlotView::paintField(QPainter& painter, const PlotFrame& frame,
                                  const EvidenceSeries& series, const SeriesStyle& style) const {
    painter.setBrush(fieldColour(style));
    if (series.shape == Shape::kBand) {
        painter.setPen(Qt::NoPen);
        const auto lower = pixels(frame, series.x, series.y);
        const auto upper = pixels(frame, series.x, series.y_high);
        for (const QPolygonF& piece : ribbonPieces(lower, upper, 0.0)) painter.drawPolygon(piece);
        return;
    }
    painter.setPen(linePen(style));
    QPolygonF outline;
    for (const QPolygonF& piece : linePieces(pixels(frame, series.x, series.y), 1.0))
        outline += piece;
    painter.drawPolygon(outline);
}

void EvidencePlotView::paintLine(QPainter& painter, const PlotFrame& frame,
                                 const EvidenceSeries& series, const SeriesStyle& style) const {
    const std::vector<QPointF> points = pixels(frame, series.x, series.y);
    const bool crowded = static_cast<double>(points.size()) > 2.0 * frame.area.width();
    if (crowded && goesRight(points)) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(style.colour);
        for (const QPolygonF& piece : ribbonPieces(points, points, 1.0)) painter.drawPolygon(piece);
        return;
    }
    painter.setBrush(Qt::NoBrush);
    QPen pen = linePen(style);
    if (crowded) pen.setJoinStyle(Qt::BevelJoin);  // the quickest
    const std::vector<QPolygonF> pieces = linePieces(points, crowded ? 3.0 : 1.0);
    const auto draw = [&](const QPen& with) {
        painter.setPen(with);
        for (const QPolygonF& piece : pieces) painter.drawPolyline(piece);
    };
    if (!crowded) draw(QPen(theme_.chrome, pen.widthF() + 2.0));  // seen on a cloud, too
    draw(pen);
}

void EvidencePlotView::paintMarks(QPainter& painter, const PlotFrame& frame,
                                  const EvidenceSeries& series, const SeriesStyle& style) const {
    constexpr std::size_t kFew = 40;
    for (const QPointF& point : pixels(frame, series.x, series.y)) {
        if (std::isnan(point.x() + point.y())) continue;
        drawMark(painter, point, style, series.x.size() <= kFew ? 12.0 : 7.0, theme_.chrome);
    }
}

void EvidencePlotView::paintCloud(QPainter& painter, const PlotFrame& frame,
                                  const EvidenceSeries& series, const SeriesStyle& style) const {
    const double ratio = devicePixelRatioF();
    QImage cloud((frame.area.size() * ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
    cloud.fill(Qt::transparent);
    const QRgb colour = qPremultiply(cloudColour(style).rgba());
    constexpr double kGrain_px = 2.0;
    const QSize grain = QSizeF(kGrain_px * ratio, kGrain_px * ratio).toSize();
    for (const QPointF& point : pixels(frame, series.x, series.y)) {
        if (std::isnan(point.x() + point.y())) continue;
        const QPoint corner = ((point - frame.area.topLeft()) * ratio).toPoint();
        const QRect inside = QRect(corner, grain) & cloud.rect();
        for (int y = inside.top(); y <= inside.bottom(); ++y) {
            auto* line = reinterpret_cast<QRgb*>(cloud.scanLine(y));
            std::fill(line + inside.left(), line + inside.right() + 1, colour);
        }
    }
    cloud.setDevicePixelRatio(ratio);
    painter.drawImage(frame.area.topLeft(), cloud);
}

}  // namespace hedr
