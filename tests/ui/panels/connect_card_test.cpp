#include "ui/panels/connect_card.h"

#include <gtest/gtest.h>

#include <QComboBox>

namespace hedr {
namespace {

const SerialPortEntry kFirst{"/dev/ttyUSB0", "Radio 1", "first"};
const SerialPortEntry kSecond{"/dev/ttyUSB1", "Radio 2", "second"};
const ConnectRequest kEarlier{.port = "/dev/ttyUSB0",
                              .baud = 9600,
                              .identity = "first",
                              .vehicle_preset = "romi",
                              .call_sign = "Alpha"};
const ConnectRequest kOther{.port = "/dev/ttyUSB1", .identity = "second"};

void choose(const ConnectCard& card, int index) {
    auto* ports = card.findChild<QComboBox*>("port");
    ports->setCurrentIndex(index);
    emit ports->activated(index);
}

TEST(ConnectCard, KeepsTheSettingsOfOneRobotFromAnother) {
    ConnectCard card;
    card.setPorts({kFirst, kSecond});
    card.propose(kEarlier);
    EXPECT_EQ(card.request(), kEarlier);
    choose(card, 1);
    EXPECT_EQ(card.request(), kOther);
    choose(card, 0);
    EXPECT_EQ(card.request(), kEarlier);
}

TEST(ConnectCard, ProposesAnotherAdapterWithoutThem) {
    ConnectCard card;
    card.propose(kEarlier);
    card.setPorts({kSecond});
    EXPECT_EQ(card.request(), kOther);
    card.setPorts({kFirst, kSecond});
    EXPECT_EQ(card.request(), kEarlier) << "it is plugged in again";
}

TEST(ConnectCard, ProposesAnAddressWithThem) {
    ConnectCard card;
    ConnectRequest earlier = kEarlier;
    earlier.port = "tcp://robot:5760";
    earlier.identity.clear();
    card.setPorts({kSecond});
    card.propose(earlier);
    EXPECT_EQ(card.request(), earlier);
}

}  // namespace
}  // namespace hedr
