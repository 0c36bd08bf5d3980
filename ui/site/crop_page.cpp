#include "ui/site/crop_page.h"

#include <QVBoxLayout>
#include <algorithm>

#include "ui/format.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr double kLeastSide_px = 8.0;  // plan pixels

}  // namespace

CropCard::CropCard(QWidget* parent)
    : Card(parent),
      size_(new QLabel(this)),
      advice_(
          new QLabel(tr("Only this part of the image is shown. The file stays as it is."), this)),
      whole_(new QPushButton(tr("Whole image"), this)) {
    setAccessibleName(tr("Crop the image"));
    setFixedWidth(332);
    size_->setProperty("role", QStringLiteral("value"));
    advice_->setProperty("role", QStringLiteral("text"));
    advice_->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 16, 20, 20);
    column->setSpacing(8);
    column->addWidget(size_);
    column->addWidget(advice_);
    column->addSpacing(8);
    column->addWidget(whole_);
    connect(whole_, &QPushButton::clicked, this, &CropCard::wholeWished);
    setVisible(false);
}

void CropCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    for (QLabel* label : {size_, advice_}) label->setStyleSheet(formSheet(theme));
    whole_->setStyleSheet(buttonSheet(theme));
}

void CropCard::show(const PlanCrop& crop, double resolution_m) {
    const Vector<Plan> size = crop.max - crop.min;
    size_->setText(tr("%1 × %2").arg(formatDistance(size.x * resolution_m),
                                     formatDistance(size.y * resolution_m)));
}

CropPage::CropPage(SiteModel& site, QWidget* map)
    : DeskPage(map), site_(site), card_(new CropCard(map)) {
    connect(card_, &CropCard::wholeWished, this, [this] { step(wholeImage()); });
}

QString CropPage::title() const {
    return tr("Crop %1").arg(QString::fromStdString(plan().image_file.filename().string()));
}

QString CropPage::hint() const { return tr("Drag the corners to what shall be seen."); }

PlanCrop CropPage::wholeImage() const {
    const PlanLevel& size = site_.image(plan())->levels.front();
    return {{0.0, 0.0}, {double(size.width_px), double(size.height_px)}};
}

void CropPage::begin() {
    held_.reset();
    crop_ = plan().crop.value_or(wholeImage());
    history_ = History<PlanCrop>(crop_);
    show();
}

// The whole image is seen meanwhile, so that a corner can be dragged outwards.
void CropPage::show() {
    Site site = site_.site();
    site.floors.at(site_.floorIndex()).plans.at(plan_).crop.reset();
    card_->show(crop_, plan().placement.resolution_m);
    site_.preview(std::move(site));
    emit changed();
}

void CropPage::step(const PlanCrop& crop) {
    crop_ = crop;
    history_.add(crop);
    show();
}

void CropPage::undo() {
    history_.undo();
    crop_ = history_.now();
    show();
}

void CropPage::cancel() {
    site_.dropPreview();
    emit finished();
}

void CropPage::accept() {
    Site next = site_.site();
    SitePlan& cropped = next.floors.at(site_.floorIndex()).plans.at(plan_);
    if (crop_ != wholeImage()) cropped.crop = crop_;
    site_.edit(std::move(next));
    emit finished();
}

Transform<World, Plan> CropPage::worldFromImage() const {
    return worldFromPlan(plan().placement, site_.image(plan())->levels.front().height_px);
}

ViewCorners CropPage::corners(const ViewTransform& view) const {
    const auto [min, max] = crop_;
    return viewCorners({{{min, {max.x, min.y}, max, {min.x, max.y}}}},
                       view.viewFromWorld() * worldFromImage());
}

bool CropPage::press(Point<View> at, const ViewTransform& view) {
    held_ = cornerAt(corners(view), at);
    return held_.has_value();
}

void CropPage::move(Point<View> at, const ViewTransform& view) {
    if (!held_) return;
    const Point<Plan> p = worldFromImage().inverse() * (view.worldFromView() * at);
    const PlanCrop whole = wholeImage();
    if (*held_ == 0 || *held_ == 3) {
        crop_.min.x = std::clamp(p.x, 0.0, crop_.max.x - kLeastSide_px);
    } else {
        crop_.max.x = std::clamp(p.x, crop_.min.x + kLeastSide_px, whole.max.x);
    }
    if (*held_ <= 1) {
        crop_.min.y = std::clamp(p.y, 0.0, crop_.max.y - kLeastSide_px);
    } else {
        crop_.max.y = std::clamp(p.y, crop_.min.y + kLeastSide_px, whole.max.y);
    }
    show();
}

void CropPage::release(Point<View>, const ViewTransform&) {
    if (held_ && crop_ != history_.now()) step(crop_);
    held_.reset();
}

void CropPage::click(Point<View>, const ViewTransform&) {}

void CropPage::paint(QPainter& painter, const ViewTransform& view, const Theme& theme) const {
    drawCorners(painter, corners(view), theme.accent, theme);
}

}  // namespace hedr
