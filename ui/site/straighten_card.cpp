#include "ui/site/straighten_card.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ui/site/flat_preview.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kWidth_px = 332;

// The longer side by the shorter one, in the order of the list; 0: as the photo shows.
constexpr std::array kSides{0.0, std::numbers::sqrt2, 1.0};

}  // namespace

StraightenCard::StraightenCard(QWidget* parent)
    : Card(parent),
      preview_(new FlatPreview(this)),
      verdict_(new QLabel(this)),
      sides_label_(new QLabel(tr("Sides of the rectangle"), this)),
      sides_(new QComboBox(this)),
      bar_(new QProgressBar(this)),
      photo_(new QPushButton(tr("Use the photo as it was"), this)) {
    setAccessibleName(tr("Straighten the photo"));
    setFixedWidth(kWidth_px);
    verdict_->setProperty("role", QStringLiteral("text"));
    verdict_->setWordWrap(true);
    sides_->setAccessibleName(tr("Sides of the rectangle"));
    sides_->addItems({tr("As the photo shows"), tr("A sheet, A0 to A5"), tr("Square")});
    bar_->setTextVisible(false);
    bar_->setFixedHeight(8);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 20, 20, 20);
    column->setSpacing(12);
    column->addWidget(preview_, 1);
    column->addWidget(verdict_);
    column->addWidget(bar_);
    column->addWidget(sides_label_);
    column->addWidget(sides_);
    column->addWidget(photo_);
    setProgress(std::nullopt);
    connect(sides_, &QComboBox::activated, this, [this](int index) {
        const double sides = kSides.at(static_cast<std::size_t>(index));
        emit sidesChosen(sides > 0.0 ? std::optional(sides) : std::nullopt);
    });
    connect(photo_, &QPushButton::clicked, this, &StraightenCard::photoWished);
    setVisible(false);
}

void StraightenCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    preview_->setTheme(theme);
    for (QLabel* label : {verdict_, sides_label_}) label->setStyleSheet(formSheet(theme));
    sides_->setStyleSheet(formSheet(theme));
    bar_->setStyleSheet(formSheet(theme));
    photo_->setStyleSheet(buttonSheet(theme));
}

void StraightenCard::setVerdict(const QString& text) { verdict_->setText(text); }

// Sides that the list does not have leave it blank.
void StraightenCard::setSides(std::optional<double> aspect) {
    const double sides = aspect ? std::max(*aspect, 1.0 / *aspect) : 0.0;
    const auto known = std::ranges::find_if(
        kSides, [&](double listed) { return std::abs(listed - sides) < 1e-6; });
    sides_->setCurrentIndex(known == kSides.end() ? -1 : static_cast<int>(known - kSides.begin()));
}

void StraightenCard::setStraightenedBefore(bool before) { photo_->setVisible(before); }

void StraightenCard::setProgress(std::optional<double> progress) {
    bar_->setVisible(progress.has_value());
    if (progress) bar_->setValue(qBound(0, qRound(100.0 * *progress), 100));
    sides_->setEnabled(!progress);
    photo_->setEnabled(!progress);
}

}  // namespace hedr
