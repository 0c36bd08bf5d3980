#include "ui/panels/connect_card.h"

#include <QAbstractItemView>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>

#include "core/robot/vehicle.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kBaudRates[] = {9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600};
constexpr int kLookAgain_ms = 1000;

enum VehicleRole { kPreset = Qt::UserRole, kFile };

QLabel* labelFor(QWidget* field, const QString& text) {
    auto* label = new QLabel(text, field->parentWidget());
    label->setBuddy(field);
    field->setAccessibleName(text);
    return label;
}

// "FTDI FT232R USB UART A50285BI · ttyUSB0"
QString titleOf(const SerialPortEntry& port) {
    const QString device = QFileInfo(port.device).fileName();
    return port.name.isEmpty() ? port.device : port.name + QStringLiteral(" · ") + device;
}

bool samePorts(const std::vector<SerialPortEntry>& a, const std::vector<SerialPortEntry>& b) {
    return std::ranges::equal(a, b, {}, titleOf, titleOf);
}

}  // namespace

ConnectCard::ConnectCard(QWidget* parent) : Card(parent) {
    setAccessibleName(tr("Connect to a robot"));
    createFields();
    layOut();
    setFixedWidth(420);
    look_again_.setInterval(kLookAgain_ms);
    connect(&look_again_, &QTimer::timeout, this, &ConnectCard::portsWanted);
    connect(port_, &QComboBox::editTextChanged, this, &ConnectCard::updateButton);
    connect(port_, &QComboBox::activated, this, [this] {
        touched_ = true;
        showSettings();
    });
    connect(port_->lineEdit(), &QLineEdit::textEdited, this, [this] { touched_ = true; });
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
    port_->lineEdit()->setPlaceholderText(tr("Serial port, tcp://HOST:PORT or udp://:PORT"));
    port_->setToolTip(
        tr("A serial port, tcp://HOST:PORT, udp://HOST:PORT; to wait for a robot "
           "tcp://:PORT, udp://:PORT; to play a recording the name of its file, "
           ".hedr or .csv; to simulate sim://packbot-corridors"));
    port_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    baud_ = new QComboBox(this);
    baud_->setObjectName(QStringLiteral("baud"));
    baud_->addItem(tr("Find out"), 0);
    for (const int rate : kBaudRates) baud_->addItem(QString::number(rate), rate);
    vehicle_ = new QComboBox(this);
    vehicle_->setObjectName(QStringLiteral("vehicle"));
    vehicle_->addItem(tr("As the robot says"));
    for (const Vehicle& preset : vehiclePresets()) {
        const QString name = QString::fromStdString(preset.name);
        vehicle_->addItem(name);
        vehicle_->setItemData(vehicle_->count() - 1, name, kPreset);
    }
    vehicle_->addItem(tr("File…"));
    call_sign_ = new QLineEdit(this);
    call_sign_->setObjectName(QStringLiteral("call_sign"));
    call_sign_->setMaxLength(24);
    call_sign_->setPlaceholderText(tr("As the robot says"));
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
    grid->addWidget(port_, 3, 0, 1, 3);
    grid->addWidget(advice_, 4, 0, 1, 3);
    grid->setRowMinimumHeight(5, 4);
    grid->addWidget(labelFor(baud_, tr("Baud rate")), 6, 0);
    grid->addWidget(baud_, 7, 0);
    grid->addWidget(labelFor(vehicle_, tr("Vehicle")), 6, 1, 1, 2);
    grid->addWidget(vehicle_, 7, 1, 1, 2);
    grid->setRowMinimumHeight(8, 4);
    grid->addWidget(labelFor(call_sign_, tr("Call sign")), 9, 0, 1, 3);
    grid->addWidget(call_sign_, 10, 0, 1, 3);
    grid->setRowMinimumHeight(11, 12);
    grid->addWidget(connect_, 12, 0, 1, 3);
    grid->setColumnStretch(0, 2);
    grid->setColumnStretch(1, 3);
}

void ConnectCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    for (QLabel* label : findChildren<QLabel*>()) label->setStyleSheet(formSheet(theme));
    for (QComboBox* field : {port_, baud_, vehicle_}) field->setStyleSheet(formSheet(theme));
    call_sign_->setStyleSheet(formSheet(theme));
    connect_->setStyleSheet(primaryButtonSheet(theme));
    // Sizes come from the style sheets: they must count before the card is first seen.
    for (QWidget* child : findChildren<QWidget*>()) child->ensurePolished();
    layout()->invalidate();
    adjustSize();
}

