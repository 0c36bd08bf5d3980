#pragma once

#include <vector>

#include "core/site/survey/edge_lines.h"
#include "core/site/survey/photo_tones.h"

namespace hedr {

// Along the whole of a line: where the photo shows an edge there.
class EdgeSupport {
  public:
    EdgeSupport(const PhotoTones& tones, const EdgeLine& line);

    const EdgeLine& line() const { return line_; }
    // Of the part of the line between two points on it that lies in the photo: how much shows an
    // edge (0..1), and how much one with a broad step of brightness; 0 where nothing is visible.
    double edge(Point<Small> from, Point<Small> to) const { return share(edges_, from, to); }
    double step(Point<Small> from, Point<Small> to) const { return share(steps_, from, to); }
    double visible_px(Point<Small> from, Point<Small> to) const {
        return count(visible_, from, to);
    }

  private:
    double along(Point<Small> p) const;
    double count(const std::vector<int>& sums, Point<Small> from, Point<Small> to) const;
    double share(const std::vector<int>& sums, Point<Small> from, Point<Small> to) const;

    EdgeLine line_;
    double start_ = 0.0;        // along the line, of the first sample; one per pixel
    std::vector<int> visible_;  // samples in the photo before each one
    std::vector<int> edges_;
    std::vector<int> steps_;
};

}  // namespace hedr
