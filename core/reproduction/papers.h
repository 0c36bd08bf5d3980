#pragma once

#include <span>
#include <string_view>

#include "core/reproduction/reproduction.h"

namespace hedr {

Reproduction reproduceGyrodometry(const ReproductionOptions& options);
Reproduction reproduceHedr(const ReproductionOptions& options);
Reproduction reproduceGyroErrorModel(const ReproductionOptions& options);
Reproduction reproduceGhFusion(const ReproductionOptions& options);
Reproduction reproduceUmbmark(const ReproductionOptions& options);

struct Paper {
    std::string_view name;
    std::string_view title;
    Reproduction (*reproduce)(const ReproductionOptions& options);
};

// The one table of papers.
std::span<const Paper> paperTable();

// nullptr where there is none of that name.
const Paper* findPaper(std::string_view name);

}  // namespace hedr
