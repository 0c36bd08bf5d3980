#include "core/calibration/squares/umbmark_pairing.h"

#include <algorithm>
#include <cmath>

#include "core/calibration/squares/umbmark_text.h"

namespace hedr {

namespace {

constexpr double kFarthestOfASide = 2.0;  // an end beyond is not given in metres
constexpr double kOpenOfASide = 0.5;      // a square that ends beyond was not closed

bool isFinite(const UmbmarkEnd& end) {
    return std::isfinite(end.way.x) && std::isfinite(end.way.y);
}

// Why an end does not go with its run, as the end of "Run 3 …"; empty: it does.
std::string complaintAbout(const MeasuredSquare& square, const VehicleGeometry& believed) {
    const SquareRun& run = *square.run;
    const UmbmarkEnd& end = square.end;
    if (!isFinite(end)) return "has an end that is no number";
    if (end.said && *end.said != run.turning) {
        return "turned " + std::string(nameOf(run.turning)) + " by its encoders, but " +
               std::string(nameOf(*end.said)) +
               " was said. See that each end is with its run, and that left and right encoder "
               "are not swapped";
    }
    if (end.way.length() > kFarthestOfASide * run.side_m) {
        return "ended " + readLength(end.way.length()) +
               " from its start by the list of ends, more than two sides. Ends are in metres";
    }
    const EndEquation equation = endEquation(square, believed, UmbmarkRatios::Ones());
    const double computed_m = (end.way - equation.way()).length();
    if (std::min(end.way.length(), computed_m) > kOpenOfASide * run.side_m) {
        return "did not come back to its start, neither by its encoders nor by its end";
    }
    return {};
}

std::string leftOut(std::size_t run, const std::string& reason) {
    return sentenceOf(LeftOutRun{run, reason}) + " It was left out.";
}

void noteEndsWithoutRun(PairedEnds& paired, const SquareRuns& drives,
                        std::span<const UmbmarkEnd> ends) {
    const std::size_t runs = drives.runs.size() + drives.left_out.size();
    std::vector<std::size_t> numbers;
    for (const UmbmarkEnd& end : ends) {
        if (end.run < 1 || end.run > runs) numbers.push_back(end.run);
    }
    if (numbers.empty()) return;
    paired.remarks.push_back("The list has ends for " + runsText(numbers) +
                             ", which were not driven.");
}

}  // namespace

PairedEnds pairedEnds(const SquareRuns& drives, std::span<const UmbmarkEnd> ends,
                      const VehicleGeometry& believed) {
    PairedEnds paired;
    for (const LeftOutRun& run : drives.left_out) {
        paired.remarks.push_back(leftOut(run.number, run.reason));
    }
    std::vector<std::size_t> without_end;
    for (const SquareRun& run : drives.runs) {
        const auto end = std::find_if(ends.rbegin(), ends.rend(), [&run](const UmbmarkEnd& each) {
            return each.run == run.number;
        });
        if (end == ends.rend()) {
            without_end.push_back(run.number);
            continue;
        }
        const MeasuredSquare square{&run, *end};
        const std::string complaint = complaintAbout(square, believed);
        if (complaint.empty()) {
            paired.squares.push_back(square);
        } else {
            paired.remarks.push_back(leftOut(run.number, complaint));
        }
    }
    if (!without_end.empty()) {
        paired.remarks.push_back("No end is given for " + runsText(without_end) + '.');
    }
    noteEndsWithoutRun(paired, drives, ends);
    if (drives.unfinished) {
        paired.remarks.emplace_back("The last drive has not ended: it is not counted.");
    }
    return paired;
}

}  // namespace hedr
