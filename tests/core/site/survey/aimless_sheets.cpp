#include "tests/core/site/survey/aimless_sheets.h"

#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "core/geometry/angle.h"
#include "core/simulation/random.h"
#include "core/site/mip_pyramid.h"

namespace hedr {
namespace {

constexpr int kSide = 1200;
const cv::Scalar kInk(30);

cv::Point at(double x, double y) { return {cvRound(16.0 * x), cvRound(16.0 * y)}; }

void curve(cv::Mat& paper, const std::vector<cv::Point>& points, int pen) {
    cv::polylines(paper, std::vector{points}, false, kInk, pen, cv::LINE_AA, 4);
}

void arc(cv::Mat& paper, double radius, double from, double to, int pen) {
    std::vector<cv::Point> points;
    for (double angle = from; angle <= to; angle += 0.02) {
        points.push_back(at(600 + radius * std::cos(angle), 600 + radius * std::sin(angle)));
    }
    curve(paper, points, pen);
}

void rings(cv::Mat& paper, Random& random) {
    for (int i = 0; i < 6; ++i) arc(paper, random.uniform(60.0, 560.0), 0.0, 2.0 * kPi + 0.1, 6);
}

void spiral(cv::Mat& paper, Random& random) {
    const double step = random.uniform(8.0, 16.0);
    std::vector<cv::Point> points;
    for (double angle = 0.0; angle * step < 560.0; angle += 0.02) {
        points.push_back(
            at(600 + angle * step * std::cos(angle), 600 + angle * step * std::sin(angle)));
    }
    curve(paper, points, 5);
}

void curves(cv::Mat& paper, Random& random) {
    for (int i = 0; i < 12; ++i) {
        double x = random.uniform(100.0, 1100.0);
        double y = random.uniform(100.0, 1100.0);
        double heading = random.uniform(0.0, 2.0 * kPi);
        double bend = 0.0;
        std::vector<cv::Point> points;
        for (int step = 0; step < 200; ++step) {
            bend = 0.95 * bend + 0.01 * random.normal();
            heading += bend;
            x += 4.0 * std::cos(heading);
            y += 4.0 * std::sin(heading);
            points.push_back(at(x, y));
        }
        curve(paper, points, 5);
    }
}

// Rings with rooms between them.
void roundBuilding(cv::Mat& paper, Random& random) {
    for (const double radius : {160.0, 300.0, 360.0, 560.0}) arc(paper, radius, 0.0, 6.4, 6);
    const double first = random.uniform(0.0, 1.0);
    for (int i = 0; i < 17; ++i) {
        const double angle = first + 2.0 * kPi * i / 17;
        for (const auto& [from, to] : {std::array{160.0, 300.0}, std::array{360.0, 560.0}}) {
            curve(paper,
                  {at(600 + from * std::cos(angle), 600 + from * std::sin(angle)),
                   at(600 + to * std::cos(angle), 600 + to * std::sin(angle))},
                  5);
        }
    }
}

void text(cv::Mat& paper, Random& random) {
    for (int line = 0; line < 38; ++line) {
        std::string words;
        while (words.size() < 58) {
            const int length = static_cast<int>(random.uniform(2.0, 10.0));
            for (int i = 0; i < length; ++i)
                words += static_cast<char>('a' + static_cast<int>(random.uniform(0.0, 26.0)));
            words += ' ';
        }
        cv::putText(paper, words, {80, 90 + 28 * line}, cv::FONT_HERSHEY_COMPLEX, 0.65, kInk, 1,
                    cv::LINE_AA);
    }
}

// Fields of different greys, each to the nearest of some points.
void fields(cv::Mat& paper, Random& random) {
    std::vector<std::array<double, 3>> farms;
    for (int i = 0; i < 40; ++i) {
        farms.push_back(
            {random.uniform(0.0, kSide), random.uniform(0.0, kSide), random.uniform(70.0, 190.0)});
    }
    for (int row = 0; row < kSide; ++row) {
        for (int column = 0; column < kSide; ++column) {
            double nearest = 1e12;
            double grey = 0.0;
            for (const auto& [x, y, shade] : farms) {
                const double squared = (x - column) * (x - column) + (y - row) * (y - row);
                if (squared >= nearest) continue;
                nearest = squared;
                grey = shade;
            }
            paper.at<std::uint8_t>(row, column) =
                cv::saturate_cast<std::uint8_t>(grey + random.uniform(-12.0, 12.0));
        }
    }
}

// Straight walls in every direction.
void star(cv::Mat& paper, Random& random) {
    for (int i = 0; i < 40; ++i) {
        const double x = random.uniform(200.0, 1000.0);
        const double y = random.uniform(200.0, 1000.0);
        const double angle = random.uniform(0.0, kPi);
        const double half = random.uniform(30.0, 180.0);
        curve(paper,
              {at(x - half * std::cos(angle), y - half * std::sin(angle)),
               at(x + half * std::cos(angle), y + half * std::sin(angle))},
              5);
    }
}

void noise(cv::Mat& paper, Random& random) {
    for (int row = 0; row < kSide; ++row) {
        for (int column = 0; column < kSide; ++column) {
            paper.at<std::uint8_t>(row, column) =
                static_cast<std::uint8_t>(random.uniform(0.0, 256.0));
        }
    }
}

PlanLevel levelOf(const cv::Mat& paper) {
    return {paper.cols, paper.rows, 1,
            std::make_shared<std::vector<std::uint8_t>>(paper.datastart, paper.dataend)};
}

}  // namespace

PlanImage aimlessSheet(Aimless kind, std::uint64_t seed) {
    Random random(seed);
    cv::Mat paper(kSide, kSide, CV_8U, cv::Scalar(245));
    switch (kind) {
        case Aimless::kRings:
            rings(paper, random);
            break;
        case Aimless::kSpiral:
            spiral(paper, random);
            break;
        case Aimless::kCurves:
            curves(paper, random);
            break;
        case Aimless::kRoundBuilding:
            roundBuilding(paper, random);
            break;
        case Aimless::kText:
            text(paper, random);
            break;
        case Aimless::kFields:
            fields(paper, random);
            break;
        case Aimless::kStarOfWalls:
            star(paper, random);
            break;
        case Aimless::kNoise:
            noise(paper, random);
            break;
    }
    return {{}, mipPyramid(levelOf(paper)), {}};
}

MixedSheet mixedSheet(std::uint64_t seed) {
    Random random(seed);
    cv::Mat paper(kSide, kSide, CV_8U, cv::Scalar(240));
    const double direction = random.uniform(0.0, kPi / 2);
    const bool aimless = random.uniform() < 0.25;
    const int aligned = aimless ? 0 : static_cast<int>(random.uniform(1.0, 25.0));
    const int others = static_cast<int>(random.uniform() * random.uniform(0.0, 80.0));
    const double jitter = random.uniform() < 0.5 ? 0.0 : radFromDeg(random.uniform(0.0, 2.0));
    const double scale = random.uniform(0.15, 1.0);
    for (int i = 0; i < aligned + others; ++i) {
        const double square = random.uniform() < 0.5 ? 0.0 : kPi / 2;
        const double along = direction + square + jitter * random.normal();
        const double angle = i < aligned ? along : random.uniform(0.0, kPi);
        const double half = scale * random.uniform(30.0, 300.0);
        const double x = random.uniform(100.0, 1100.0);
        const double y = random.uniform(100.0, 1100.0);
        curve(paper,
              {at(x - half * std::cos(angle), y + half * std::sin(angle)),
               at(x + half * std::cos(angle), y - half * std::sin(angle))},
              static_cast<int>(random.uniform(1.0, 6.0)));
    }
    const double sigma = random.uniform(0.0, 30.0);
    for (int row = 0; row < kSide; ++row) {
        for (int column = 0; column < kSide; ++column) {
            auto& grey = paper.at<std::uint8_t>(row, column);
            grey = cv::saturate_cast<std::uint8_t>(grey + sigma * random.normal());
        }
    }
    return {{{}, mipPyramid(levelOf(paper)), {}}, direction, aimless};
}

}  // namespace hedr
