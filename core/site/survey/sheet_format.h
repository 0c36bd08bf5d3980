#pragma once

#include <span>
#include <vector>

#include "core/site/survey/sheet_aspect.h"

namespace hedr {

// A shape that sheets usually have.
struct SheetFormat {
    const char* name;  // "A4, A3 ..."
    double longer_by_shorter;
};

std::span<const SheetFormat> sheetFormats();

struct LikelySheetFormat {
    SheetFormat format{};
    double aspect = 1.0;       // width / height, the longer side as the sheet lies
    double probability = 0.0;  // that it is this one; the rest: another, or none
};

// The usual formats that a sheet of that shape may have, the likeliest first, none that is less
// likely than 5 %. By Bayes: before the photo, half of all quads are sheets of a usual format, each
// as often, and the others have any shape up to 1 : 2.5.
std::vector<LikelySheetFormat> likelyFormats(const SheetAspect& seen);

}  // namespace hedr