void ConnectCard::setPorts(const std::vector<SerialPortEntry>& ports) {
    if (samePorts(ports, ports_) || port_->view()->isVisible()) return;
    const QString chosen = port_->currentText();
    const QSignalBlocker quiet(port_);
    ports_ = ports;
    port_->clear();
    for (const SerialPortEntry& port : ports_) port_->addItem(titleOf(port));
    if (touched_) {
        port_->setEditText(chosen);
    } else {
        chooseProposed();
        if (port_->currentText() != chosen) showSettings();
    }
    updateButton();
}

void ConnectCard::propose(const ConnectRequest& earlier) {
    earlier_ = earlier;
    touched_ = false;
    chooseProposed();
    showSettings();
    updateButton();
}

// What was set for the robot of last time is not for the one behind another adapter.
void ConnectCard::showSettings() {
    const SerialPortEntry* port = chosenPort();
    const bool same = port ? isEarlier(*port) : port_->currentText().trimmed() == earlier_.port;
    const ConnectRequest settings = same ? earlier_ : ConnectRequest{};
    baud_->setCurrentIndex(std::max(baud_->findData(settings.baud), 0));
    showVehicle(settings);
    call_sign_->setText(settings.call_sign);
}

bool ConnectCard::isEarlier(const SerialPortEntry& port) const {
    return earlier_.identity.isEmpty() ? port.device == earlier_.port
                                       : port.identity == earlier_.identity;
}

void ConnectCard::showVehicle(const ConnectRequest& earlier) {
    int index = 0;
    if (!earlier.vehicle_preset.isEmpty()) {
        index = vehicle_->findData(earlier.vehicle_preset, kPreset);
    } else if (QFileInfo::exists(earlier.vehicle_file)) {
        index = vehicle_->findData(earlier.vehicle_file, kFile);
        if (index < 0) index = addVehicleFile(earlier.vehicle_file);
    }
    vehicle_->setCurrentIndex(std::max(index, 0));
}

// The adapter of last time, the address of last time, or the first adapter; a port of the computer
// itself is not guessed.
void ConnectCard::chooseProposed() {
    const auto found = std::ranges::find_if(
        ports_, [this](const SerialPortEntry& port) { return isEarlier(port); });
    const bool address = earlier_.port.contains(QLatin1String("://"));
    if (found != ports_.end()) {
        port_->setCurrentIndex(static_cast<int>(found - ports_.begin()));
    } else if (address) {
        port_->setEditText(earlier_.port);
    } else {
        const bool adapter = !ports_.empty() && !ports_.front().identity.isEmpty();
        port_->setCurrentIndex(adapter ? 0 : -1);
    }
}

const SerialPortEntry* ConnectCard::chosenPort() const {
    const QString text = port_->currentText().trimmed();
    const auto found = std::ranges::find_if(ports_, [&](const SerialPortEntry& port) {
        return titleOf(port) == text || port.device == text;
    });
    return found == ports_.end() ? nullptr : &*found;
}

void ConnectCard::updateButton() {
    const QString port = port_->currentText().trimmed();
    connect_->setEnabled(!port.isEmpty());
    const bool nothing = port.isEmpty();
    advice_->setText(nothing ? tr("No adapter yet. Plug the radio in: it appears here.")
                             : QString());
    advice_->setVisible(nothing);
    if (!port_->lineEdit()->hasFocus()) port_->lineEdit()->setCursorPosition(0);
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
    vehicle_->setCurrentIndex(addVehicleFile(file));
}

int ConnectCard::addVehicleFile(const QString& file) {
    const int index = vehicle_->count() - 1;  // "File…" stays the last
    vehicle_->insertItem(index, QFileInfo(file).fileName());
    vehicle_->setItemData(index, file, kFile);
    return index;
}

ConnectRequest ConnectCard::request() const {
    const SerialPortEntry* port = chosenPort();
    return {port ? port->device : port_->currentText().trimmed(),
            baud_->currentData().toInt(),
            port ? port->identity : QString(),
            vehicle_->currentData(kPreset).toString(),
            vehicle_->currentData(kFile).toString(),
            call_sign_->text().simplified()};
}

void ConnectCard::showEvent(QShowEvent*) { look_again_.start(); }

void ConnectCard::hideEvent(QHideEvent*) { look_again_.stop(); }

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
