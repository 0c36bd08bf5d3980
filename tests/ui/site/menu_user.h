#pragma once

#include <QMenu>
#include <QWidget>

#include "ui/site/layer_row.h"

namespace hedr::test {

// The entry of a menu, in its submenus too; nullptr: there is none.
inline QAction* entryOf(const QMenu& menu, const QString& text) {
    for (QAction* entry : menu.actions()) {
        if (entry->text() == text) return entry;
        if (!entry->menu()) continue;
        if (QAction* below = entryOf(*entry->menu(), text)) return below;
    }
    return nullptr;
}

// What the menu of an image in the layers offers. The platform of the tests cannot open menus.
class RowMenu {
  public:
    RowMenu(const QWidget& window, const QString& image) {
        for (auto* row : window.findChildren<LayerRow*>()) {
            if (row->name() == image && row->isVisible()) row->fill(menu_);
        }
    }
    QMenu& menu() { return menu_; }
    QAction* entry(const QString& text) const { return entryOf(menu_, text); }
    bool choose(const QString& text) const {
        QAction* chosen = entry(text);
        if (!chosen || !chosen->isEnabled()) return false;
        chosen->trigger();
        return true;
    }

  private:
    QMenu menu_{};
};

}  // namespace hedr::test
