#include "ui/link/robot_card.h"

#include <QHBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/link/tone_label.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kWidth_px = 400;
constexpr int kField_px = 120;

constexpr CommandKind kCommands[] = {CommandKind::kMeasureBias, CommandKind::kResetPose,
                                     CommandKind::kHedrOn, CommandKind::kHedrOff};

QString labelOf(const ParameterMeaning& meaning) {
    const QString unit = parameterUnit(meaning.id);
    return unit.isEmpty() ? parameterName(meaning.id)
                          : parameterName(meaning.id) + QStringLiteral(", ") + unit;
}

}  // namespace

RobotCard::RobotCard(QWidget* parent)
    : TitledCard(tr("Robot"), parent),
      refusal_(new QLabel(this)),
      read_(new QPushButton(tr("Read"), this)),
      write_(new QPushButton(tr("Write changes"), this)),
      outcome_(new QLabel(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
    setFixedWidth(kWidth_px);
    for (QLabel* label : {refusal_, outcome_}) label->setWordWrap(true);
    refusal_->setProperty("role", QStringLiteral("text"));
    auto* grid = new QGridLayout;
    for (const ParameterMeaning& meaning : kParameterMeanings) addRow(meaning, *grid);
    for (const CommandKind kind : kCommands) {
        auto* button = new QPushButton(commandName(kind), this);
        connect(button, &QPushButton::clicked, this, [this, kind] {
            if (kind == CommandKind::kResetPose) return emit poseWished();
            emit asked(RobotCommand{.kind = kind});
        });
        commands_.push_back(button);
    }
    connect(read_, &QPushButton::clicked, this, &RobotCard::readAll);
    connect(write_, &QPushButton::clicked, this, &RobotCard::writeChanged);
    connect(cancel_, &QPushButton::clicked, this, &RobotCard::cancelWished);
    layOut(*grid);
}

void RobotCard::addRow(const ParameterMeaning& meaning, QGridLayout& grid) {
    const int line = 2 * static_cast<int>(rows_.size());
    Row row{meaning, new QLabel(labelOf(meaning), this), new QLineEdit(this), new QLabel(this)};
    row.name->setBuddy(row.value);
    row.value->setAccessibleName(row.name->text());
    row.value->setFixedWidth(kField_px);
    row.value->setAlignment(Qt::AlignRight);
    row.state->setVisible(false);
    connect(row.value, &QLineEdit::textChanged, this, &RobotCard::updateButtons);
    connect(row.value, &QLineEdit::returnPressed, this, &RobotCard::writeChanged);
    grid.addWidget(row.name, line, 0);
    grid.addWidget(row.value, line, 1);
    grid.addWidget(row.state, line + 1, 0, 1, 2);
    rows_.push_back(row);
}

void RobotCard::layOut(QGridLayout& grid) {
    grid.setVerticalSpacing(2);
    grid.setColumnStretch(0, 1);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(read_, 1);
    buttons->addWidget(write_, 2);
    auto* commands = new QGridLayout;
    commands->setSpacing(8);
    for (std::size_t i = 0; i < commands_.size(); ++i) {
        commands->addWidget(commands_[i], static_cast<int>(i / 2), static_cast<int>(i % 2));
    }
    auto* end = new QHBoxLayout;
    end->addWidget(outcome_, 1);
    end->addWidget(cancel_);
    column().addWidget(refusal_);
    column().addLayout(&grid);
    column().addLayout(buttons);
    column().addSpacing(4);
    column().addLayout(commands);
    column().addLayout(end);
}

void RobotCard::setTheme(const Theme& theme) {
    TitledCard::setTheme(theme);
    const QString small_field = QStringLiteral(
        "QLineEdit { font-size: 15px; min-height: 30px; }"
        "QLineEdit:focus { min-height: 28px; }");
    for (QLabel* label : {refusal_, outcome_}) label->setStyleSheet(formSheet(theme));
    for (const Row& row : rows_) {
        for (QLabel* label : {row.name, row.state}) label->setStyleSheet(formSheet(theme));
        row.value->setStyleSheet(formSheet(theme) + small_field);
    }
    const QString narrow =
        QStringLiteral("QPushButton { padding: 0 8px; font-size: 15px; min-height: 36px; }");
    for (QPushButton* button : commands_) button->setStyleSheet(buttonSheet(theme) + narrow);
    for (QPushButton* button : {read_, cancel_}) button->setStyleSheet(buttonSheet(theme) + narrow);
    write_->setStyleSheet(primaryButtonSheet(theme) + narrow);
    updateButtons();
}

void RobotCard::show(const RequestBoard& board, const QString& whose, const QString& refusal) {
    sayWhose(whose);
    busy_ = board.busy();
    refused_ = !refusal.isEmpty();
    refusal_->setText(refusal);
    refusal_->setVisible(refused_);
    for (Row& row : rows_) showRow(row, board);
    showCommand(board);
    updateButtons();
    readAtFirst(board);
    layout()->activate();
    adjustSize();
}

// What the operator is typing is left alone, until the robot has it.
void RobotCard::showRow(Row& row, const RequestBoard& board) {
    const auto raw = board.value(row.meaning.id);
    const QString text = raw ? parameterText(row.meaning, *raw) : QString();
    if (text != row.shown) {
        if (!changed(row)) row.value->setText(text);
        row.shown = text;
    }
    const RequestProgress* progress = board.ofParameter(row.meaning.id);
    const QString state = progress ? progressText(*progress) : QString();
    row.state->setText(state);
    row.state->setVisible(!state.isEmpty());
    if (progress) setTone(*row.state, progressTone(*progress));
}

void RobotCard::showCommand(const RequestBoard& board) {
    const RequestProgress* progress = board.latestCommand();
    if (!progress) return outcome_->clear();
    const QString name = commandName(std::get<RobotCommand>(progress->wish).kind);
    const QString state = progressText(*progress);
    outcome_->setText(name + QStringLiteral(": ") + (state.isEmpty() ? tr("done") : state));
    setTone(*outcome_, progressTone(*progress));
}

bool RobotCard::changed(const Row& row) const {
    return row.value->text().trimmed() != row.shown && !row.value->text().trimmed().isEmpty();
}

// Nobody opens the card to see empty fields.
void RobotCard::readAtFirst(const RequestBoard& board) {
    const bool asked_before = std::ranges::any_of(
        rows_, [&](const Row& row) { return board.ofParameter(row.meaning.id) != nullptr; });
    if (refused_ || asked_before) {
        read_at_first_ = false;
    } else if (!std::exchange(read_at_first_, true)) {
        readAll();
    }
}

void RobotCard::readAll() {
    for (const Row& row : rows_) {
        row.value->setText(row.shown);  // what was typed is given up
        emit asked(ParameterGet{static_cast<std::uint8_t>(row.meaning.id)});
    }
}

void RobotCard::writeChanged() {
    if (!write_->isEnabled()) return;
    for (const Row& row : rows_) {
        if (!changed(row)) continue;
        if (const auto raw = parameterFromText(row.meaning, row.value->text()))
            emit asked(ParameterSet{static_cast<std::uint8_t>(row.meaning.id), *raw});
    }
}

void RobotCard::updateButtons() {
    bool any = false;
    bool usable = true;
    for (const Row& row : rows_) {
        if (!changed(row)) continue;
        any = true;
        usable = usable && parameterFromText(row.meaning, row.value->text()).has_value();
    }
    write_->setEnabled(any && usable && !busy_ && !refused_);
    read_->setEnabled(!busy_ && !refused_);
    for (QPushButton* button : commands_) button->setEnabled(!busy_ && !refused_);
    cancel_->setVisible(busy_);
}

}  // namespace hedr
