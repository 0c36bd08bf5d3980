#include "ui/calibration/entry_rows.h"

#include <QCompleter>
#include <QStringListModel>

namespace hedr {

namespace {

constexpr int kField_px = 136;
constexpr int kMostLetters = 60;

// Anew only where it changed: it may be showing its list. True: it is a new one.
bool complete(QLineEdit& field, const QStringList& known) {
    auto* model =
        field.completer() ? qobject_cast<QStringListModel*>(field.completer()->model()) : nullptr;
    if (known == (model ? model->stringList() : QStringList())) return false;
    auto* completer = new QCompleter(known, &field);
    completer->setCaseSensitivity(Qt::CaseInsensitive);
    field.setCompleter(completer);
    return true;
}

}  // namespace

EntryRows::EntryRows(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
    grid_->setContentsMargins(0, 0, 4, 0);
    grid_->setHorizontalSpacing(12);
    grid_->setVerticalSpacing(8);
    grid_->setColumnStretch(0, 1);
    setVisible(false);
}

void EntryRows::addRow() {
    const Row row{new QLabel(this), new QLineEdit(this)};
    const int index = static_cast<int>(rows_.size());
    row.label->setProperty("role", QStringLiteral("words"));
    row.label->setTextFormat(Qt::PlainText);
    row.label->setWordWrap(true);
    row.label->setBuddy(row.field);
    row.field->setFixedWidth(kField_px);
    row.field->setMaxLength(kMostLetters);
    connect(row.field, &QLineEdit::textEdited, this,
            [this, index](const QString& text) { emit edited(index, text); });
    grid_->addWidget(row.label, index, 0);
    grid_->addWidget(row.field, index, 1);
    rows_.push_back(row);
}

void EntryRows::show(const std::vector<PageEntry>& entries) {
    while (rows_.size() < entries.size()) addRow();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const bool shown = i < entries.size();
        rows_[i].label->setVisible(shown);
        rows_[i].field->setVisible(shown);
        if (!shown) continue;
        rows_[i].label->setText(entries[i].label);
        rows_[i].field->setPlaceholderText(entries[i].empty_means);
        rows_[i].field->setAccessibleName(entries[i].label);
        if (complete(*rows_[i].field, entries[i].known)) {
            // What is picked from the list is not edited, by Qt's count.
            connect(rows_[i].field->completer(), qOverload<const QString&>(&QCompleter::activated),
                    this, [this, index = static_cast<int>(i)](const QString& text) {
                        emit edited(index, text);
                    });
        }
        if (!rows_[i].field->hasFocus()) rows_[i].field->setText(entries[i].text);
    }
    setVisible(!entries.empty());
}

}  // namespace hedr
