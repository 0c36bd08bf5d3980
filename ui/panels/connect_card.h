#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <vector>

#include "radio/source/serial_ports.h"
#include "ui/connect_request.h"
#include "ui/panels/card.h"

namespace hedr {

// Where to find the robot: port, speed and vehicle. A card on the map, not a dialog.
class ConnectCard : public Card {
    Q_OBJECT

  public:
    explicit ConnectCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setPorts(const std::vector<SerialPortEntry>& ports);
    ConnectRequest request() const;

  signals:
    void connectRequested(const hedr::ConnectRequest& request);
    void portsWanted();

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void createFields();
    void layOut();
    void chooseVehicle(int index);
    void updateButton();

    QLabel* title_ = nullptr;
    QComboBox* port_ = nullptr;
    QPushButton* refresh_ = nullptr;
    QComboBox* baud_ = nullptr;
    QComboBox* vehicle_ = nullptr;
    QLabel* advice_ = nullptr;
    QPushButton* connect_ = nullptr;
};

}  // namespace hedr
