#include "ui/site/choices_panel.h"

#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>

#include "ui/fonts.h"
#include "ui/site/row_area.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kFrame_px = 4;
constexpr int kCaption_px = 24;

}  // namespace

ChoiceButton::ChoiceButton(const Choice& choice, QWidget* parent)
    : QAbstractButton(parent), picture_(choice.picture) {
    setCheckable(true);
    setText(choice.caption);
    setAccessibleName(choice.caption);
    setAttribute(Qt::WA_Hover);
    setFixedSize(sizeHint());
}

void ChoiceButton::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

QSize ChoiceButton::sizeHint() const {
    return ChoicesPanel::kPicture + QSize(2 * kFrame_px, 2 * kFrame_px + kCaption_px);
}

void ChoiceButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QRectF frame = QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5);
    const bool lit = isChecked() || hasFocus();
    painter.setPen(QPen(lit ? theme_.accent : theme_.hairline, isChecked() ? 3.0 : 1.5));
    painter.setBrush(isChecked() || underMouse() ? theme_.chip : theme_.chrome);
    painter.drawRoundedRect(frame, 8.0, 8.0);
    const QRectF picture(QPointF(kFrame_px, kFrame_px), QSizeF(ChoicesPanel::kPicture));
    QPainterPath corners;
    corners.addRoundedRect(picture, 6.0, 6.0);
    painter.save();
    painter.setClipPath(corners);
    painter.drawImage(picture, picture_);
    painter.restore();
    painter.setFont(uiFont(14, isChecked() ? QFont::DemiBold : QFont::Normal));
    painter.setPen(theme_.ink);
    painter.drawText(QRectF(0, picture.bottom(), width(), kCaption_px), Qt::AlignCenter, text());
}

ChoicesPanel::ChoicesPanel(QWidget* parent)
    : QWidget(parent),
      verdict_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      pictures_(new QWidget),
      area_(new RowArea(pictures_, this)),
      grid_(new QGridLayout(pictures_)) {
    verdict_->setProperty("role", QStringLiteral("text"));
    verdict_->setWordWrap(true);
    progress_->setRange(0, 100);
    progress_->setTextVisible(false);
    progress_->setVisible(false);
    grid_->setSpacing(0);
    grid_->setContentsMargins(0, 0, 0, 0);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    column->addWidget(verdict_);
    column->addWidget(progress_);
    column->addWidget(area_);
}

void ChoicesPanel::setTheme(const Theme& theme) {
    theme_ = theme;
    area_->setStyleSheet(scrollSheet(theme));
    verdict_->setStyleSheet(formSheet(theme));
    progress_->setStyleSheet(formSheet(theme));
    for (ChoiceButton* button : buttons_) button->setTheme(theme);
}

void ChoicesPanel::setProgress(double share) {
    setFound(tr("Searching…"), {});
    progress_->setValue(qRound(share * 100.0));
    progress_->setVisible(true);
}

void ChoicesPanel::setFound(const QString& verdict, const std::vector<Choice>& choices) {
    progress_->setVisible(false);
    verdict_->setText(verdict);
    for (ChoiceButton* button : buttons_) {
        button->hide();
        button->deleteLater();
    }
    buttons_.clear();
    for (std::size_t i = 0; i < choices.size(); ++i) {
        auto* button = new ChoiceButton(choices[i], pictures_);
        button->setFocusPolicy(Qt::TabFocus);
        button->setTheme(theme_);
        grid_->addWidget(button, static_cast<int>(i / 2), static_cast<int>(i % 2));
        connect(button, &QAbstractButton::clicked, this, [this, i] { emit chosen(i); });
        button->show();
        buttons_.push_back(button);
    }
    const int row_px = buttons_.empty() ? 0 : buttons_.front()->sizeHint().height();
    area_->setRows(static_cast<int>((choices.size() + 1) / 2), row_px, 1);
    updateGeometry();
}

void ChoicesPanel::setChosen(std::optional<std::size_t> choice) {
    for (std::size_t i = 0; i < buttons_.size(); ++i) buttons_[i]->setChecked(choice == i);
}

}  // namespace hedr
