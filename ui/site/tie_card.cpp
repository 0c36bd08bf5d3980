#include "ui/site/tie_card.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <cmath>

#include "core/geometry/angle.h"
#include "core/site/geo_text.h"
#include "ui/error_text.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kWidth_px = 332;
constexpr int kNumber_px = 20;
constexpr int kRemove_px = 28;

// Whether two places are about as far apart as their coordinates say.
bool agree(const TwoPointTie& tie) {
    constexpr double kShare = 0.02;
    return std::abs(tie.globe_length_m - tie.world_length_m) <= kShare * tie.globe_length_m;
}

QString adviceOn(const TieDraft& draft, const TieFit& fit) {
    if (fit.error) return errorText(*fit.error);
    if (fit.by_two) {
        const QString lengths =
            TieCard::tr("They are %1 apart by their coordinates and %2 on the map.")
                .arg(formatDistance(fit.by_two->globe_length_m),
                     formatDistance(fit.by_two->world_length_m));
        return agree(*fit.by_two)
                   ? lengths
                   : lengths + QChar(' ') + TieCard::tr("That does not agree: check both.");
    }
    if (fit.tie) {
        return draft.places.size() == 1
                   ? TieCard::tr(
                         "Click a second place, far from the first, and the bearing follows.")
                   : TieCard::tr("Type the coordinates of the second place.");
    }
    return draft.places.empty() ? TieCard::tr(
                                      "Local metres do for driving. With a tie the map can be "
                                      "given to other programs.")
                                : TieCard::tr("Type its coordinates: 52.2197, 21.0122");
}

}  // namespace

TieCard::TieCard(QWidget* parent)
    : Card(parent),
      state_(new QLabel(this)),
      advice_(new QLabel(this)),
      rows_{makeRow(0), makeRow(1)},
      bearing_label_(new QLabel(tr("Bearing of up on the map"), this)),
      bearing_(new QLineEdit(this)),
      untie_(new QPushButton(tr("No tie"), this)) {
    setAccessibleName(tr("Tie to the globe"));
    setFixedWidth(kWidth_px);
    state_->setProperty("role", QStringLiteral("value"));
    advice_->setProperty("role", QStringLiteral("text"));
    advice_->setWordWrap(true);
    bearing_->setAccessibleName(bearing_label_->text());
    bearing_->setToolTip(tr("Clockwise from true north: 0 is north, 90 east"));
    bearing_->setFixedWidth(96);
    auto* bearing = new QHBoxLayout;
    bearing->addWidget(bearing_label_, 1);
    bearing->addWidget(bearing_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 16, 20, 20);
    column->setSpacing(8);
    column->addWidget(state_);
    column->addWidget(advice_);
    column->addSpacing(4);
    for (const Row& row : rows_) {
        auto* line = new QHBoxLayout;
        line->setSpacing(8);
        line->addWidget(row.number);
        line->addWidget(row.field, 1);
        line->addWidget(row.remove);
        column->addLayout(line);
    }
    column->addLayout(bearing);
    column->addSpacing(4);
    column->addWidget(untie_);
    connect(bearing_, &QLineEdit::editingFinished, this, [this] {
        if (bearing_->isModified()) emit bearingTyped(bearing_->text());
    });
    connect(untie_, &QPushButton::clicked, this, &TieCard::untieWished);
    setVisible(false);
}

TieCard::Row TieCard::makeRow(std::size_t place) {
    const Row row{new QLabel(QString::number(place + 1), this), new QLineEdit(this),
                  new QPushButton(this)};
    row.number->setFixedWidth(kNumber_px);
    row.field->setPlaceholderText(tr("52.2197, 21.0122"));
    row.field->setAccessibleName(tr("Coordinates of place %1").arg(place + 1));
    row.field->setToolTip(tr("Latitude and longitude, in degrees (WGS 84)"));
    row.remove->setFixedSize(kRemove_px, kRemove_px);
    row.remove->setAccessibleName(tr("Remove place %1").arg(place + 1));
    row.remove->setToolTip(row.remove->accessibleName());
    connect(row.field, &QLineEdit::editingFinished, this, [this, place, field = row.field] {
        if (field->isModified()) emit placeTyped(place, field->text());
    });
    connect(row.remove, &QPushButton::clicked, this, [this, place] { emit removeWished(place); });
    return row;
}

void TieCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    for (QLabel* label : {state_, advice_, bearing_label_}) label->setStyleSheet(formSheet(theme));
    bearing_->setStyleSheet(formSheet(theme));
    untie_->setStyleSheet(buttonSheet(theme));
    for (const Row& row : rows_) {
        row.number->setStyleSheet(formSheet(theme));
        row.field->setStyleSheet(formSheet(theme));
        row.remove->setStyleSheet(flatButtonSheet(theme) +
                                  QStringLiteral("QPushButton { padding: 0; }"));
        row.remove->setIcon(
            QIcon(iconPixmap(QStringLiteral("close"), theme.dim, 16, devicePixelRatioF())));
    }
}

void TieCard::showRow(std::size_t place, const TieDraft& draft) {
    const Row& row = rows_.at(place);
    const bool there = place < draft.places.size();
    for (QWidget* part : std::initializer_list<QWidget*>{row.number, row.field, row.remove}) {
        part->setVisible(there);
    }
    if (!there) return row.field->clear();
    const auto& at = draft.places[place].at;
    row.field->setText(at ? QString::fromStdString(latLonText(*at)) : QString());
}

void TieCard::show(const TieDraft& draft, const TieFit& fit, const QString& trouble) {
    state_->setText(fit.by_two ? tr("Tied by two places")
                    : fit.tie  ? tr("Tied by one place")
                               : tr("Not tied"));
    advice_->setText(trouble.isEmpty() ? adviceOn(draft, fit) : trouble);
    // What was typed and cannot be used stays, to be corrected.
    if (trouble.isEmpty()) {
        for (std::size_t place = 0; place < rows_.size(); ++place) showRow(place, draft);
        const double bearing_rad = fit.tie ? fit.tie->bearing_of_y_rad : draft.bearing_of_y_rad;
        bearing_->setText(formatAngle(wrapAngle(bearing_rad)));
    }
    bearing_->setEnabled(!fit.by_two);
    for (QWidget* part : std::initializer_list<QWidget*>{bearing_label_, bearing_, untie_}) {
        part->setVisible(!draft.places.empty());
    }
    if (draft.places.size() > shown_places_) rows_.at(draft.places.size() - 1).field->setFocus();
    shown_places_ = draft.places.size();
}

}  // namespace hedr
