#pragma once

#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

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

  signals:
    void visibleWished(bool visible);
    void opacityMoved(double opacity);   // while the slider is held
    void opacityWished(double opacity);  // where it was let go
    void actionWished(hedr::LayerAction action);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void openMenu();
    void setIcons();
    void elide();

    Theme theme_ = dayTheme();
    SitePlan plan_{};
    bool top_ = false;
    bool bottom_ = false;
    QPushButton* eye_;
    QLabel* name_;
    QLabel* note_;
    QSlider* opacity_;
    QPushButton* more_;
};

}  // namespace hedr
