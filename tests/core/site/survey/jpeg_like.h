#pragma once

#include "core/site/plan.h"

namespace hedr::test {

// A grey image as JPEG of that quality (1..100) gives it back: blocks of 8 x 8 pixels, their
// cosine transform rounded to multiples of the standard's table K.1.
PlanLevel jpegLike(const PlanLevel& image, int quality);

}  // namespace hedr::test
