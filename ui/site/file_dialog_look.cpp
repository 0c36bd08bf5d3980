#include "ui/site/file_dialog_look.h"

#include <QHeaderView>
#include <QLayout>
#include <QSplitter>
#include <QToolButton>
#include <QTreeView>

#include "ui/icons.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kIcon_px = 20;
constexpr int kButton_px = 36;

QIcon tintedIcon(const QString& name, const Theme& theme, double device_ratio) {
    QIcon icon(iconPixmap(name, theme.ink, kIcon_px, device_ratio));
    icon.addPixmap(iconPixmap(name, theme.hairline, kIcon_px, device_ratio), QIcon::Disabled);
    return icon;
}

void dressButtons(QFileDialog& dialog, const Theme& theme) {
    const bool saves = dialog.acceptMode() == QFileDialog::AcceptSave;
    const struct {
        const char* name;
        const char* icon;
    } buttons[] = {{"backButton", "left"},      {"forwardButton", "right"},
                   {"toParentButton", "up"},    {"newFolderButton", saves ? "folder-add" : nullptr},
                   {"listModeButton", nullptr}, {"detailModeButton", nullptr}};
    for (const auto& [name, icon] : buttons) {
        auto* button = dialog.findChild<QToolButton*>(QLatin1String(name));
        if (!button) continue;
        button->setVisible(icon != nullptr);
        if (!icon) continue;
        button->setFixedSize(kButton_px, kButton_px);
        button->setIconSize({kIcon_px, kIcon_px});
        button->setIcon(tintedIcon(QLatin1String(icon), theme, dialog.devicePixelRatioF()));
    }
}

void dressList(QFileDialog& dialog) {
    if (auto* places = dialog.findChild<QSplitter*>(QStringLiteral("splitter"))) {
        places->setSizes({140, 480});
    }
    auto* list = dialog.findChild<QTreeView*>(QStringLiteral("treeView"));
    if (!list) return;
    constexpr int kTypeColumn = 2;
    list->setColumnHidden(kTypeColumn, true);
    list->header()->setStretchLastSection(false);
    list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
}

}  // namespace

void dress(QFileDialog& dialog, const Theme& theme) {
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    dialog.setOption(QFileDialog::HideNameFilterDetails);
    dressButtons(dialog, theme);
    dressList(dialog);
    dialog.layout()->setContentsMargins(16, 16, 16, 16);
    dialog.setStyleSheet(dialogSheet(theme));
    dialog.layout()->setSizeConstraint(QLayout::SetNoConstraint);
    dialog.setMinimumSize(800, 480);
}

}  // namespace hedr
