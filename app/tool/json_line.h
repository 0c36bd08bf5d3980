#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace hedr::tool {

// One object on a line. File names and point names need not be UTF-8; JSON must.
inline std::string jsonLine(const nlohmann::ordered_json& object) {
    constexpr int kOnOneLine = -1;
    return object.dump(kOnOneLine, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

}  // namespace hedr::tool
