#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/robot/vehicle.h"

namespace hedr {

// The text of a vehicle file with the numbers of `changed`; comments and order stay. Where that
// cannot be done line by line, the text is made anew. Errors: those of parseVehicle for `toml`.
Result<std::string> withNumbersOf(const Vehicle& changed, std::string_view toml,
                                  const std::string& name_for_errors);

struct NumberChange {
    std::string key;
    std::optional<double> before{};  // none: the file does not say
    std::optional<double> after{};
    friend bool operator==(const NumberChange&, const NumberChange&) = default;
};
// The numbers in which two vehicles differ, in the order of the file.
std::vector<NumberChange> numberChanges(const Vehicle& before, const Vehicle& after);

}  // namespace hedr
