#include "ui/link/link_card.h"

#include <QHBoxLayout>

#include "ui/link/tone_label.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kWidth_px = 380;

struct Span {
    const char* name;
    double seconds;
};
constexpr Span kSpans[] = {{QT_TRANSLATE_NOOP("LinkCard", "1 min"), 60.0},
                           {QT_TRANSLATE_NOOP("LinkCard", "10 min"), 600.0},
                           {QT_TRANSLATE_NOOP("LinkCard", "1 h"), 3600.0},
                           {QT_TRANSLATE_NOOP("LinkCard", "8 h"), 28800.0}};

}  // namespace

LinkCard::LinkCard(QWidget* parent)
    : TitledCard(tr("Link"), parent), figures_(new QGridLayout), plot_(new LinkPlot(this)) {
    setFixedWidth(kWidth_px);
    figures_->setHorizontalSpacing(16);
    figures_->setVerticalSpacing(4);
    figures_->setColumnStretch(1, 1);
    auto* tabs = new QHBoxLayout;
    tabs->setSpacing(0);
    for (std::size_t i = 0; i < std::size(kSpans); ++i) {
        auto* tab = new QPushButton(tr(kSpans[i].name), this);
        tab->setCheckable(true);
        connect(tab, &QPushButton::clicked, this, [this, i] { chooseSpan(i); });
        tabs->addWidget(tab, 1);
        spans_.push_back(tab);
    }
    column().addLayout(figures_);
    column().addSpacing(8);
    column().addLayout(tabs);
    column().addWidget(plot_);
    chooseSpan(0);
}

void LinkCard::setTheme(const Theme& theme) {
    TitledCard::setTheme(theme);
    for (QPushButton* tab : spans_) tab->setStyleSheet(segmentSheet(theme));
    plot_->setTheme(theme);
    for (const Row& row : rows_) {
        for (QLabel* label : {row.label, row.value}) label->setStyleSheet(formSheet(theme));
    }
}

void LinkCard::show(const LiveModel& model, const QString& whose) {
    sayWhose(whose);
    showFigures(linkFigures(model));
    plot_->show(model.linkHistory(), kSpans[span_].seconds, countsLoss(model));
    layout()->activate();
    adjustSize();
}

void LinkCard::showFigures(const std::vector<LinkFigure>& figures) {
    while (rows_.size() < figures.size()) {
        const int row = static_cast<int>(rows_.size());
        rows_.push_back({new QLabel(this), new QLabel(this)});
        rows_.back().value->setProperty("role", QStringLiteral("text"));
        rows_.back().value->setWordWrap(true);
        for (QLabel* label : {rows_.back().label, rows_.back().value})
            label->setStyleSheet(formSheet(theme()));
        figures_->addWidget(rows_.back().label, row, 0, Qt::AlignVCenter);
        figures_->addWidget(rows_.back().value, row, 1);
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const bool used = i < figures.size();
        for (QLabel* label : {rows_[i].label, rows_[i].value}) label->setVisible(used);
        if (!used) continue;
        rows_[i].label->setText(figures[i].label);
        rows_[i].value->setText(figures[i].value);
        setTone(*rows_[i].value, figures[i].tone);
    }
}

void LinkCard::chooseSpan(std::size_t index) {
    span_ = index;
    for (std::size_t i = 0; i < spans_.size(); ++i) spans_[i]->setChecked(i == index);
}

}  // namespace hedr
