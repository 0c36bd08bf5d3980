#include "ui/panels/titled_card.h"

#include <QHBoxLayout>
#include <QKeyEvent>

#include "ui/icons.h"
#include "ui/style_sheet.h"

namespace hedr {

TitledCard::TitledCard(const QString& title, QWidget* parent)
    : Card(parent),
      text_(title),
      title_(new QLabel(title, this)),
      close_(new QPushButton(this)),
      column_(new QVBoxLayout(this)) {
    setAccessibleName(title);
    title_->setProperty("role", QStringLiteral("title"));
    close_->setAccessibleName(tr("Close"));
    close_->setToolTip(tr("Close (Esc)"));
    close_->setFixedSize(40, 40);
    auto* head = new QHBoxLayout;
    head->addWidget(title_, 1);
    head->addWidget(close_);
    column_->setContentsMargins(20, 12, 20, 20);
    column_->setSpacing(8);
    column_->addLayout(head);
    connect(close_, &QPushButton::clicked, this, &TitledCard::closeWished);
    setVisible(false);
}

void TitledCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    title_->setStyleSheet(formSheet(theme));
    close_->setStyleSheet(flatButtonSheet(theme));
    close_->setIcon(QIcon(iconPixmap(QStringLiteral("close"), theme.ink, 20, devicePixelRatioF())));
}

void TitledCard::sayWhose(const QString& whose) {
    title_->setText(whose.isEmpty() ? text_ : tr("%1 · %2").arg(text_, whose));
}

void TitledCard::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        emit closeWished();
    } else {
        Card::keyPressEvent(event);
    }
}

}  // namespace hedr
