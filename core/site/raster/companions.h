#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hedr {

// The names of what lies beside plan.png and is called plan.*, plan.png itself among them, in
// capitals too. Both are empty for what is not in a folder on the disk.
struct Companions {
    std::vector<std::string> regular;
    std::optional<std::string> special;  // a pipe or a device: who opens it may wait for ever
};
Companions companionsOf(const std::filesystem::path& image);

}  // namespace hedr
