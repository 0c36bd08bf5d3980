#include "radio/robot_line.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>
#include <thread>

namespace hedr {

namespace {

tl::unexpected<Error> failErrno(ErrorCode code, const std::string& subject) {
    return fail(code, subject, std::strerror(errno));
}

speed_t speedOf(int baud) {
    switch (baud) {
        case 9600:
            return B9600;
        case 19200:
            return B19200;
        case 38400:
            return B38400;
        case 57600:
            return B57600;
        case 115200:
            return B115200;
        case 230400:
            return B230400;
        default:
            return B0;
    }
}

ErrorCode portErrorCode() {
    if (errno == ENOENT) return ErrorCode::kPortMissing;
    if (errno == EACCES || errno == EPERM) return ErrorCode::kPortPermission;
    if (errno == EBUSY) return ErrorCode::kPortBusy;
    return ErrorCode::kPortFailed;
}

bool makeRaw(int fd, speed_t speed) {
    termios settings{};
    if (::tcgetattr(fd, &settings) != 0) return false;
    ::cfmakeraw(&settings);
    if (speed != B0) ::cfsetspeed(&settings, speed);
    return ::tcsetattr(fd, TCSANOW, &settings) == 0;
}

// Only a link to a pseudo-terminal, left behind by a program that was killed, is replaced.
bool isLeftBehind(const std::filesystem::path& link) {
    std::error_code error;
    return std::filesystem::read_symlink(link, error).string().starts_with("/dev/pts/");
}

Result<void> placeLink(const std::filesystem::path& link, const std::string& terminal) {
    std::error_code error;
    if (isLeftBehind(link)) std::filesystem::remove(link, error);
    std::filesystem::create_symlink(terminal, link, error);
    if (error) return fail(ErrorCode::kFileUnwritable, link.string(), error.message());
    return {};
}

}  // namespace

Result<RobotLine> RobotLine::openPseudoTerminal(const std::filesystem::path& link) {
    int master = -1;
    int slave = -1;
    if (::openpty(&master, &slave, nullptr, nullptr, nullptr) != 0) {
        return failErrno(ErrorCode::kPortFailed, link.string());
    }
    RobotLine line{FileDescriptor(master)};
    // Opened once and closed again: from now on the master reports a hang-up while nobody listens.
    const FileDescriptor first_listener{slave};
    if (!makeRaw(slave, B0)) return failErrno(ErrorCode::kPortFailed, link.string());
    line.terminal_ = ::ttyname(slave);
    ::fcntl(master, F_SETFL, O_NONBLOCK);
    ::fcntl(master, F_SETFD, FD_CLOEXEC);
    const auto placed = placeLink(link, line.terminal_);
    if (!placed) return tl::make_unexpected(placed.error());
    line.link_ = link;
    return line;
}

Result<RobotLine> RobotLine::openPort(const std::string& device, int baud) {
    RobotLine line{
        FileDescriptor(::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC))};
    if (!line.fd_) return failErrno(portErrorCode(), device);
    const speed_t speed = speedOf(baud);
    if (speed == B0)
        return fail(ErrorCode::kBadValue, device, "has no speed of " + std::to_string(baud));
    if (!makeRaw(line.fd_.get(), speed)) return failErrno(ErrorCode::kPortFailed, device);
    return line;
}

RobotLine::~RobotLine() {
    if (!fd_ || link_.empty()) return;
    std::error_code error;
    if (std::filesystem::read_symlink(link_, error) == terminal_) {
        std::filesystem::remove(link_, error);
    }
}

bool RobotLine::someoneListens() const {
    if (terminal_.empty()) return true;
    pollfd state{fd_.get(), 0, 0};
    ::poll(&state, 1, 0);
    return (state.revents & POLLHUP) == 0;
}

void RobotLine::send(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty() && someoneListens()) {
        const ssize_t written = ::write(fd_.get(), bytes.data(), bytes.size());
        if (written > 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(written));
            continue;
        }
        if (errno != EAGAIN && errno != EINTR) return;
        pollfd room{fd_.get(), POLLOUT, 0};
        if (::poll(&room, 1, kPatience_ms) == 0) return;
    }
}

std::vector<std::uint8_t> RobotLine::receive() {
    std::vector<std::uint8_t> bytes(256);
    const ssize_t read = ::read(fd_.get(), bytes.data(), bytes.size());
    bytes.resize(read > 0 ? static_cast<std::size_t>(read) : 0);
    return bytes;
}

std::size_t RobotLine::unread() const {
    const FileDescriptor slave{::open(terminal_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
    int count = 0;
    if (!slave || ::ioctl(slave.get(), FIONREAD, &count) != 0) return 0;
    return static_cast<std::size_t>(count);
}

void RobotLine::drain() const {
    if (terminal_.empty()) {
        ::tcdrain(fd_.get());
        return;
    }
    // The kernel hands the bytes on in pieces: only a line that stays empty has been read.
    constexpr int kNap_ms = 10;
    constexpr int kQuiet_ms = 150;
    int quiet_ms = 0;
    for (int waited_ms = 0; someoneListens() && quiet_ms < kQuiet_ms && waited_ms < kPatience_ms;
         waited_ms += kNap_ms) {
        std::this_thread::sleep_for(std::chrono::milliseconds(kNap_ms));
        quiet_ms = unread() > 0 ? 0 : quiet_ms + kNap_ms;
    }
}

}  // namespace hedr
