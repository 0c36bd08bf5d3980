#include "ui/site/open_plan_dialog.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QVBoxLayout>

#include "ui/site/file_dialog_look.h"
#include "ui/site/plan_glancer.h"

namespace hedr {
namespace {

constexpr int kPane_px = 320;

struct FileKind {
    const char* name;
    const char* patterns;
};

constexpr FileKind kSites{QT_TRANSLATE_NOOP("OpenPlanDialog", "Sites"), "*.site.toml"};

constexpr FileKind kKinds[] = {
    {QT_TRANSLATE_NOOP("OpenPlanDialog", "Images"),
     "*.png *.jpg *.jpeg *.bmp *.tif *.tiff *.webp *.gif *.heic *.jp2 *.pgm *.ppm *.pbm"},
    {QT_TRANSLATE_NOOP("OpenPlanDialog", "Drawings"), "*.pdf *.svg *.dxf"},
    {QT_TRANSLATE_NOOP("OpenPlanDialog", "Maps that know their place"),
     "*.tif *.tiff *.mbtiles *.kml *.kmz *.yaml *.yml plan.toml"},
    kSites,
};

QString filterOf(const FileKind& kind) {
    return QStringLiteral("%1 (%2)").arg(OpenPlanDialog::tr(kind.name),
                                         QString::fromLatin1(kind.patterns));
}

}  // namespace

QStringList planNameFilters() {
    QStringList kinds;
    QStringList all{QStringLiteral("*.toml")};
    for (const FileKind& kind : kKinds) {
        kinds << filterOf(kind);
        all << QString::fromLatin1(kind.patterns).split(u' ');
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
    dress(*this, theme);
    setFileMode(QFileDialog::ExistingFiles);
    setOption(QFileDialog::ReadOnly);
    setNameFilters(planNameFilters());
    addPane();
    resize(1000, 600);
    connect(this, &QFileDialog::currentChanged, this, &OpenPlanDialog::look);
    connect(&glancer_, &PlanGlancer::glanced, this, &OpenPlanDialog::show);
}

void OpenPlanDialog::showSitesOnly() {
    setWindowTitle(tr("Open a site"));
    selectNameFilter(filterOf(kSites));
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
