#include "ui/panels/floor_note.h"

#include <QHBoxLayout>
#include <algorithm>

#include "ui/style_sheet.h"

namespace hedr {

FloorNote::FloorNote(QWidget* parent)
    : Card(parent),
      text_(new QLabel(this)),
      here_(new QPushButton(tr("Robot is here"), this)),
      back_(new QPushButton(tr("Back to it"), this)) {
    text_->setProperty("role", QStringLiteral("text"));
    text_->setWordWrap(true);
    here_->setToolTip(tr("It has changed floors: its trail goes on here (Enter)"));
    back_->setToolTip(tr("Show the floor that the robot is on (R)"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(20, 8, 8, 8);
    row->setSpacing(8);
    row->addWidget(text_, 1);
    row->addSpacing(12);
    for (QPushButton* button : {here_, back_}) {
        button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys with the map
        row->addWidget(button);
    }
    connect(here_, &QPushButton::clicked, this, &FloorNote::robotIsHere);
    connect(back_, &QPushButton::clicked, this, &FloorNote::backWished);
    setVisible(false);
}

void FloorNote::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    text_->setStyleSheet(formSheet(theme));
    for (QPushButton* button : {here_, back_}) button->setStyleSheet(buttonSheet(theme));
}

void FloorNote::setFloors(const QString& shown, const QString& of_robot) {
    text_->setText(tr("This is %1. The robot is on %2.").arg(shown, of_robot));
    setAccessibleName(text_->text());
}

// On one line where there is room.
int FloorNote::widthWithin(int width_px) const {
    const int line_px = text_->fontMetrics().horizontalAdvance(text_->text()) + 4;
    const int around_px = here_->sizeHint().width() + back_->sizeHint().width() + 20 + 8 + 12 + 24;
    return std::min(width_px, line_px + around_px);
}

}  // namespace hedr
