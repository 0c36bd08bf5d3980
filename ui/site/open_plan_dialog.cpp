#include "ui/site/open_plan_dialog.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QHeaderView>
#include <QSplitter>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include "ui/icons.h"
#include "ui/site/plan_glancer.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kPane_px = 320;
constexpr int kIcon_px = 20;

struct FileKind {
    const char* name;
    const char* patterns;
};

constexpr FileKind kKinds[] = {
    {QT_TRANSLATE_NOOP("OpenPlanDialog", "Images"),
     "*.png *.jpg *.jpeg *.bmp *.tif *.tiff *.webp *.gif *.heic *.jp2 *.pgm *.ppm *.pbm"},
    {QT_TRANSLATE_NOOP("OpenPlanDialog", "Drawings"), "*.pdf *.svg *.dxf"},
    {QT_TRANSLATE_NOOP("OpenPlanDialog", "Maps that know their place"),
     "*.tif *.tiff *.mbtiles *.kml *.yaml *.yml plan.toml"},
    {QT_TRANSLATE_NOOP("OpenPlanDialog", "Sites"), "*.site.toml"},
};

QIcon tintedIcon(const QString& name, const Theme& theme, double device_ratio) {
    QIcon icon(iconPixmap(name, theme.ink, kIcon_px, device_ratio));
    icon.addPixmap(iconPixmap(name, theme.hairline, kIcon_px, device_ratio), QIcon::Disabled);
    return icon;
}

}  // namespace

QStringList planNameFilters() {
    QStringList kinds;
    QStringList all{QStringLiteral("*.toml")};
    for (const FileKind& kind : kKinds) {
        const QString patterns = QString::fromLatin1(kind.patterns);
        kinds << QStringLiteral("%1 (%2)").arg(OpenPlanDialog::tr(kind.name), patterns);
        all << patterns.split(u' ');
    }
    all.removeDuplicates();
    return QStringList(OpenPlanDialog::tr("Floor plans (%1)").arg(all.join(u' ')))
           << kinds << OpenPlanDialog::tr("All files (*)");
}

OpenPlanDialog::OpenPlanDialog(PlanGlancer& glancer, const Theme& theme, QWidget* parent)
    : QFileDialog(parent, tr("Open a floor plan")),
      glancer_(glancer),
      theme_(theme),
      picture_(new QLabel(this)),
      name_(new QLabel(this)),
      words_(new QLabel(this)) {
    setOption(QFileDialog::DontUseNativeDialog);  // it has no room for the picture
    setFileMode(QFileDialog::ExistingFiles);
    setOption(QFileDialog::ReadOnly);
    setOption(QFileDialog::HideNameFilterDetails);
    setNameFilters(planNameFilters());
    tidy();
    addPane();
    setStyleSheet(dialogSheet(theme));
    layout()->setSizeConstraint(QLayout::SetNoConstraint);
    setMinimumSize(800, 480);
    resize(1000, 600);
    connect(this, &QFileDialog::currentChanged, this, &OpenPlanDialog::look);
    connect(&glancer_, &PlanGlancer::glanced, this, &OpenPlanDialog::show);
}

// Qt's own buttons are made for a light desktop and for more than choosing a file.
void OpenPlanDialog::tidy() {
    const struct {
        const char* name;
        const char* icon;
    } buttons[] = {{"backButton", "left"},      {"forwardButton", "right"},
                   {"toParentButton", "up"},    {"newFolderButton", nullptr},
                   {"listModeButton", nullptr}, {"detailModeButton", nullptr}};
    for (const auto& [name, icon] : buttons) {
        auto* button = findChild<QToolButton*>(QLatin1String(name));
        if (!button) continue;
        button->setVisible(icon != nullptr);
        if (!icon) continue;
        button->setFixedSize(36, 36);
        button->setIconSize({kIcon_px, kIcon_px});
        button->setIcon(tintedIcon(QLatin1String(icon), theme_, devicePixelRatioF()));
    }
    if (auto* places = findChild<QSplitter*>(QStringLiteral("splitter"))) {
        places->setSizes({140, 480});
    }
    if (auto* list = findChild<QTreeView*>(QStringLiteral("treeView"))) {
        constexpr int kTypeColumn = 2;
        list->setColumnHidden(kTypeColumn, true);
        list->header()->setStretchLastSection(false);
        list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
        list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    }
}

void OpenPlanDialog::addPane() {
    auto* pane = new QVBoxLayout;
    pane->setContentsMargins(12, 0, 0, 0);
    pane->addWidget(picture_);
    pane->addWidget(name_);
    pane->addWidget(words_);
    pane->addStretch();
    picture_->setFixedSize(kPane_px, kPane_px);
    picture_->setAlignment(Qt::AlignCenter);
    picture_->setObjectName(QStringLiteral("picture"));
    picture_->setText(tr("Choose a file to see it here"));
    name_->setObjectName(QStringLiteral("name"));
    words_->setObjectName(QStringLiteral("words"));
    for (QLabel* label : {name_, words_}) {
        label->setFixedWidth(kPane_px);
        label->setWordWrap(true);
    }
    auto* grid = qobject_cast<QGridLayout*>(layout());
    grid->setContentsMargins(16, 16, 16, 16);
    grid->addLayout(pane, 0, grid->columnCount(), grid->rowCount(), 1);
}

void OpenPlanDialog::look(const QString& file) {
    file_ = QFileInfo(file).isFile() ? file : QString();
    picture_->setPixmap({});
    picture_->setText(file_.isEmpty() ? tr("Choose a file to see it here") : tr("Looking…"));
    name_->setText(file_.isEmpty() ? QString() : QFileInfo(file).fileName());
    words_->clear();
    if (!file_.isEmpty()) glancer_.want({{.file = file_}});
}

void OpenPlanDialog::show(const PlanFileWish& file, const PlanGlance& glance) {
    if (file.file != file_) return;
    words_->setText(glance.words);
    if (glance.picture.isNull()) return picture_->setText(tr("No plan"));
    const QImage fitted = glance.picture.scaled(picture_->size() * devicePixelRatioF(),
                                                Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QPixmap pixmap = QPixmap::fromImage(themedPicture(fitted, theme_));
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    picture_->setPixmap(pixmap);
}

}  // namespace hedr
