#pragma once

class QTcpSocket;

namespace hedr {

// A peer that loses its power does not say goodbye: without this its connection would seem to stand
// for hours. With it, it ends after three seconds.
void watchForDeath(const QTcpSocket& socket);

}  // namespace hedr
