#include "ui/calibration/evidence_card.h"

#include <QVBoxLayout>

#include "ui/calibration/calibration_sheet.h"
#include "ui/calibration/evidence_plot_view.h"
#include "ui/calibration/plot_legend.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

// Gives way where there is little room: its words are cut, the tool tip has them.
class PlotTab : public QPushButton {
  public:
    PlotTab(const QString& title, QWidget* parent) : QPushButton(parent), title_(title) {
        setCheckable(true);
        setAccessibleName(title);
        setToolTip(title);
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    }

  protected:
    void resizeEvent(QResizeEvent* event) override {
        QPushButton::resizeEvent(event);
        constexpr int kAround_px = 12;
        setText(fontMetrics().elidedText(title_, Qt::ElideRight, width() - kAround_px));
    }

  private:
    QString title_;
};

// Capitals, but for a note in brackets, which may have units.
QString captionOf(const QString& title) {
    const qsizetype words = title.contains(u'(') ? title.indexOf(u'(') : title.size();
    return title.first(words).toUpper() + title.sliced(words);
}

}  // namespace

EvidenceCard::EvidenceCard(QWidget* parent)
    : Card(parent),
      caption_(new QLabel(this)),
      tabs_row_(new QWidget(this)),
      tabs_(new QHBoxLayout(tabs_row_)),
      group_(new QButtonGroup(this)),
      plot_(new EvidencePlotView(this)),
      legend_(new PlotLegend(this)) {
    setAccessibleName(tr("Evidence"));
    caption_->setProperty("role", QStringLiteral("caption"));
    caption_->setTextFormat(Qt::PlainText);
    caption_->setWordWrap(true);
    tabs_->setContentsMargins(0, 0, 0, 0);
    tabs_->setSpacing(8);
    tabs_row_->setVisible(false);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(16);
    column->addWidget(caption_);
    column->addWidget(tabs_row_);
    column->addWidget(plot_, 1);
    column->addWidget(legend_);
    connect(group_, &QButtonGroup::idToggled, this, [this](int, bool on) {
        if (on) showChosen();
    });
}

void EvidenceCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    setStyleSheet(calibrationSheet(theme));
    plot_->setTheme(theme);
    legend_->setTheme(theme);
    for (QAbstractButton* tab : group_->buttons()) tab->setStyleSheet(segmentSheet(theme));
}

void EvidenceCard::setRoomy(bool roomy) {
    const int padding_px = roomy ? 24 : 16;
    layout()->setContentsMargins(padding_px, padding_px, padding_px, padding_px);
}

void EvidenceCard::show(const std::vector<EvidencePlot>& plots) {
    plots_ = plots;
    QStringList titles;
    for (const EvidencePlot& plot : plots) titles << QString::fromStdString(plot.title);
    if (titles != titles_) makeTabs(titles);
    showChosen();
}

void EvidenceCard::makeTabs(const QStringList& titles) {
    const QString chosen = titles_.value(group_->checkedId());
    const bool focused = tabs_row_->isAncestorOf(window()->focusWidget());
    qDeleteAll(group_->buttons());
    titles_ = titles;
    QWidget* before = before_tabs_;
    for (qsizetype i = 0; i < titles.size(); ++i) {
        auto* tab = new PlotTab(titles[i], tabs_row_);
        tab->setStyleSheet(segmentSheet(theme()));
        tabs_->addWidget(tab, tab->fontMetrics().horizontalAdvance(titles[i]));
        group_->addButton(tab, static_cast<int>(i));
        if (before) setTabOrder(before, tab);
        before = tab;
    }
    tabs_row_->setVisible(titles.size() > 1);
    if (titles.empty()) return;
    QAbstractButton* again =
        group_->button(static_cast<int>(qMax<qsizetype>(0, titles.indexOf(chosen))));
    again->setChecked(true);
    if (focused) again->setFocus();
}

void EvidenceCard::showChosen() {
    const auto chosen = static_cast<std::size_t>(qMax(0, group_->checkedId()));
    const EvidencePlot plot = chosen < plots_.size() ? plots_[chosen] : EvidencePlot{};
    const QString title = QString::fromStdString(plot.title);
    caption_->setText(captionOf(plots_.size() == 1 ? title : tr("Evidence")));
    plot_->show(plot);
    legend_->show(plot);
}

}  // namespace hedr
