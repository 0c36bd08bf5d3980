#pragma once

#include <QWidget>
#include <span>
#include <vector>

#include "core/mission/link_sample.h"
#include "ui/theme.h"

namespace hedr {

// How the link was: loss, the longest silence and the round trip over time, one strip each, the
// present on the right. A pixel shows the worst of the seconds below it.
class LinkPlot : public QWidget {
    Q_OBJECT

  public:
    explicit LinkPlot(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    // `span_s`: how far back, ending with the last sample.
    // `counts_loss`: whether the samples say what was lost.
    void show(std::span<const LinkSample> samples, double span_s, bool counts_loss);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    struct Strip {
        QString label;
        double (*value)(const LinkSample& sample);
        double least_full;  // the scale shows at least so much
        QString (*format)(double value);
        double warn_from;
    };
    static const std::vector<Strip>& strips();
    void paintStrip(QPainter& painter, const Strip& strip, const QRectF& area) const;

    Theme theme_ = dayTheme();
    std::vector<LinkSample> samples_;
    double span_s_ = 60.0;
};

}  // namespace hedr
