#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <vector>

#include "radio/source/serial_ports.h"
#include "ui/connect_request.h"
#include "ui/panels/card.h"

namespace hedr {

// Where to find the robot: port, speed and vehicle. A card on the map, not a dialog. Adapters that
// are plugged in while it is open appear by themselves.
class ConnectCard : public Card {
    Q_OBJECT

  public:
    explicit ConnectCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setPorts(const std::vector<SerialPortEntry>& ports);
    // The connection of last time: its adapter is found again under another name, too.
    void propose(const ConnectRequest& earlier);
    ConnectRequest request() const;

  signals:
    void connectRequested(const hedr::ConnectRequest& request);
    void portsWanted();

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void createFields();
    void layOut();
    void chooseVehicle(int index);
    int addVehicleFile(const QString& file);  // its index
    void showVehicle(const ConnectRequest& earlier);
    void showSettings();
    bool isEarlier(const SerialPortEntry& port) const;
    void chooseProposed();
    const SerialPortEntry* chosenPort() const;  // nullptr: what was typed is none of the list
    void updateButton();

    QLabel* title_ = nullptr;
    QComboBox* port_ = nullptr;
    QComboBox* baud_ = nullptr;
    QComboBox* vehicle_ = nullptr;
    QLineEdit* call_sign_ = nullptr;
    QLabel* advice_ = nullptr;
    QPushButton* connect_ = nullptr;
    QTimer look_again_;
    std::vector<SerialPortEntry> ports_;
    ConnectRequest earlier_{};
    bool touched_ = false;  // the operator has chosen: nothing is proposed any more
};

}  // namespace hedr
