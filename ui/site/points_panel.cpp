#include "ui/site/points_panel.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "core/geometry/angle.h"
#include "ui/error_text.h"
#include "ui/fonts.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/site/row_area.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kRow_px = 32;
constexpr int kName_px = 76;
constexpr int kFigure_px = 62;
constexpr int kRemove_px = 28;
constexpr double kLeastFullBar_m = 0.05;  // what is less is no error to be seen

}  // namespace

ResidualRow::ResidualRow(std::size_t number, QWidget* parent)
    : QWidget(parent), number_(number), remove_(new QPushButton(this)) {
    setFixedHeight(kRow_px);
    remove_->setAccessibleName(tr("Remove point %1").arg(number));
    remove_->setToolTip(remove_->accessibleName());
    connect(remove_, &QPushButton::clicked, this, &ResidualRow::removeWished);
}

void ResidualRow::setTheme(const Theme& theme) {
    theme_ = theme;
    remove_->setStyleSheet(flatButtonSheet(theme) + QStringLiteral("QPushButton { padding: 0; }"));
    remove_->setIcon(
        QIcon(iconPixmap(QStringLiteral("close"), theme.dim, 16, devicePixelRatioF())));
    update();
}

void ResidualRow::setState(const State& state) {
    state_ = state;
    setAccessibleName(name() + QStringLiteral(", ") + formatShort(state.residual_m));
    update();
}

QString ResidualRow::name() const {
    return state_.name.isEmpty() ? tr("Point %1").arg(number_) : state_.name;
}

void ResidualRow::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(theme_.ink);
    painter.setFont(uiFont(15, state_.worst ? QFont::DemiBold : QFont::Normal));
    painter.drawText(QRectF(0, 0, kName_px, height()), Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(name(), Qt::ElideRight, kName_px - 4));
    remove_->setGeometry(width() - kRemove_px, (kRow_px - kRemove_px) / 2, kRemove_px, kRemove_px);
    if (!state_.known) return;
    const double room = width() - kName_px - kFigure_px - kRemove_px;
    const double share = state_.longest_m > 0.0 ? state_.residual_m / state_.longest_m : 0.0;
    painter.setPen(Qt::NoPen);
    painter.setBrush(state_.worst ? theme_.alarm : theme_.accent);
    painter.drawRoundedRect(QRectF(kName_px, height() / 2.0 - 4, std::max(4.0, share * room), 8), 4,
                            4);
    painter.setPen(theme_.dim);
    painter.setFont(uiFont(15));
    painter.drawText(QRectF(kName_px + room, 0, kFigure_px - 6, height()),
                     Qt::AlignVCenter | Qt::AlignRight, formatShort(state_.residual_m));
}

PointsPanel::PointsPanel(QWidget* parent)
    : QWidget(parent),
      rms_(new QLabel(this)),
      placement_(new QLabel(this)),
      list_(new QWidget),
      scroll_(new RowArea(list_, this)),
      verdict_(new QLabel(this)),
      typing_(new QWidget(this)),
      place_(new QLineEdit(typing_)),
      use_(new QPushButton(tr("Use"), typing_)),
      file_(new QPushButton(tr("Points from a file…"), this)),
      keep_scale_(new QCheckBox(tr("Keep the scale"), this)),
      keep_rotation_(new QCheckBox(tr("Keep the rotation"), this)) {
    rms_->setProperty("role", QStringLiteral("value"));
    verdict_->setProperty("role", QStringLiteral("text"));
    verdict_->setWordWrap(true);
    auto* rows = new QVBoxLayout(list_);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(rms_);
    column->addWidget(placement_);
    column->addSpacing(4);
    column->addWidget(scroll_);
    column->addSpacing(4);
    column->addWidget(verdict_);
    column->addWidget(typing_);
    column->addWidget(file_);
    column->addSpacing(4);
    column->addWidget(keep_scale_);
    column->addWidget(keep_rotation_);
    buildTyping();
    file_->setToolTip(tr("POINTS.csv, or .points as QGIS saves them"));
    connect(file_, &QPushButton::clicked, this, &PointsPanel::fileWished);
    for (QCheckBox* box : {keep_scale_, keep_rotation_}) {
        connect(box, &QCheckBox::clicked, this, [this] {
            emit locksChanged(keep_scale_->isChecked(), keep_rotation_->isChecked());
        });
    }
}

// A place on the map that is known by its numbers only.
void PointsPanel::buildTyping() {
    place_->setAccessibleName(tr("Where the point is"));
    place_->setPlaceholderText(tr("or type it: 12.5, 3.2"));
    place_->setToolTip(
        tr("Metres: 12.5, 3.2. Where the map is tied to the globe: "
           "52.2197 N, 21.0122 E"));
    auto* row = new QHBoxLayout(typing_);
    row->setContentsMargins(0, 4, 0, 4);
    row->setSpacing(8);
    row->addWidget(place_, 1);
    row->addWidget(use_);
    const auto give = [this] {
        if (!place_->text().trimmed().isEmpty()) emit placeTyped(place_->text());
    };
    connect(place_, &QLineEdit::returnPressed, this, give);
    connect(use_, &QPushButton::clicked, this, give);
}

