#include "ui/calibration/ends_card.h"

#include <QVBoxLayout>
#include <algorithm>

#include "ui/format.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kWidth_px = 332;
constexpr std::size_t kMostRuns = 6;  // the last ones, for there is not always room for more

QString centimetres(double length_m) {
    constexpr double kCentimetresOfMetre = 100.0;
    QString text = QString::number(kCentimetresOfMetre * length_m, 'f', 1);
    return text.replace('-', QChar(0x2212));
}

}  // namespace

EndsCard::EndsCard(QWidget* parent)
    : Card(parent),
      advice_(new QLabel(this)),
      grid_(new QGridLayout),
      skip_(new QPushButton(this)) {
    setAccessibleName(tr("Ends of the squares"));
    setFixedWidth(kWidth_px);
    advice_->setProperty("role", QStringLiteral("text"));
    advice_->setWordWrap(true);
    grid_->setHorizontalSpacing(16);
    grid_->setVerticalSpacing(4);
    grid_->setColumnStretch(0, 1);
    addRow();
    rows_[0].x->setText(tr("ahead, cm"));
    rows_[0].y->setText(tr("left, cm"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 16, 20, 20);
    column->setSpacing(12);
    column->addWidget(advice_);
    column->addLayout(grid_);
    column->addWidget(skip_);
    connect(skip_, &QPushButton::clicked, this, &EndsCard::skipWished);
    setVisible(false);
}

void EndsCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    setStyleSheet(formSheet(theme));
    skip_->setStyleSheet(buttonSheet(theme));
}

void EndsCard::addRow() {
    const Row row{new QLabel(this), new QLabel(this), new QLabel(this)};
    const int index = static_cast<int>(rows_.size());
    int at = 0;
    for (QLabel* label : {row.run, row.x, row.y}) {
        label->setProperty("role", QStringLiteral("text"));
        label->setAlignment((at == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
        grid_->addWidget(label, index, at++);
    }
    rows_.push_back(row);
}

void EndsCard::fill(const Row& row, const QString& run, std::optional<Vector<Robot>> way) {
    row.run->setText(run);
    row.x->setText(way ? centimetres(way->x) : QStringLiteral("–"));
    row.y->setText(way ? centimetres(way->y) : QStringLiteral("–"));
}

void EndsCard::show(const ClickedEnds& ends, std::optional<Point<World>> pointer,
                    const QString& trouble) {
    const bool axes_known = ends.next() == ClickedEnds::Next::kEnd;
    const std::size_t next = std::max(ends.marks().size(), ClickedEnds::kFirstEnd);
    const std::size_t first = std::max(next - std::min(next, kMostRuns), ClickedEnds::kFirstEnd);
    const std::size_t shown = axes_known ? next - first + 1 : 0;
    while (rows_.size() <= shown) addRow();
    for (std::size_t i = 1; i < rows_.size(); ++i) {
        const Row& row = rows_[i];
        for (QLabel* label : {row.run, row.x, row.y}) label->setVisible(i <= shown);
        if (i > shown) continue;
        const std::size_t mark = first + i - 1;
        const auto place = mark == next ? pointer : ends.marks()[mark];
        fill(row, mark == next ? tr("At the pointer") : tr("Run %1").arg(ends.runOf(mark)),
             place ? ends.wayTo(*place) : std::nullopt);
    }
    for (QLabel* label : {rows_[0].run, rows_[0].x, rows_[0].y}) label->setVisible(axes_known);
    advice_->setText(!trouble.isEmpty() ? trouble
                     : axes_known
                         ? tr("Mean the same part of the robot each time. A mark can be dragged.")
                         : tr("The plan has to have its true scale. Where it is coarser than a "
                              "centimetre, a tape is better."));
    skip_->setText(tr("Skip run %1").arg(ends.nextRun()));
    skip_->setVisible(axes_known);
}

}  // namespace hedr
