#include "ui/site/walls_card.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QShortcut>
#include <QVBoxLayout>

#include "ui/site/wall_layer.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kWidth_px = 332;
struct Width {
    double width_m;
    const char* name;
};
constexpr std::array kWidths{Width{0.1, "10 cm"}, Width{0.2, "20 cm"}, Width{0.5, "50 cm"},
                             Width{1.0, "1 m"}};

QPixmap swatch(const QColor& colour, const Theme& theme) {
    constexpr int kSize_px = 18;
    QPixmap picture(kSize_px, kSize_px);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme.hairline, 1.0));
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(0.5, 0.5, kSize_px - 1.0, kSize_px - 1.0), 4.0, 4.0);
    return picture;
}

}  // namespace

WallsCard::WallsCard(QWidget* parent)
    : Card(parent),
      width_{{WallPen::kWall, 1}, {WallPen::kEraser, 2}},
      width_label_(new QLabel(tr("How wide"), this)),
      verdict_(new QLabel(this)),
      bar_(new QProgressBar(this)) {
    setAccessibleName(tr("Walls"));
    setFixedWidth(kWidth_px);
    verdict_->setProperty("role", QStringLiteral("text"));
    verdict_->setWordWrap(true);
    bar_->setTextVisible(false);
    bar_->setFixedHeight(8);
    auto* pens = new QHBoxLayout;
    auto* widths = new QHBoxLayout;
    auto* legend = new QHBoxLayout;
    for (QHBoxLayout* row : {pens, widths}) row->setSpacing(0);
    addPens(*pens);
    addWidths(*widths);
    legend->setSpacing(8);
    for (std::size_t i = 0; i < 2; ++i) {
        swatches_.at(i) = new QLabel(this);
        colours_.at(i) = new QLabel(i == 0 ? tr("Wall") : tr("Free"), this);
        colours_.at(i)->setProperty("role", QStringLiteral("text"));
        legend->addWidget(swatches_.at(i));
        legend->addWidget(colours_.at(i));
        legend->addSpacing(16);
    }
    legend->addStretch();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 12, 20, 20);
    column->setSpacing(8);
    column->addLayout(pens);
    column->addSpacing(4);
    column->addWidget(width_label_);
    column->addLayout(widths);
    column->addSpacing(8);
    column->addLayout(legend);
    column->addWidget(verdict_);
    column->addWidget(bar_);
    setProgress(std::nullopt);
    showChoice();
    setVisible(false);
}

QPushButton* WallsCard::segment(const QString& text, const QString& tip, Qt::Key key) {
    auto* button = new QPushButton(text, this);
    button->setCheckable(true);
    button->setToolTip(tr("%1 (%2)").arg(tip, QKeySequence(key).toString()));
    // Not the button's own shortcut, which takes the focus from the map.
    connect(new QShortcut(key, this), &QShortcut::activated, button, &QPushButton::click);
    return button;
}

void WallsCard::addPens(QLayout& row) {
    pens_[WallPen::kWall] = segment(tr("Draw walls"), tr("Drag to draw a wall"), Qt::Key_D);
    pens_[WallPen::kEraser] = segment(tr("Erase"), tr("Drag to make free space"), Qt::Key_E);
    for (const auto& [pen, button] : pens_) {
        row.addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, chosen = pen] {
            pen_ = chosen;
            showChoice();
            emit penChosen(chosen);
        });
    }
}

void WallsCard::addWidths(QLayout& row) {
    for (std::size_t i = 0; i < kWidths.size(); ++i) {
        const auto key = static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(i));
        auto* button =
            segment(QString::fromLatin1(kWidths.at(i).name), tr("Width of the line"), key);
        row.addWidget(button);
        widths_.push_back(button);
        connect(button, &QPushButton::clicked, this, [this, i] {
            width_.at(pen_) = i;
            showChoice();
        });
    }
}

double WallsCard::width_m() const { return kWidths.at(width_.at(pen_)).width_m; }

void WallsCard::showChoice() {
    for (const auto& [pen, button] : pens_) button->setChecked(pen == pen_);
    for (std::size_t i = 0; i < widths_.size(); ++i) widths_[i]->setChecked(i == width_.at(pen_));
}

void WallsCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    for (const auto& [pen, button] : pens_) button->setStyleSheet(segmentSheet(theme));
    for (QPushButton* button : widths_) button->setStyleSheet(segmentSheet(theme));
    for (QLabel* label : {width_label_, colours_[0], colours_[1], verdict_}) {
        label->setStyleSheet(formSheet(theme));
    }
    swatches_[0]->setPixmap(swatch(wallColour(theme), theme));
    swatches_[1]->setPixmap(swatch(freeColour(theme), theme));
    bar_->setStyleSheet(formSheet(theme));
}

void WallsCard::setVerdict(const QString& text) {
    verdict_->setText(text);
    verdict_->setVisible(!text.isEmpty());
}

void WallsCard::setProgress(std::optional<double> progress) {
    bar_->setVisible(progress.has_value());
    if (progress) bar_->setValue(qBound(0, qRound(100.0 * *progress), 100));
}

}  // namespace hedr
