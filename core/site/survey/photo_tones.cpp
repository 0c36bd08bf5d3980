#include "core/site/survey/photo_tones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace hedr {
namespace {

constexpr double kDarkest = 12.0;  // grey values below say nothing: noise
constexpr double kSmoothing_px = 1.3;
constexpr double kBroad_px = 2.0;

cv::Mat darkestChannel(const cv::Mat& image) {
    if (image.channels() == 1) return image;
    std::array<cv::Mat, 3> channels;
    for (int i = 0; i < 3; ++i) cv::extractChannel(image, channels[static_cast<std::size_t>(i)], i);
    return cv::min(cv::min(channels[0], channels[1]), channels[2]);
}

std::vector<float> valuesOf(const cv::Mat& matrix) {
    return {matrix.ptr<float>(), matrix.ptr<float>() + matrix.total()};
}

}  // namespace

PhotoTones photoTones(const PlanLevel& photo, int most_px) {
    const cv::Mat whole(photo.height_px, photo.width_px, CV_8UC(photo.channels),
                        const_cast<std::uint8_t*>(photo.pixels->data()));  // only read
    const double scale =
        std::max(1.0, static_cast<double>(std::max(whole.cols, whole.rows)) / most_px);
    const cv::Size size(std::max(1, cvRound(whole.cols / scale)),
                        std::max(1, cvRound(whole.rows / scale)));
    cv::Mat small;
    cv::resize(whole, small, size, 0.0, 0.0, cv::INTER_AREA);

    cv::Mat tone;
    darkestChannel(small).convertTo(tone, CV_32F, 1.0, kDarkest);
    cv::log(tone, tone);
    cv::GaussianBlur(tone, tone, {}, kSmoothing_px);
    cv::Mat slope_x;
    cv::Mat slope_y;
    cv::Scharr(tone, slope_x, CV_32F, 1, 0, 1.0 / 32.0);
    cv::Scharr(tone, slope_y, CV_32F, 0, 1, 1.0 / 32.0);
    cv::Mat broad;
    cv::GaussianBlur(tone, broad, {}, kBroad_px);
    return {size.width,      size.height,       static_cast<double>(whole.cols) / size.width,
            valuesOf(broad), valuesOf(slope_x), valuesOf(slope_y)};
}

}  // namespace hedr
