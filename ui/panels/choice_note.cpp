#include "ui/panels/choice_note.h"

#include <QHBoxLayout>
#include <algorithm>

#include "ui/style_sheet.h"

namespace hedr {

ChoiceNote::ChoiceNote(const Answer& first, const Answer& second, QWidget* parent)
    : Card(parent),
      text_(new QLabel(this)),
      first_(new QPushButton(first.text, this)),
      second_(new QPushButton(second.text, this)) {
    text_->setProperty("role", QStringLiteral("text"));
    text_->setWordWrap(true);
    first_->setToolTip(first.tip);
    second_->setToolTip(second.tip);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(20, 8, 8, 8);
    row->setSpacing(8);
    row->addWidget(text_, 1);
    row->addSpacing(12);
    for (QPushButton* button : {first_, second_}) {
        button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys with the map
        row->addWidget(button);
    }
    connect(first_, &QPushButton::clicked, this, &ChoiceNote::firstChosen);
    connect(second_, &QPushButton::clicked, this, &ChoiceNote::secondChosen);
    setVisible(false);
}

void ChoiceNote::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    text_->setStyleSheet(formSheet(theme));
    for (QPushButton* button : {first_, second_}) button->setStyleSheet(buttonSheet(theme));
}

void ChoiceNote::setText(const QString& text) {
    text_->setText(text);
    setAccessibleName(text);
}

// On one line where there is room.
int ChoiceNote::widthWithin(int width_px) const {
    const int line_px = text_->fontMetrics().horizontalAdvance(text_->text()) + 4;
    const int around_px =
        first_->sizeHint().width() + second_->sizeHint().width() + 20 + 8 + 12 + 24;
    return std::min(width_px, line_px + around_px);
}

}  // namespace hedr
