#pragma once

#include <filesystem>

namespace hedr {

// A file below `folder` by its way from there, so that both can be moved together; another one by
// its whole path. Without a folder it stays as it is. By the names alone: no disk is asked.
inline std::filesystem::path portablePath(const std::filesystem::path& file,
                                          const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    if (folder.empty()) return file;
    const fs::path whole = fs::absolute(file).lexically_normal();
    const fs::path way = whole.lexically_relative(fs::absolute(folder).lexically_normal());
    return way.empty() || *way.begin() == ".." ? whole : way;
}

}  // namespace hedr
