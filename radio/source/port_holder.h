#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hedr {

struct PortHolder {
    int pid = 0;
    std::string name;   // of its program, as the system tells it: at most 15 characters
    bool ours = false;  // it runs as our user
    friend bool operator==(const PortHolder&, const PortHolder&) = default;
};

// Who keeps a serial port busy, as far as our user may know.
struct PortHolders {
    std::vector<PortHolder> holders{};    // each has it open, or has locked it
    std::optional<PortHolder> service{};  // none of them: one known for taking ports, and hidden
    bool hidden = false;                  // of some programs it cannot be known
};

struct SystemPlaces {
    std::filesystem::path proc = "/proc";
    std::filesystem::path locks = "/var/lock";
};

// Looks through the open files of all programs: some ten milliseconds. `device` may be a link.
PortHolders findPortHolders(const std::filesystem::path& device, const SystemPlaces& places = {});

// "ModemManager (pid 812) has it open; to stop it: sudo systemctl stop ModemManager". Empty where
// nobody has it open any more.
std::string describe(const PortHolders& found, const std::filesystem::path& device);

}  // namespace hedr
