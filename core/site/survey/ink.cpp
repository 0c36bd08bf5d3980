#include "core/site/survey/ink.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace hedr {
namespace {

constexpr int kPaperSide_px = 256;      // the paper's brightness is found at this size
constexpr double kWidestStroke = 0.08;  // of the picture's side: what is wider is not a stroke
constexpr double kDarkestPaper = 0.5;   // of the brightest: what is darker is ink all over
constexpr double kSurelyPaper = 0.85;   // of the paper around
constexpr double kSurelyInk = 0.45;
constexpr double kMostUndecided = 0.25;         // of a drawing's pixels are neither
constexpr double kMostUndecidedInAreas = 0.05;  // where its ink is areas, not strokes
constexpr double kSpeck = 0.01;                 // of the picture's side

int sideOf(const cv::Mat& image) { return std::max(image.cols, image.rows); }

cv::Mat disc(int diameter_px) {
    return cv::getStructuringElement(cv::MORPH_ELLIPSE, {diameter_px, diameter_px});
}

int oddAbove(double size_px) { return 2 * static_cast<int>(size_px / 2.0) + 1; }

cv::Mat shrunk(const cv::Mat& image, int side_px) {
    const double scale = std::min(1.0, static_cast<double>(side_px) / sideOf(image));
    const cv::Size size(std::max(1, cvRound(image.cols * scale)),
                        std::max(1, cvRound(image.rows * scale)));
    cv::Mat small;
    cv::resize(image, small, size, 0.0, 0.0, cv::INTER_AREA);
    return small;
}

double shareOf(const cv::Mat& mask) {
    return static_cast<double>(cv::countNonZero(mask)) / static_cast<double>(mask.total());
}

// The share of the mask that is no stroke.
double wideShareOf(const cv::Mat& mask) {
    cv::Mat wide;
    cv::morphologyEx(mask, wide, cv::MORPH_OPEN, disc(oddAbove(0.04 * sideOf(mask))));
    return static_cast<double>(cv::countNonZero(wide)) / std::max(1, cv::countNonZero(mask));
}

// Ink comes in strokes, paper in areas.
bool isLightOnDark(const cv::Mat& grey) {
    cv::Mat light;
    cv::threshold(shrunk(grey, 2 * kPaperSide_px), light, 0.0, 255.0,
                  cv::THRESH_BINARY | cv::THRESH_OTSU);
    const double light_share = wideShareOf(light);
    return light_share < 0.5 && light_share < wideShareOf(~light);
}

// The brightness that each pixel would have without ink.
cv::Mat paperOf(const cv::Mat& grey) {
    cv::Mat paper = shrunk(grey, kPaperSide_px);
    cv::morphologyEx(paper, paper, cv::MORPH_CLOSE, disc(oddAbove(kWidestStroke * sideOf(paper))));
    cv::GaussianBlur(paper, paper, {}, 3.0);
    double brightest = 0.0;
    cv::minMaxLoc(paper, nullptr, &brightest);
    paper = cv::max(paper, std::max(1.0, kDarkestPaper * brightest));
    cv::resize(paper, paper, grey.size(), 0.0, 0.0, cv::INTER_LINEAR);
    return paper;
}

}  // namespace

cv::Mat greyOf(const PlanLevel& level) {
    cv::Mat grey(level.height_px, level.width_px, CV_8UC(level.channels),
                 const_cast<std::uint8_t*>(level.pixels->data()));
    if (level.channels > 1) cv::cvtColor(grey, grey, cv::COLOR_BGRA2GRAY);
    return grey;
}

cv::Mat levelled(const cv::Mat& grey) {
    const cv::Mat dark_on_light = isLightOnDark(grey) ? cv::Mat(~grey) : grey;
    cv::Mat level;
    cv::divide(dark_on_light, paperOf(dark_on_light), level, 255.0);
    const double undecided = shareOf((level > 255.0 * kSurelyInk) & (level < 255.0 * kSurelyPaper));
    const bool strokes = wideShareOf(shrunk(level, 2 * kPaperSide_px) < 128) < 0.5;
    return undecided > (strokes ? kMostUndecided : kMostUndecidedInAreas) ? cv::Mat() : level;
}

cv::Mat inkOf(const cv::Mat& levelled) {
    cv::Mat ink;
    const double between =
        cv::threshold(levelled, ink, 0.0, 255.0, cv::THRESH_BINARY_INV | cv::THRESH_OTSU);
    return levelled <= std::clamp(between, 255.0 * kSurelyInk, 255.0 * kSurelyPaper);
}

cv::Mat linesOf(const cv::Mat& levelled) {
    return withoutSmallParts(levelled <= 255.0 * kSurelyPaper, kSpeck * sideOf(levelled));
}

}  // namespace hedr
