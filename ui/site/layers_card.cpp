#include "ui/site/layers_card.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/map/map_view.h"
#include "ui/map/miniature.h"
#include "ui/site/floor_row.h"
#include "ui/site/row_area.h"
#include "ui/site/site_model.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kWidth_px = 332;
constexpr int kPictureDelay_ms = 250;  // changes come in bursts

// Rows in the list's column: as many as wished, new ones by `make`.
template <class Row, class Make>
void setCount(std::vector<Row*>& rows, QWidget* list, std::size_t count, Make make) {
    while (rows.size() > count) {
        rows.back()->hide();
        rows.back()->deleteLater();
        rows.pop_back();
    }
    while (rows.size() < count) {
        Row* row = make(rows.size());
        list->layout()->addWidget(row);
        row->show();
        rows.push_back(row);
    }
}

QString countText(std::size_t images) {
    if (images == 0) return LayersCard::tr("no image");
    return images == 1 ? LayersCard::tr("1 image") : LayersCard::tr("%1 images").arg(images);
}

QWidget* emptyList() {
    auto* list = new QWidget;
    auto* column = new QVBoxLayout(list);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    return list;
}

}  // namespace

LayersCard::LayersCard(SiteModel& site, MapView& map)
    : Card(&map),
      site_(site),
      map_(map),
      floors_title_(new QLabel(tr("Floors"), this)),
      add_floor_(new QPushButton(tr("Add a floor"), this)),
      floor_list_(emptyList()),
      floor_area_(new RowArea(floor_list_, this)),
      name_(new QLineEdit(this)),
      remove_floor_(new QPushButton(tr("Remove"), this)),
      empty_(new QLabel(tr("No image yet: open one, or drop it on the map."), this)),
      plan_list_(emptyList()),
      plan_area_(new RowArea(plan_list_, this)),
      open_(new QPushButton(tr("Open image…"), this)),
      walls_(new QPushButton(tr("Draw walls…"), this)),
      site_button_(new QPushButton(tr("Site"), this)),
      site_menu_(new QMenu(this)) {
    setAccessibleName(tr("Floors and images"));
    setFixedWidth(kWidth_px);
    build();
    picture_timer_.setSingleShot(true);
    connect(&picture_timer_, &QTimer::timeout, this, &LayersCard::drawPictures);
    connect(&site_, &SiteModel::changed, this, &LayersCard::showSite);
    connect(add_floor_, &QPushButton::clicked, this, &LayersCard::addFloor);
    connect(name_, &QLineEdit::editingFinished, this, &LayersCard::rename);
    connect(remove_floor_, &QPushButton::clicked, this,
            [this] { emit removeFloorWished(site_.floorIndex()); });
    connect(open_, &QPushButton::clicked, this, &LayersCard::openWished);
    connect(walls_, &QPushButton::clicked, this, &LayersCard::wallsWished);
    setVisible(false);
}

void LayersCard::build() {
    floors_title_->setProperty("role", QStringLiteral("title"));
    empty_->setProperty("role", QStringLiteral("hint"));
    empty_->setWordWrap(true);
    name_->setAccessibleName(tr("Name of the floor"));
    name_->setToolTip(tr("Type another name for this floor"));
    name_->setMaxLength(40);
    remove_floor_->setAccessibleName(tr("Remove this floor"));
    remove_floor_->setToolTip(tr("Remove this floor with its images and walls"));
    site_button_->setMenu(site_menu_);
    site_button_->setToolTip(tr("All floors, images and walls in one file"));
    site_menu_->addAction(tr("Open site…"), this, &LayersCard::openSiteWished);
    site_menu_->addAction(tr("Save site as…"), this, &LayersCard::saveSiteWished);
    site_menu_->addSeparator();
    site_menu_->addAction(tr("Corridors…"), this, &LayersCard::corridorsWished);
    site_menu_->addAction(tr("Tie to the globe…"), this, &LayersCard::tieWished);
    auto* floors = new QHBoxLayout;
    floors->setSpacing(0);
    floors->addWidget(floors_title_, 1);
    floors->addWidget(add_floor_);
    floors->addWidget(site_button_);
    auto* named = new QHBoxLayout;
    named->setSpacing(0);
    named->addWidget(name_, 1);
    named->addWidget(remove_floor_);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(open_, 1);
    buttons->addWidget(walls_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 12, 20, 20);
    column->setSpacing(8);
    column->addLayout(floors);
    column->addWidget(floor_area_);
    column->addSpacing(8);
    column->addLayout(named);
    column->addWidget(empty_);
    column->addWidget(plan_area_);
    column->addSpacing(4);
    column->addLayout(buttons);
    // A click leaves the keys with the map.
    for (auto* button : findChildren<QPushButton*>()) button->setFocusPolicy(Qt::TabFocus);
}

void LayersCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    for (QLabel* label : {floors_title_, empty_}) label->setStyleSheet(formSheet(theme));
    for (QPushButton* button : {add_floor_, remove_floor_})
        button->setStyleSheet(flatButtonSheet(theme));
    site_button_->setStyleSheet(flatMenuButtonSheet(theme));
    site_menu_->setStyleSheet(menuSheet(theme));
    name_->setStyleSheet(quietFieldSheet(theme));
    for (RowArea* area : {floor_area_, plan_area_}) area->setStyleSheet(scrollSheet(theme));
    const QString narrow = QStringLiteral("QPushButton { padding: 0 8px; font-size: 15px; }");
    for (QPushButton* button : {open_, walls_}) button->setStyleSheet(buttonSheet(theme) + narrow);
    for (FloorRow* row : floor_rows_) row->setTheme(theme);
    for (LayerRow* row : plan_rows_) row->setTheme(theme);
    picture_timer_.start(kPictureDelay_ms);
}

void LayersCard::showEvent(QShowEvent*) { showSite(); }

void LayersCard::showSite() {
    if (!isVisibleTo(parentWidget())) return;
    showFloors();
    showPlans();
    picture_timer_.start(kPictureDelay_ms);
}

void LayersCard::showFloors() {
    const auto& floors = site_.site().floors;
    setCount(floor_rows_, floor_list_, floors.size(), [this](std::size_t) {
        auto* row = new FloorRow(floor_list_);
        row->setTheme(theme());
        connect(row, &FloorRow::clicked, this, [this, row] {
            const auto at = std::ranges::find(floor_rows_, row) - floor_rows_.begin();
            site_.showFloor(floor_rows_.size() - 1 - static_cast<std::size_t>(at));
            showSite();
        });
        return row;
    });
    for (std::size_t i = 0; i < floors.size(); ++i) {
        const SiteFloor& floor = floors[floors.size() - 1 - i];
        const std::size_t index = floors.size() - 1 - i;
        const QString images = countText(floor.plans.size());
        const bool robot = index == site_.robotFloorIndex();
        floor_rows_[i]->setFloor(QString::fromStdString(floor.name),
                                 robot ? tr("%1 · the robot is here").arg(images) : images,
                                 index == site_.floorIndex());
    }
    floor_area_->setRows(static_cast<int>(floors.size()), FloorRow::kHeight_px, 1);
    floor_area_->keepInSight(floor_rows_[floors.size() - 1 - site_.floorIndex()]);
}

void LayersCard::showPlans() {
    const SiteFloor& floor = site_.floor();
    const std::size_t count = floor.plans.size();
    setCount(plan_rows_, plan_list_, count, [this](std::size_t) {
        auto* row = new LayerRow(plan_list_);
        row->setTheme(theme());
        connectRow(*row);
        return row;
    });
    for (std::size_t i = 0; i < count; ++i) {
        const SitePlan& plan = floor.plans[count - 1 - i];
        const QString warning =
            site_.warning(plan).isEmpty() && site_.liesByGuess(plan)
                ? tr("It says no scale and no place: they are a guess. Align it.")
                : site_.warning(plan);
        plan_rows_[i]->setPlan(plan, warning, i == 0, i + 1 == count);
        plan_rows_[i]->setLoaded(site_.wholeImage(plan) != nullptr);
    }
    plan_area_->setRows(static_cast<int>(count), LayerRow::kHeight_px, 1);
    empty_->setVisible(count == 0);
    walls_->setEnabled(count > 0);
    remove_floor_->setVisible(site_.site().floors.size() > 1);
    if (name_->hasFocus() && named_ == site_.floorIndex()) return;  // it is being typed
    named_ = site_.floorIndex();
    name_->setText(QString::fromStdString(floor.name));
}

