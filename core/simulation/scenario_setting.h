#pragma once

#include <string_view>

namespace hedr {

// A number of a scenario of type S that `--set KEY=VALUE` changes.
template <class S>
struct ScenarioSetting {
    std::string_view name;
    std::string_view meaning;
    double& (*value)(S&) = nullptr;
    double unit = 1.0;  // SI per unit of the key
    double min = 0.0;
    double max = 0.0;
};

}  // namespace hedr