void PointsPanel::setTheme(const Theme& theme) {
    theme_ = theme;
    scroll_->setStyleSheet(scrollSheet(theme));
    for (QLabel* label : {rms_, placement_, verdict_}) label->setStyleSheet(formSheet(theme));
    for (QCheckBox* box : {keep_scale_, keep_rotation_}) box->setStyleSheet(formSheet(theme));
    place_->setStyleSheet(formSheet(theme));
    use_->setStyleSheet(buttonSheet(theme));
    file_->setStyleSheet(flatButtonSheet(theme) + QStringLiteral(R"(
QPushButton { text-align: center; min-height: 32px; })"));
    for (ResidualRow* row : rows_) row->setTheme(theme);
}

void PointsPanel::setRows(std::size_t count) {
    while (rows_.size() > count) {
        rows_.back()->deleteLater();
        rows_.back()->hide();
        rows_.pop_back();
    }
    while (rows_.size() < count) {
        const std::size_t index = rows_.size();
        auto* row = new ResidualRow(index + 1, list_);
        row->setTheme(theme_);
        connect(row, &ResidualRow::removeWished, this, [this, index] { emit removeWished(index); });
        list_->layout()->addWidget(row);
        row->show();
        rows_.push_back(row);
    }
    scroll_->setRows(static_cast<int>(count), kRow_px, 2);
}

QString PointsPanel::verdictOn(const Alignment& alignment, const AlignmentFit& fit) const {
    if (fit.error) return errorText(*fit.error);
    if (alignment.points.size() < 2) return {};
    const bool free = !alignment.keep_scale && !alignment.keep_rotation;
    if (alignment.points.size() == 2 && free)
        return tr("Two points always fit: a third one checks them.");
    const QString worst = QString::number(fit.fit->worst.value_or(0) + 1);
    if (fit.fit->blunder == Blunder::kProbable) {
        return tr("Point %1 does not fit the others: set it again.").arg(worst);
    }
    if (fit.fit->blunder == Blunder::kUnclear) {
        return tr("Two points contradict each other, point %1 most: check both.").arg(worst);
    }
    if (fit.fit->all_on_a_line) {
        return tr(
            "All points lie on one line: set one beside it, to see that the plan is not "
            "mirrored.");
    }
    return fit.fit->worst ? tr("Point %1 fits worst: check it.").arg(worst) : QString();
}

void PointsPanel::show(const Alignment& alignment, const AlignmentFit& fit,
                       const QString& trouble) {
    const std::size_t count = alignment.points.size();
    setRows(count);
    double longest_m = kLeastFullBar_m;
    if (fit.fit) {
        for (const Vector<World>& residual : fit.fit->residuals_m)
            longest_m = std::max(longest_m, residual.length());
    }
    for (std::size_t i = 0; i < count; ++i) {
        rows_[i]->setState({QString::fromStdString(alignment.points[i].name),
                            fit.fit ? fit.fit->residuals_m[i].length() : 0.0, longest_m,
                            fit.fit && count > 2 && fit.fit->worst == i, fit.fit.has_value()});
    }
    const bool locked = alignment.keep_scale || alignment.keep_rotation;
    const bool several = fit.fit && (count > 2 || (count == 2 && locked));
    rms_->setText(several      ? tr("rms %1").arg(formatShort(fit.fit->rms_m))
                  : count == 1 ? tr("1 point")
                               : tr("%1 points").arg(count));
    placement_->setText(tr("%1 per pixel, turned by %2")
                            .arg(formatResolution(alignment.placement.resolution_m),
                                 formatAngle(wrapAngle(alignment.placement.origin.heading_rad))));
    verdict_->setText(trouble.isEmpty() ? verdictOn(alignment, fit) : trouble);
    verdict_->setVisible(!verdict_->text().isEmpty());
    const bool was_waiting = typing_->isVisibleTo(this);
    typing_->setVisible(alignment.waiting.has_value());
    if (!alignment.waiting) place_->clear();
    if (alignment.waiting && !was_waiting) place_->setFocus();
    file_->setVisible(count == 0 && !alignment.waiting);
    const QSignalBlocker quiet_scale(keep_scale_);
    const QSignalBlocker quiet_rotation(keep_rotation_);
    keep_scale_->setChecked(alignment.keep_scale);
    keep_rotation_->setChecked(alignment.keep_rotation);
}

}  // namespace hedr
