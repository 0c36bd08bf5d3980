#include "ui/site/layer_row.h"

#include <QGridLayout>
#include <QSignalBlocker>

#include "ui/icons.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kButton_px = 36;
constexpr int kIcon_px = 20;
constexpr int kSteps = 100;  // of the opacity

QString nameOf(const SitePlan& plan) {
    const QString name = QString::fromStdString(plan.image_file.filename().string());
    return plan.page > 1 ? LayerRow::tr("%1, page %2").arg(name).arg(plan.page) : name;
}

QString noPixels() { return LayerRow::tr("The pixels of the image are not there"); }

}  // namespace

LayerRow::LayerRow(QWidget* parent)
    : QWidget(parent),
      eye_(new QPushButton(this)),
      name_(new QLabel(this)),
      note_(new QLabel(this)),
      opacity_(new QSlider(Qt::Horizontal, this)),
      more_(new QPushButton(this)) {
    setFixedHeight(kHeight_px);
    for (QPushButton* button : {eye_, more_}) {
        button->setFixedSize(kButton_px, kButton_px);
        button->setIconSize({kIcon_px, kIcon_px});
        button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys with the map
    }
    eye_->setCheckable(true);
    more_->setToolTip(tr("Align, straighten, crop, save a copy, order …"));
    name_->setProperty("role", QStringLiteral("text"));
    opacity_->setRange(10, kSteps);
    opacity_->setToolTip(tr("How opaque the image is"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(0);
    grid->addWidget(eye_, 0, 0);
    grid->addWidget(name_, 0, 1);
    grid->addWidget(more_, 0, 2);
    grid->addWidget(opacity_, 1, 1);
    grid->addWidget(note_, 1, 2);
    grid->setColumnStretch(1, 1);
    connect(eye_, &QPushButton::clicked, this, &LayerRow::visibleWished);
    connect(more_, &QPushButton::clicked, this, &LayerRow::openMenu);
    connect(opacity_, &QSlider::valueChanged, this, [this](int value) {
        const double opacity = value / double(kSteps);
        opacity_->isSliderDown() ? emit opacityMoved(opacity) : emit opacityWished(opacity);
    });
    connect(opacity_, &QSlider::sliderReleased, this,
            [this] { emit opacityWished(opacity_->value() / double(kSteps)); });
}

void LayerRow::setTheme(const Theme& theme) {
    theme_ = theme;
    const QString square = QStringLiteral("QPushButton { padding: 0; }");
    for (QPushButton* button : {eye_, more_}) {
        button->setStyleSheet(flatButtonSheet(theme) + square);
    }
    for (QLabel* label : {name_, note_}) label->setStyleSheet(formSheet(theme));
    opacity_->setStyleSheet(sliderSheet(theme));
    setIcons();
}

void LayerRow::setIcons() {
    const auto icon = [this](const char* name, const QColor& colour) {
        return QIcon(iconPixmap(QString::fromLatin1(name), colour, kIcon_px, devicePixelRatioF()));
    };
    eye_->setIcon(plan_.visible ? icon("eye", theme_.ink) : icon("eye-off", theme_.dim));
    more_->setIcon(icon(plan_.locked ? "lock" : "more", theme_.ink));
}

void LayerRow::setPlan(const SitePlan& plan, const QString& warning, bool top, bool bottom) {
    plan_ = plan;
    top_ = top;
    bottom_ = bottom;
    const QString name = nameOf(plan);
    eye_->setChecked(plan.visible);
    eye_->setAccessibleName(plan.visible ? tr("Hide %1").arg(name) : tr("Show %1").arg(name));
    eye_->setToolTip(eye_->accessibleName());
    more_->setAccessibleName(tr("More for %1").arg(name));
    opacity_->setAccessibleName(tr("Opacity of %1").arg(name));
    opacity_->setEnabled(plan.visible);
    const QSignalBlocker quiet(opacity_);
    if (!opacity_->isSliderDown()) opacity_->setValue(qRound(plan.opacity * kSteps));
    note_->setText(warning.isEmpty() ? QString() : QStringLiteral("!"));
    setToolTip(warning.isEmpty() ? QString::fromStdString(plan.image_file.string()) : warning);
    setIcons();
    elide();
}

QString LayerRow::name() const { return nameOf(plan_); }

void LayerRow::elide() {
    name_->setText(name_->fontMetrics().elidedText(name(), Qt::ElideMiddle, name_->width()));
}

void LayerRow::resizeEvent(QResizeEvent*) { elide(); }

void LayerRow::openMenu() {
    QMenu menu(this);
    fill(menu);
    menu.exec(more_->mapToGlobal(QPoint(0, more_->height())));
}

void LayerRow::fill(QMenu& menu) {
    menu.setStyleSheet(menuSheet(theme_));
    menu.setToolTipsVisible(true);
    addWork(menu);
    menu.addSeparator();
    addCopies(menu);
    menu.addSeparator();
    add(menu, tr("Move up"), LayerAction::kUp)->setEnabled(!top_);
    add(menu, tr("Move down"), LayerAction::kDown)->setEnabled(!bottom_);
    menu.addSeparator();
    const auto add_checked = [&](const QString& text, LayerAction action, bool on) {
        QAction* entry = add(menu, text, action);
        entry->setCheckable(true);
        entry->setChecked(on);
    };
    add_checked(tr("Locked"), LayerAction::kLock, plan_.locked);
    add_checked(tr("Dark at night"), LayerAction::kInvert, plan_.inverted_at_night);
    menu.addSeparator();
    add(menu, tr("Remove"), LayerAction::kRemove)->setEnabled(!plan_.locked);
}

QAction* LayerRow::add(QMenu& menu, const QString& text, LayerAction action) {
    return menu.addAction(text, this, [this, action] { emit actionWished(action); });
}

void LayerRow::addWork(QMenu& menu) {
    const QString why_not = plan_.locked ? tr("The image is locked") : noPixels();
    for (QAction* entry : {add(menu, tr("Align…"), LayerAction::kAlign),
                           add(menu, tr("Straighten…"), LayerAction::kStraighten),
                           add(menu, tr("Crop…"), LayerAction::kCrop)}) {
        entry->setEnabled(!plan_.locked && loaded_);
        if (!entry->isEnabled()) entry->setToolTip(why_not);
    }
}

void LayerRow::addCopies(QMenu& menu) {
    QMenu* copies = menu.addMenu(tr("Save a copy as"));
    copies->setStyleSheet(menuSheet(theme_));
    copies->setEnabled(loaded_);
    if (!loaded_) copies->menuAction()->setToolTip(noPixels());
    const auto add_kind = [&](const QString& text, PlanCopyKind kind) {
        copies->addAction(text, this, [this, kind] { emit copyWished(kind); });
    };
    add_kind(tr("GeoTIFF…"), PlanCopyKind::kGeoTiff);
    add_kind(tr("Image with world file…"), PlanCopyKind::kPng);
    add_kind(tr("ROS map…"), PlanCopyKind::kRosMap);
}

}  // namespace hedr
