#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace hedr::test {

// A pair of tests/golden/mavlink.
struct GoldenMavlink {
    std::string name;
    nlohmann::json words;
    std::vector<std::uint8_t> bytes;
};

inline std::vector<GoldenMavlink> goldenMavlink() {
    namespace fs = std::filesystem;
    std::vector<GoldenMavlink> all;
    for (const auto& entry : fs::directory_iterator(HEDR_SOURCE_DIR "/tests/golden/mavlink")) {
        if (entry.path().extension() != ".json") continue;
        std::ifstream json(entry.path());
        std::ifstream bin(fs::path(entry.path()).replace_extension(".bin"), std::ios::binary);
        all.push_back({entry.path().stem(),
                       nlohmann::json::parse(json),
                       {std::istreambuf_iterator<char>(bin), {}}});
    }
    std::ranges::sort(all, {}, &GoldenMavlink::name);
    return all;
}

}  // namespace hedr::test
