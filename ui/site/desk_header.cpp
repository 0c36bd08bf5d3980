#include "ui/site/desk_header.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>

#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kHeight_px = 89;  // as the status strip has, so that the map does not jump

}  // namespace

DeskHeader::DeskHeader(QWidget* parent)
    : QWidget(parent),
      title_(new QLabel(this)),
      hint_(new QLabel(this)),
      undo_(new QPushButton(tr("Undo"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      done_(new QPushButton(tr("Done"), this)) {
    setFixedHeight(kHeight_px);
    title_->setProperty("role", QStringLiteral("title"));
    hint_->setProperty("role", QStringLiteral("hint"));
    hint_->setWordWrap(true);
    auto* words = new QVBoxLayout;
    words->setSpacing(4);
    words->addStretch();
    words->addWidget(title_);
    words->addWidget(hint_);
    words->addStretch();
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(32, 0, 24, 0);
    row->setSpacing(12);
    row->addLayout(words, 1);
    for (QPushButton* button : {undo_, cancel_, done_}) {
        button->setMinimumWidth(112);
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
    }
    undo_->setToolTip(tr("Take back the last step (Ctrl+Z)"));
    cancel_->setToolTip(tr("Leave everything as it was (Esc)"));
    done_->setToolTip(tr("Keep it so"));
    connect(undo_, &QPushButton::clicked, this, &DeskHeader::undoWished);
    connect(cancel_, &QPushButton::clicked, this, &DeskHeader::cancelWished);
    connect(done_, &QPushButton::clicked, this, &DeskHeader::doneWished);
    setVisible(false);
}

void DeskHeader::setTheme(const Theme& theme) {
    theme_ = theme;
    for (QLabel* label : {title_, hint_}) label->setStyleSheet(formSheet(theme));
    for (QPushButton* button : {undo_, cancel_}) button->setStyleSheet(buttonSheet(theme));
    done_->setStyleSheet(primaryButtonSheet(theme));
    update();
}

void DeskHeader::show(const DeskPage& page) {
    title_->setText(page.title());
    hint_->setText(page.hint());
    undo_->setEnabled(page.canUndo());
    done_->setEnabled(page.canAccept());
    setVisible(true);
}

void DeskHeader::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), theme_.chrome);
    painter.fillRect(0, height() - 1, width(), 1, theme_.hairline);
}

}  // namespace hedr
