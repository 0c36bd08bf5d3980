#include "ui/publish/publish_card.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>

#include "ui/error_text.h"
#include "ui/link/tone_label.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kWidth_px = 400;

QString nameOf(PublishKind kind) {
    switch (kind) {
        case PublishKind::kCot:
            return PublishCard::tr("Cursor-on-Target");
        case PublishKind::kNmea:
            return PublishCard::tr("NMEA 0183");
        case PublishKind::kJson:
            break;
    }
    return PublishCard::tr("Lines of JSON");
}

QString whereabouts(const PublishState& state) {
    const bool outside = leavesThisComputer(state.target);
    if (state.target.kind == PublishKind::kCot) {
        return outside ? PublishCard::tr("Sent. Others on the network can read it.")
                       : PublishCard::tr("Sent to programs on this computer.");
    }
    const QString clients = state.clients == 0 ? PublishCard::tr("Nobody listens yet.")
                            : state.clients == 1
                                ? PublishCard::tr("One program listens.")
                                : PublishCard::tr("%1 programs listen.").arg(state.clients);
    return outside ? clients + u' ' + PublishCard::tr("Others on the network may connect.")
                   : clients;
}

}  // namespace

PublishCard::PublishCard(QWidget* parent)
    : TitledCard(tr("Publish"), parent),
      what_(new QLabel(tr("Tells other programs where the robots are."), this)) {
    setFixedWidth(kWidth_px);
    what_->setWordWrap(true);
    column().addWidget(what_);
    for (const PublishKind kind : {PublishKind::kJson, PublishKind::kNmea, PublishKind::kCot}) {
        addRow(kind);
    }
}

void PublishCard::addRow(PublishKind kind) {
    const Row row{kind, new QCheckBox(nameOf(kind), this),
                  new QLineEdit(addressText(defaultTarget(kind)), this), new QLabel(this)};
    row.on->setObjectName(publishWord(kind));
    row.address->setObjectName(publishWord(kind) + QStringLiteral("_address"));
    row.address->setAccessibleName(tr("Address for %1").arg(nameOf(kind)));
    row.address->setToolTip(kind == PublishKind::kCot
                                ? tr("udp://HOST:PORT; a group of the local network, too")
                                : tr("tcp://:PORT for this computer only, tcp://@ADDRESS:PORT "
                                     "for others too"));
    row.state->setObjectName(publishWord(kind) + QStringLiteral("_state"));
    row.state->setWordWrap(true);
    auto* line = new QHBoxLayout;
    line->setSpacing(12);
    line->addWidget(row.on, 1);
    line->addWidget(row.address);
    row.address->setFixedWidth(190);
    auto* block = new QVBoxLayout;
    block->setSpacing(0);
    block->addLayout(line);
    block->addWidget(row.state);
    column().addLayout(block);
    rows_.push_back(row);
    connect(row.on, &QCheckBox::toggled, this, &PublishCard::wish);
    connect(row.address, &QLineEdit::editingFinished, this, [this, row] {
        if (row.on->isChecked() && row.address->isModified()) wish();
        row.address->setModified(false);
    });
}

void PublishCard::setTheme(const Theme& theme) {
    TitledCard::setTheme(theme);
    const QString small_field = QStringLiteral(
        "QLineEdit { font-size: 15px; min-height: 30px; }"
        "QLineEdit:focus { min-height: 28px; }");
    what_->setStyleSheet(formSheet(theme));
    for (const Row& row : rows_) {
        row.state->setStyleSheet(formSheet(theme));
        row.on->setStyleSheet(formSheet(theme));
        row.address->setStyleSheet(formSheet(theme) + small_field);
    }
    for (QWidget* child : findChildren<QWidget*>()) child->ensurePolished();
    layout()->invalidate();
    adjustSize();
}

// An address that cannot be meant is said beside it, and that row stays off.
void PublishCard::wish() {
    std::vector<PublishTarget> targets;
    targets.reserve(rows_.size());
    for (const Row& row : rows_) {
        if (!row.on->isChecked()) {
            say(row, {}, false);
            continue;
        }
        const auto target = parsePublishAddress(row.kind, row.address->text().trimmed());
        if (target) {
            targets.push_back(*target);
            continue;
        }
        const QSignalBlocker quiet(row.on);
        row.on->setChecked(false);
        say(row, errorText(target.error()), true);
    }
    emit targetsWished(targets);
}

void PublishCard::show(const std::vector<PublishState>& states) {
    for (const Row& row : rows_) {
        const auto state = std::ranges::find_if(
            states, [&](const PublishState& each) { return each.target.kind == row.kind; });
        showRow(row, state == states.end() ? nullptr : &*state);
    }
    layout()->activate();
    adjustSize();
}

void PublishCard::showRow(const Row& row, const PublishState* state) {
    const QSignalBlocker quiet(row.on);
    const bool was_on = row.on->isChecked();
    row.on->setChecked(state != nullptr);
    if (!state) {
        if (was_on) say(row, {}, false);
        return;
    }
    if (!row.address->hasFocus()) row.address->setText(addressText(state->target));
    say(row, state->error ? errorText(*state->error) : whereabouts(*state),
        state->error || leavesThisComputer(state->target));
}

void PublishCard::say(const Row& row, const QString& text, bool trouble) {
    row.state->setText(text);
    row.state->setVisible(!text.isEmpty());
    setTone(*row.state, trouble ? Tone::kWarning : Tone::kDim);
}

}  // namespace hedr
