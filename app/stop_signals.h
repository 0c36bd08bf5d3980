#pragma once

#include <csignal>

namespace hedr {

// SIGINT and SIGTERM shall end a program in good order, its mission closed: they are held back and
// asked for now and then, which needs no handler and so nothing that a handler could disturb.

// To be called first in main(), so that every thread holds them back.
inline void holdStopSignals() {
    sigset_t stops;
    sigemptyset(&stops);
    sigaddset(&stops, SIGINT);
    sigaddset(&stops, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &stops, nullptr);
}

inline bool stopSignalled() {
    sigset_t pending;
    sigpending(&pending);
    return sigismember(&pending, SIGINT) == 1 || sigismember(&pending, SIGTERM) == 1;
}

}  // namespace hedr
