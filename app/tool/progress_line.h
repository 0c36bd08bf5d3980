#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace hedr::tool {

// A line on the terminal that says how far a work has come, once it takes longer than a second.
// There is none where nobody watches. It goes away with the object.
class ProgressLine {
  public:
    // "trial", "fusing": what stands before the figures.
    explicit ProgressLine(std::string work);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    // Cheap enough to be told of every sample.
    void show(std::size_t done, std::size_t total);

  private:
    using Clock = std::chrono::steady_clock;

    std::string work_;
    bool watched_;
    bool shown_ = false;
    std::size_t calls_ = 0;
    Clock::time_point next_;
};

}  // namespace hedr::tool
