#include "ui/site/straighten_card.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/site/survey/sheet_format.h"
#include "ui/site/flat_preview.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kWidth_px = 332;

// The first entry of the list: as the photo shows. The formats follow.
constexpr int kAsShown = 0;

QString nameOf(const SheetFormat& format) {
    QString name = QCoreApplication::translate("SheetFormat", format.name);
    name[0] = name[0].toUpper();
    return name;
}

// What a photo makes likely stands beside its name.
QString entryOf(const SheetFormat& format, const std::vector<LikelySheetFormat>& likely) {
    const auto found = std::ranges::find(likely, format.longer_by_shorter, [](const auto& each) {
        return each.format.longer_by_shorter;
    });
    if (found == likely.end()) return nameOf(format);
    return StraightenCard::tr("%1: %2 % likely")
        .arg(nameOf(format))
        .arg(qRound(100.0 * found->probability));
}

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
    sides_->addItem(tr("As the photo shows"));
    for (const SheetFormat& format : sheetFormats()) sides_->addItem(nameOf(format));
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
        if (index == kAsShown) return emit sidesChosen(std::nullopt);
        emit sidesChosen(sheetFormats()[static_cast<std::size_t>(index) - 1].longer_by_shorter);
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
void StraightenCard::setSides(std::optional<double> aspect,
                              const std::optional<SheetAspect>& seen) {
    const auto likely = seen ? likelyFormats(*seen) : std::vector<LikelySheetFormat>{};
    const double sides = aspect ? std::max(*aspect, 1.0 / *aspect) : 0.0;
    sides_->setCurrentIndex(aspect ? -1 : kAsShown);
    int entry = kAsShown;
    for (const SheetFormat& format : sheetFormats()) {
        sides_->setItemText(++entry, entryOf(format, likely));
        constexpr double kSame = 1e-6;
        if (std::abs(format.longer_by_shorter - sides) < kSame) sides_->setCurrentIndex(entry);
    }
}

void StraightenCard::setStraightenedBefore(bool before) { photo_->setVisible(before); }

void StraightenCard::setProgress(std::optional<double> progress) {
    bar_->setVisible(progress.has_value());
    if (progress) bar_->setValue(qBound(0, qRound(100.0 * *progress), 100));
    sides_->setEnabled(!progress);
    photo_->setEnabled(!progress);
}

}  // namespace hedr
