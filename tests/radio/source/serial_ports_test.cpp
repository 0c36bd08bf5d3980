#include "radio/source/serial_ports.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

TEST(SerialPorts, AnAdapterIsKnownByItsSerialNumberWhereverItIsPluggedIn) {
    EXPECT_EQ(adapterIdentity("usb-FTDI_A50285BI-if00-port0", "pci-0-usb-0:1:1.0", "A50285BI"),
              adapterIdentity("usb-FTDI_A50285BI-if00-port0", "pci-0-usb-0:2:1.0", "A50285BI"));
}

TEST(SerialPorts, TwoAdaptersWithoutSerialNumbersAreKnownByTheirSockets) {
    const QString name = "usb-1a86_USB_Serial-if00-port0";
    EXPECT_NE(adapterIdentity(name, "pci-0-usb-0:1:1.0", ""),
              adapterIdentity(name, "pci-0-usb-0:2:1.0", ""));
    EXPECT_EQ(adapterIdentity(name, "", ""), name) << "where the socket is not known";
}

}  // namespace
}  // namespace hedr
