#pragma once

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

#include "core/site/plan_copy.h"
#include "core/site/site.h"
#include "ui/theme.h"

namespace hedr {

// What can be done to one image of a floor, beside showing it and its opacity.
enum class LayerAction { kAlign, kStraighten, kCrop, kUp, kDown, kLock, kInvert, kRemove };

// One image of the list: shown or not, its name, how opaque it is, and a menu of the rest.
class LayerRow : public QWidget {
    Q_OBJECT

  public:
    static constexpr int kHeight_px = 68;

    explicit LayerRow(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    // `warning`: what is wrong with its image file, or nothing.
    void setPlan(const SitePlan& plan, const QString& warning, bool top, bool bottom);
    void setLoaded(bool loaded) { loaded_ = loaded; }  // its pixels are there
    QString name() const;
    void fill(QMenu& menu);  // with what can be done to the image

  signals:
    void visibleWished(bool visible);
    void opacityMoved(double opacity);   // while the slider is held
    void opacityWished(double opacity);  // where it was let go
    void actionWished(hedr::LayerAction action);
    void copyWished(hedr::PlanCopyKind kind);  // for another program

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void openMenu();
    void addWork(QMenu& menu);
    void addCopies(QMenu& menu);
    QAction* add(QMenu& menu, const QString& text, LayerAction action);
    void setIcons();
    void elide();

    Theme theme_ = dayTheme();
    SitePlan plan_{};
    bool top_ = false;
    bool bottom_ = false;
    bool loaded_ = true;
    QPushButton* eye_;
    QLabel* name_;
    QLabel* note_;
    QSlider* opacity_;
    QPushButton* more_;
};

}  // namespace hedr