void LayersCard::drawPictures() {
    std::vector<MapScene> scenes;
    for (std::size_t i = site_.site().floors.size(); i-- > 0;) {
        scenes.push_back(map_.sceneOf(site_.mapPlans(site_.site().floors[i]), i));
    }
    pictures_.start(
        [scenes = std::move(scenes), ratio = devicePixelRatioF()](const PlanProgress& progress) {
            std::vector<QImage> pictures;
            for (const MapScene& scene : scenes) {
                if (!progress(0.5)) break;
                pictures.push_back(miniatureOf(scene, FloorRow::kPicture, ratio));
            }
            return pictures;
        },
        [this](const std::vector<QImage>& pictures) {
            for (std::size_t i = 0; i < std::min(pictures.size(), floor_rows_.size()); ++i) {
                floor_rows_[i]->setPicture(pictures[i]);
            }
        });
}

void LayersCard::addFloor() {
    Site next = site_.site();
    next.floors.push_back({.name = tr("Floor %1").arg(next.floors.size() + 1).toStdString()});
    site_.edit(std::move(next));
}

void LayersCard::rename() {
    const std::string name = name_->text().trimmed().toStdString();
    name_->clearFocus();
    const auto& floors = site_.site().floors;
    if (named_ >= floors.size() || name.empty() || name == floors[named_].name) return showSite();
    Site next = site_.site();
    next.floors.at(named_).name = name;
    site_.edit(std::move(next));
}

void LayersCard::connectRow(LayerRow& row) {
    const auto plan = [this, &row] {
        const auto at = std::ranges::find(plan_rows_, &row) - plan_rows_.begin();
        return plan_rows_.size() - 1 - static_cast<std::size_t>(at);
    };
    connect(&row, &LayerRow::visibleWished, this, [this, plan](bool visible) {
        site_.edit(withPlan(plan(), [&](SitePlan& p) { p.visible = visible; }));
    });
    connect(&row, &LayerRow::opacityMoved, this, [this, plan](double opacity) {
        site_.preview(withPlan(plan(), [&](SitePlan& p) { p.opacity = opacity; }));
    });
    connect(&row, &LayerRow::opacityWished, this, [this, plan](double opacity) {
        site_.edit(withPlan(plan(), [&](SitePlan& p) { p.opacity = opacity; }));
    });
    connect(&row, &LayerRow::actionWished, this,
            [this, plan](LayerAction action) { act(action, plan()); });
    connect(&row, &LayerRow::copyWished, this,
            [this, plan](PlanCopyKind kind) { emit copyWished(plan(), kind); });
}

Site LayersCard::withPlan(std::size_t plan, const std::function<void(SitePlan&)>& change) const {
    Site next = site_.site();
    change(next.floors.at(site_.floorIndex()).plans.at(plan));
    return next;
}

void LayersCard::act(LayerAction action, std::size_t plan) {
    Site next = site_.site();
    std::vector<SitePlan>& plans = next.floors.at(site_.floorIndex()).plans;
    switch (action) {
        case LayerAction::kAlign:
            emit alignWished(plan);
            return;
        case LayerAction::kStraighten:
            emit straightenWished(plan);
            return;
        case LayerAction::kCrop:
            emit cropWished(plan);
            return;
        case LayerAction::kUp:
            std::swap(plans.at(plan), plans.at(plan + 1));
            break;
        case LayerAction::kDown:
            std::swap(plans.at(plan), plans.at(plan - 1));
            break;
        case LayerAction::kLock:
            plans.at(plan).locked = !plans.at(plan).locked;
            break;
        case LayerAction::kInvert:
            plans.at(plan).inverted_at_night = !plans.at(plan).inverted_at_night;
            break;
        case LayerAction::kRemove:
            plans.erase(plans.begin() + static_cast<std::ptrdiff_t>(plan));
            break;
    }
    site_.edit(std::move(next));
}

}  // namespace hedr
