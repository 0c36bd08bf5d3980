#include "app/tool/progress_line.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace hedr::tool {

namespace {

constexpr std::chrono::milliseconds kSilence{1000};
constexpr std::chrono::milliseconds kBetween{100};
constexpr std::size_t kMostCounted = 1000;  // of more a reader wants the percentage
constexpr std::size_t kCallsPerLook = 256;  // at the clock, where there are many

}  // namespace

ProgressLine::ProgressLine(std::string work)
    : work_(std::move(work)),
      watched_(isatty(STDERR_FILENO) == 1),
      next_(Clock::now() + kSilence) {}

ProgressLine::~ProgressLine() {
    if (shown_) std::fputs("\r\x1b[K", stderr);
}

void ProgressLine::show(std::size_t done, std::size_t total) {
    if (!watched_) return;
    if (total > kMostCounted && ++calls_ % kCallsPerLook != 0) return;
    const auto now = Clock::now();
    if (now < next_) return;
    next_ = now + kBetween;
    shown_ = true;
    if (total <= kMostCounted) {
        std::fprintf(stderr, "\r%s %zu of %zu", work_.c_str(), done, total);
    } else {
        std::fprintf(stderr, "\r%s %zu %%", work_.c_str(), 100 * done / total);
    }
}

}  // namespace hedr::tool
