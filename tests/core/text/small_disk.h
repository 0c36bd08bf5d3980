#pragma once

#include <sys/mount.h>

#include <filesystem>

namespace hedr {

// A file system of a given size at a folder, where the system lets us have one.
class SmallDisk {
  public:
    SmallDisk(const std::filesystem::path& folder, const char* size) : folder_(folder) {
        std::filesystem::create_directories(folder);
        mounted_ = mount("tmpfs", folder.c_str(), "tmpfs", 0, size) == 0;
    }
    ~SmallDisk() {
        if (mounted_) umount2(folder_.c_str(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    bool mounted() const { return mounted_; }

  private:
    std::filesystem::path folder_;
    bool mounted_;
};

}  // namespace hedr
