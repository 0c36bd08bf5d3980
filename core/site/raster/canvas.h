#pragma once

#include <cairo.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/site/plan.h"

namespace hedr {

// White paper of BGRA pixels for vector drawings.
class Canvas {
  public:
    // Error: kImageTooLarge.
    static Result<Canvas> create(int width_px, int height_px, const std::string& path);

    cairo_t* cairo() const { return cairo_.get(); }
    PlanLevel colour() &&;  // what has been painted
    PlanLevel grey() &&;    // the same where nothing of it is coloured

  private:
    struct Release {
        void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
        void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
    };

    void finish();

    PlanLevel level_;
    std::shared_ptr<std::vector<std::uint8_t>> pixels_;
    std::unique_ptr<cairo_surface_t, Release> surface_;
    std::unique_ptr<cairo_t, Release> cairo_;
};

}  // namespace hedr
