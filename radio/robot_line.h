#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/file_descriptor.h"
#include "core/result.h"

namespace hedr {

// The robot's end of a serial line: a real port, or the master of a pseudo-terminal whose other
// end a program opens like any serial port. Bytes sent while nobody listens are lost, as by radio.
class RobotLine {
  public:
    // `link`: a symbolic link to the pseudo-terminal, made here and removed in the end.
    // Errors: kFileUnwritable, kPortFailed.
    static Result<RobotLine> openPseudoTerminal(const std::filesystem::path& link);
    // Errors: kPortMissing, kPortPermission, kPortFailed.
    static Result<RobotLine> openPort(const std::string& device, int baud);

    RobotLine(RobotLine&&) noexcept = default;
    RobotLine& operator=(RobotLine&&) noexcept = default;
    ~RobotLine();

    bool someoneListens() const;
    // Blocks while the line is full and somebody listens, at most `kPatience_ms`.
    void send(std::span<const std::uint8_t> bytes);
    // What the laptop has sent since, without waiting.
    std::vector<std::uint8_t> receive();
    // Waits until the other end has read everything, at most `kPatience_ms`.
    void drain() const;

  private:
    static constexpr int kPatience_ms = 2000;

    explicit RobotLine(FileDescriptor fd) : fd_(std::move(fd)) {}
    std::size_t unread() const;

    FileDescriptor fd_;
    std::string terminal_;        // the pseudo-terminal's own name, empty for a real port
    std::filesystem::path link_;  // empty for a real port
};

}  // namespace hedr
