#include <csignal>

#include "app/tool/command.h"

namespace hedr::tool {

namespace {

// The only thing that a signal handler may touch.
volatile std::sig_atomic_t stop_requested = 0;

}  // namespace

void stopOnSignals() {
    const auto request = [](int) { stop_requested = 1; };
    std::signal(SIGINT, request);
    std::signal(SIGTERM, request);
}

bool stopRequested() { return stop_requested != 0; }

}  // namespace hedr::tool
