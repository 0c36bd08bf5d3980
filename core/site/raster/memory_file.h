#pragma once

#include <cpl_vsi.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace hedr {

// A file of GDAL's in memory, with a name that no other one has meanwhile.
class MemoryFile {
  public:
    MemoryFile()
        : name_("/vsimem/" + std::to_string(reinterpret_cast<std::uintptr_t>(this)) + ".memory") {}
    ~MemoryFile() { VSIUnlink(name_.c_str()); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    const std::string& name() const { return name_; }
    std::string_view bytes() const {
        vsi_l_offset size = 0;
        const auto* first = VSIGetMemFileBuffer(name_.c_str(), &size, FALSE);
        return {reinterpret_cast<const char*>(first), static_cast<std::size_t>(size)};
    }

  private:
    std::string name_;
};

}  // namespace hedr
