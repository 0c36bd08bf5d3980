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

EntryRows::EntryRows(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
    column_->setContentsMargins(0, 0, 4, 0);
    column_->setSpacing(8);
    setVisible(false);
}

void EntryRows::addRow() {
    const Row row{new QLabel(this), new QLineEdit(this), new QCheckBox(this)};
    const int index = static_cast<int>(rows_.size());
    row.label->setProperty("role", QStringLiteral("words"));
    row.label->setTextFormat(Qt::PlainText);
    row.label->setWordWrap(true);
    row.label->setBuddy(row.field);
    row.field->setFixedWidth(kField_px);
    row.field->setMaxLength(kMostLetters);
    connect(row.field, &QLineEdit::textEdited, this,
            [this, index](const QString& text) { emit edited(index, text); });
    connect(row.box, &QCheckBox::clicked, this, [this, index](bool on) {
        emit edited(index, on ? kSwitchedOn.toString() : QString());
    });
    auto* line = new QHBoxLayout;
    line->setSpacing(12);
    line->addWidget(row.label, 1);
    line->addWidget(row.field);
    line->addWidget(row.box, 1);
    column_->addLayout(line);
    rows_.push_back(row);
}

void EntryRows::fill(int index, const PageEntry& entry) {
    const Row& row = rows_[static_cast<std::size_t>(index)];
    row.label->setText(entry.label);
    row.field->setPlaceholderText(entry.empty_means);
    row.field->setAccessibleName(entry.label);
    row.box->setText(entry.label);
    row.box->setChecked(entry.text == kSwitchedOn);
    if (complete(*row.field, entry.known)) {
        // What is picked from the list is not edited, by Qt's count.
        connect(row.field->completer(), qOverload<const QString&>(&QCompleter::activated), this,
                [this, index](const QString& text) { emit edited(index, text); });
    }
    if (!row.field->hasFocus()) row.field->setText(entry.text);
}

void EntryRows::show(const std::vector<PageEntry>& entries) {
    while (rows_.size() < entries.size()) addRow();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const bool shown = i < entries.size();
        const bool ticked = shown && entries[i].is_switch;
        rows_[i].label->setVisible(shown && !ticked);
        rows_[i].field->setVisible(shown && !ticked);
        rows_[i].box->setVisible(ticked);
        if (shown) fill(static_cast<int>(i), entries[i]);
    }
    setVisible(!entries.empty());
}

}  // namespace hedr
