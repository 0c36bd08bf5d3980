#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "ui/site/desk_page.h"
#include "ui/theme.h"

namespace hedr {

// The strip above the map while something is done to the plans: what, how, and the way out.
class DeskHeader : public QWidget {
    Q_OBJECT

  public:
    explicit DeskHeader(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void show(const DeskPage& page);

  signals:
    void undoWished();
    void cancelWished();
    void doneWished();

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    Theme theme_ = dayTheme();
    QLabel* title_;
    QLabel* hint_;
    QPushButton* undo_;
    QPushButton* cancel_;
    QPushButton* done_;
};

}  // namespace hedr
