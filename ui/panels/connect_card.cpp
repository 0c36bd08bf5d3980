#include "ui/panels/connect_card.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QVBoxLayout>

#include "core/robot/vehicle.h"
#include "ui/icons.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kBaudRates[] = {9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600};
constexpr int kUsualBaud = 57600;

enum VehicleRole { kPreset = Qt::UserRole, kFile };

QLabel* labelFor(QWidget* field, const QString& text) {
    auto* label = new QLabel(text, field->parentWidget());
    label->setBuddy(field);
    field->setAccessibleName(text);
    return label;
}

}  // namespace

ConnectCard::ConnectCard(QWidget* parent) : Card(parent) {
    setAccessibleName(tr("Connect to a robot"));
    createFields();
    layOut();
    setFixedWidth(420);
    connect(port_, &QComboBox::editTextChanged, this, &ConnectCard::updateButton);
    connect(refresh_, &QPushButton::clicked, this, &ConnectCard::portsWanted);
    connect(vehicle_, &QComboBox::activated, this, &ConnectCard::chooseVehicle);
    connect(connect_, &QPushButton::clicked, this, [this] { emit connectRequested(request()); });
    updateButton();
}

void ConnectCard::createFields() {
    title_ = new QLabel(tr("Connect to a robot"), this);
    title_->setProperty("role", QStringLiteral("title"));
    port_ = new QComboBox(this);
    port_->setObjectName(QStringLiteral("port"));
    port_->setEditable(true);
    port_->setInsertPolicy(QComboBox::NoInsert);
    port_->lineEdit()->setPlaceholderText(tr("/dev/ttyUSB0"));
    refresh_ = new QPushButton(this);
    refresh_->setAccessibleName(tr("Look for ports again"));
    refresh_->setToolTip(refresh_->accessibleName());
    refresh_->setFixedWidth(52);
    baud_ = new QComboBox(this);
    baud_->setObjectName(QStringLiteral("baud"));
    for (const int rate : kBaudRates) baud_->addItem(QString::number(rate), rate);
    baud_->setCurrentIndex(baud_->findData(kUsualBaud));
    vehicle_ = new QComboBox(this);
    vehicle_->setObjectName(QStringLiteral("vehicle"));
    vehicle_->addItem(tr("As the robot says"));
    for (const Vehicle& preset : vehiclePresets()) {
        const QString name = QString::fromStdString(preset.name);
        vehicle_->addItem(name);
        vehicle_->setItemData(vehicle_->count() - 1, name, kPreset);
    }
    vehicle_->addItem(tr("File…"));
    advice_ = new QLabel(this);
    advice_->setWordWrap(true);
    connect_ = new QPushButton(tr("Connect"), this);
    connect_->setObjectName(QStringLiteral("connect"));
}

void ConnectCard::layOut() {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(24, 20, 24, 24);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->addWidget(title_, 0, 0, 1, 3);
    grid->setRowMinimumHeight(1, 4);
    grid->addWidget(labelFor(port_, tr("Port")), 2, 0, 1, 3);
    grid->addWidget(port_, 3, 0, 1, 2);
    grid->addWidget(refresh_, 3, 2);
    grid->addWidget(advice_, 4, 0, 1, 3);
    grid->setRowMinimumHeight(5, 4);
    grid->addWidget(labelFor(baud_, tr("Baud rate")), 6, 0);
    grid->addWidget(baud_, 7, 0);
    grid->addWidget(labelFor(vehicle_, tr("Vehicle")), 6, 1, 1, 2);
    grid->addWidget(vehicle_, 7, 1, 1, 2);
    grid->setRowMinimumHeight(8, 12);
    grid->addWidget(connect_, 9, 0, 1, 3);
    grid->setColumnStretch(0, 2);
    grid->setColumnStretch(1, 3);
}

void ConnectCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    for (QLabel* label : findChildren<QLabel*>()) label->setStyleSheet(formSheet(theme));
    for (QComboBox* field : {port_, baud_, vehicle_}) field->setStyleSheet(formSheet(theme));
    refresh_->setStyleSheet(buttonSheet(theme) + QStringLiteral("QPushButton { padding: 0; }"));
    refresh_->setIcon(
        QIcon(iconPixmap(QStringLiteral("refresh"), theme.ink, 20, devicePixelRatioF())));
    refresh_->setIconSize({20, 20});
    connect_->setStyleSheet(primaryButtonSheet(theme));
    // Sizes come from the style sheets: they must count before the card is first seen.
    for (QWidget* child : findChildren<QWidget*>()) child->ensurePolished();
    layout()->invalidate();
    adjustSize();
}

void ConnectCard::setPorts(const std::vector<SerialPortEntry>& ports) {
    const QString typed = port_->currentText();
    port_->clear();
    for (const SerialPortEntry& port : ports) {
        port_->addItem(port.device);
        port_->setItemData(port_->count() - 1, port.description, Qt::ToolTipRole);
    }
    if (!typed.isEmpty()) port_->setEditText(typed);
    updateButton();
}

void ConnectCard::updateButton() {
    const QString port = port_->currentText().trimmed();
    connect_->setEnabled(!port.isEmpty());
    const int known = port_->findText(port);
    const QString description =
        known >= 0 ? port_->itemData(known, Qt::ToolTipRole).toString() : QString();
    if (port_->count() == 0 && port.isEmpty()) {
        advice_->setText(tr("No serial port found. Plug the radio in, then look again."));
    } else {
        advice_->setText(description);
    }
    advice_->setVisible(!advice_->text().isEmpty());
    adjustSize();
}

void ConnectCard::chooseVehicle(int index) {
    if (index != vehicle_->count() - 1) return;
    const QString file = QFileDialog::getOpenFileName(this, tr("Choose a vehicle file"), {},
                                                      tr("Vehicle files (*.toml)"));
    if (file.isEmpty()) {
        vehicle_->setCurrentIndex(0);
        return;
    }
    vehicle_->insertItem(index, QFileInfo(file).fileName());
    vehicle_->setItemData(index, file, kFile);
    vehicle_->setCurrentIndex(index);
}

ConnectRequest ConnectCard::request() const {
    return {port_->currentText().trimmed(), baud_->currentData().toInt(),
            vehicle_->currentData(kPreset).toString(), vehicle_->currentData(kFile).toString()};
}

void ConnectCard::keyPressEvent(QKeyEvent* event) {
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && connect_->isEnabled()) {
        connect_->click();
    } else if (event->key() == Qt::Key_Escape) {
        hide();
    } else {
        Card::keyPressEvent(event);
    }
}

}  // namespace hedr
