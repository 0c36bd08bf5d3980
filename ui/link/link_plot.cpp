#include "ui/link/link_plot.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/fonts.h"
#include "ui/format.h"

namespace hedr {
namespace {

constexpr double kStrip_px = 32.0;
constexpr double kLabel_px = 20.0;
constexpr double kGap_px = 6.0;
constexpr int kText_px = 13;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

LinkPlot::LinkPlot(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("History of the link"));
    setFixedHeight(
        static_cast<int>(static_cast<double>(strips().size()) * (kLabel_px + kStrip_px + kGap_px)));
}

const std::vector<LinkPlot::Strip>& LinkPlot::strips() {
    static const std::vector<Strip> all{
        {tr("Loss"), [](const LinkSample& s) { return s.loss; }, 0.1, formatLoss, 0.2},
        {tr("Longest silence"), [](const LinkSample& s) { return s.longest_gap_s; }, 1.0,
         formatMilliseconds, 1.0},
        {tr("Round trip"), [](const LinkSample& s) { return s.round_trip_s.value_or(kUnknown); },
         0.1, formatMilliseconds, 0.5}};
    return all;
}

void LinkPlot::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void LinkPlot::show(std::span<const LinkSample> samples, double span_s, bool counts_loss) {
    span_s_ = span_s;
    samples_.clear();
    if (!samples.empty()) {
        const double from_s = samples.back().receive_time_s - span_s;
        const auto first =
            std::ranges::lower_bound(samples, from_s, {}, &LinkSample::receive_time_s);
        samples_.assign(first, samples.end());
    }
    for (LinkSample& sample : samples_) {
        const bool silent = sample.frames_per_s == 0.0 && sample.loss == 0.0;
        if (silent || !counts_loss) sample.loss = kUnknown;
    }
    update();
}

void LinkPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setFont(uiFont(kText_px));
    double top = 0.0;
    for (const Strip& strip : strips()) {
        paintStrip(painter, strip, {0.0, top, width() * 1.0, kLabel_px + kStrip_px});
        top += kLabel_px + kStrip_px + kGap_px;
    }
}

void LinkPlot::paintStrip(QPainter& painter, const Strip& strip, const QRectF& area) const {
    const QRectF field = area.adjusted(0.0, kLabel_px, 0.0, 0.0);
    const auto columns = static_cast<std::size_t>(std::max(field.width(), 1.0));
    const double last_column = static_cast<double>(columns) - 1.0;
    std::vector<double> worst(columns, kUnknown);
    double most = strip.least_full;
    for (const LinkSample& sample : samples_) {
        const double value = strip.value(sample);
        // A clock that was set in between must not lead beyond the strip.
        const double ago_s = std::max(0.0, samples_.back().receive_time_s - sample.receive_time_s);
        // A second may be wider than a pixel: it reaches back to the one before.
        const auto right =
            static_cast<std::size_t>(std::max(0.0, 1.0 - ago_s / span_s_) * last_column);
        const double left = (1.0 - (ago_s + 1.0) / span_s_) * last_column;
        for (auto x = static_cast<std::size_t>(std::max(left, 0.0)); x <= right; ++x) {
            worst[x] = std::fmax(worst[x], value);
        }
        most = std::fmax(most, value);
    }
    painter.fillRect(field, theme_.chip);
    for (std::size_t x = 0; x < columns; ++x) {
        if (std::isnan(worst[x])) continue;
        const double height = std::max(1.0, worst[x] / most * field.height());
        painter.fillRect(QRectF(static_cast<double>(x), field.bottom() - height, 1.0, height),
                         worst[x] >= strip.warn_from ? theme_.alarm : theme_.accent);
    }
    painter.setPen(theme_.dim);
    const double base = area.top() + 14.0;
    painter.drawText(QPointF(0.0, base), strip.label);
    const QString full = strip.format(most);
    drawFigures(painter, {area.right() - figuresWidth(painter.font(), full), base}, full);
}

}  // namespace hedr
