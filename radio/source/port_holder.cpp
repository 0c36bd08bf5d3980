#include "radio/source/port_holder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string_view>

namespace hedr {

namespace {

namespace fs = std::filesystem;

// Services that open every adapter to see whether it is something of theirs.
struct Service {
    std::string_view program;
    std::string_view units;
};
constexpr Service kServices[] = {
    {"ModemManager", "ModemManager"},
    {"brltty", "brltty"},
    {"gpsd", "gpsd.socket gpsd"},
};

const Service* serviceOf(const PortHolder& holder) {
    const auto* known = std::ranges::find(kServices, holder.name, &Service::program);
    return known == std::end(kServices) ? nullptr : known;
}

// 0 for what is no process.
int pidOf(std::string_view text) {
    int pid = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), pid);
    return error == std::errc{} && end == text.data() + text.size() ? pid : 0;
}

PortHolder processOf(int pid, const fs::path& proc) {
    const fs::path folder = proc / std::to_string(pid);
    PortHolder process{.pid = pid, .name = "a program"};
    std::ifstream comm(folder / "comm");
    std::getline(comm, process.name);
    struct stat status {};
    process.ours = ::stat(folder.c_str(), &status) == 0 && status.st_uid == ::geteuid();
    return process;
}

// None: our user may not know it.
std::optional<bool> hasOpen(const fs::path& process, const fs::path& device) {
    std::error_code error;
    for (fs::directory_iterator file(process / "fd", error), end; !error && file != end;
         file.increment(error)) {
        std::error_code gone;  // closed since
        if (fs::read_symlink(file->path(), gone) == device) return true;
    }
    if (error == std::errc::permission_denied) return std::nullopt;
    return false;
}

// As terminal programs have done for ever: LCK..ttyUSB0 with the number of the process.
int lockedBy(const fs::path& device, const fs::path& locks) {
    std::ifstream lock(locks / ("LCK.." + device.filename().string()));
    std::string word;
    lock >> word;
    return pidOf(word);
}

std::string nameOf(const PortHolder& holder) {
    return holder.name + " (pid " + std::to_string(holder.pid) + ")";
}

std::string lineToStop(const PortHolder& holder) {
    if (const Service* service = serviceOf(holder))
        return std::string("; to stop it: sudo systemctl stop ").append(service->units);
    const std::string line = "kill " + std::to_string(holder.pid);
    return std::string("; to end it: ").append(holder.ours ? line : "sudo " + line);
}

}  // namespace

PortHolders findPortHolders(const fs::path& device, const SystemPlaces& places) {
    std::error_code error;
    const fs::path real = fs::canonical(device, error);
    const fs::path name = error ? device : real;
    const int locker = lockedBy(name, places.locks);
    PortHolders found;
    for (fs::directory_iterator entry(places.proc, error), end; !error && entry != end;
         entry.increment(error)) {
        const int pid = pidOf(entry->path().filename().string());
        if (pid == 0) continue;
        const auto open = hasOpen(entry->path(), name);
        const bool holds = open.value_or(false) || pid == locker;
        if (holds) found.holders.push_back(processOf(pid, places.proc));
        if (open || holds) continue;
        found.hidden = true;
        const PortHolder process = processOf(pid, places.proc);
        if (!found.service && serviceOf(process)) found.service = process;
    }
    return found;
}

std::string describe(const PortHolders& found, const fs::path& device) {
    if (!found.holders.empty()) {
        const PortHolder& holder = found.holders.front();
        if (holder.pid == ::getpid()) return "this program has it open already";
        return nameOf(holder) + " has it open" + lineToStop(holder);
    }
    if (found.service)
        return nameOf(*found.service) + " is running and may have it open" +
               lineToStop(*found.service);
    if (found.hidden)
        return "your user may not see which one; to see it: sudo fuser -v " + device.string();
    return {};
}

}  // namespace hedr
