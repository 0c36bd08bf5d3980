#pragma once

#include <csignal>

namespace hedr {

// SIGINT, SIGTERM and SIGHUP (its terminal is closed) shall end a program in good order, its
// mission closed: they are held back and asked for now and then, which needs no handler and so
// nothing that a handler could disturb.

// To be called first in main(), so that every thread holds them back.
inline void holdStopSignals() {
    sigset_t stops;
    sigemptyset(&stops);
    sigaddset(&stops, SIGINT);
    sigaddset(&stops, SIGTERM);
    sigaddset(&stops, SIGHUP);
    pthread_sigmask(SIG_BLOCK, &stops, nullptr);
}

inline bool stopSignalled() {
    sigset_t pending;
    sigpending(&pending);
    return sigismember(&pending, SIGINT) == 1 || sigismember(&pending, SIGTERM) == 1 ||
           sigismember(&pending, SIGHUP) == 1;
}

}  // namespace hedr
