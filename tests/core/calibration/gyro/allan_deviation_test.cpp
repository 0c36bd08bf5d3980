#include "core/calibration/gyro/allan_deviation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/simulation/random.h"

namespace hedr {
namespace {

const std::filesystem::path kRecordings = HEDR_SOURCE_DIR "/../shared/data";

// One column of a file of numbers; a first row that is no number is its header.
std::vector<double> columnOf(const std::filesystem::path& file, std::size_t column) {
    std::vector<double> values;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        for (std::size_t i = 0; i < column; ++i) line.erase(0, line.find(',') + 1);
        char* end = nullptr;
        const double value = std::strtod(line.c_str(), &end);
        if (end != line.c_str()) values.push_back(value);
    }
    return values;
}

std::vector<double> ratesOfPhase(const std::vector<double>& phase) {
    std::vector<double> rates;
    for (std::size_t i = 1; i < phase.size(); ++i) rates.push_back(phase[i] - phase[i - 1]);
    return rates;
}

std::vector<double> whiteNoise(std::size_t n, double sigma, std::uint64_t seed) {
    Random random(seed);
    std::vector<double> rates(n);
    for (double& rate : rates) rate = sigma * random.normal();
    return rates;
}

// NIST SP 1065, section 12.4: the test set by a generator, and its printed deviations.
TEST(AllanDeviation, IsThatOfTheHandbooksThousandPoints) {
    std::vector<double> rates;
    double n = 1234567890.0;
    for (int i = 0; i < 1000; ++i) {
        rates.push_back(n / 2147483647.0);
        n = std::fmod(16807.0 * n, 2147483647.0);
    }
    const std::vector<std::size_t> factors{1, 10, 100};
    const auto points = allanDeviation(rates, 1.0, factors);
    EXPECT_NEAR(points[0].deviation, 2.922319e-1, 5e-8);
    EXPECT_NEAR(points[1].deviation, 9.159953e-2, 5e-9);
    EXPECT_NEAR(points[2].deviation, 3.241343e-2, 5e-9);
}

TEST(AllanDeviation, AgreesWithPublishedReferences) {
    std::ifstream stream(kRecordings / "allan/expected.json");
    if (!stream) GTEST_SKIP() << "the reference values are not there";
    const auto expected = nlohmann::json::parse(stream);
    for (const auto& [name, set] : expected["sets"].items()) {
        const auto rates = columnOf(kRecordings / "allan" / (name + "_freq.csv"), 0);
        for (const auto& [kind, result] : set["results"].items()) {
            if (!kind.starts_with("oadev")) continue;
            std::vector<std::size_t> factors;
            for (const double tau : result["tau"])
                factors.push_back(static_cast<std::size_t>(std::lround(tau)));
            const auto points = allanDeviation(rates, 1.0, factors);
            for (std::size_t i = 0; i < points.size(); ++i) {
                const double wanted = result["dev"][i];
                EXPECT_NEAR(points[i].deviation, wanted, 1e-9 * wanted) << name << ' ' << kind;
                EXPECT_EQ(points[i].terms, result["n"][i].get<std::size_t>());
            }
        }
    }
}

TEST(AllanDeviation, AgreesWithStable32) {
    const auto folder = kRecordings / "static_reference_phase_dat";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "Stable32's results are not there";
    const auto rates = ratesOfPhase(columnOf(folder / "phase.csv", 0));
    std::vector<std::size_t> factors;
    for (const double tau : columnOf(folder / "stable32_oadev.csv", 0))
        factors.push_back(static_cast<std::size_t>(std::lround(tau)));
    const auto wanted = columnOf(folder / "stable32_oadev.csv", 1);
    const auto points = allanDeviation(rates, 1.0, factors);
    ASSERT_EQ(points.size(), wanted.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(points[i].deviation, wanted[i], 1e-4 * wanted[i]) << "tau " << factors[i];
}

TEST(AllanDeviation, OfWhiteNoiseFallsWithTheRootOfTime) {
    const auto rates = whiteNoise(100000, 2.0, 1);
    for (const AllanPoint& point : allanDeviation(rates, 0.01, octaveFactors(4096))) {
        const double wanted = 2.0 / std::sqrt(static_cast<double>(point.factor));
        EXPECT_NEAR(point.deviation, wanted, 0.15 * wanted);
        EXPECT_EQ(point.noise_exponent, 0);
    }
}

TEST(AllanDeviation, KnowsAWalkAndWhiteAngles) {
    auto walk = whiteNoise(20000, 1.0, 2);
    for (std::size_t i = 1; i < walk.size(); ++i) walk[i] += walk[i - 1];
    EXPECT_EQ(allanDeviation(walk, 1.0, std::vector<std::size_t>{16}).front().noise_exponent, -2);
    auto angle = whiteNoise(20000, 1.0, 3);
    for (std::size_t i = angle.size() - 1; i > 0; --i) angle[i] -= angle[i - 1];
    EXPECT_EQ(allanDeviation(angle, 1.0, std::vector<std::size_t>{1}).front().noise_exponent, 2);
}

TEST(AllanDeviation, IsNotDisturbedByALargeMean) {
    auto rates = whiteNoise(10000, 1e-6, 4);
    const auto without = allanDeviation(rates, 0.01, octaveFactors(rates.size()));
    for (double& rate : rates) rate += 10.0;
    const auto with = allanDeviation(rates, 0.01, octaveFactors(rates.size()));
    for (std::size_t i = 0; i < with.size(); ++i)
        EXPECT_NEAR(with[i].deviation, without[i].deviation, 1e-5 * without[i].deviation);
}

// 4,000 records of white noise: the band holds the true deviation.
TEST(AllanDeviation, BandsHoldTheTruth) {
    const std::vector<std::size_t> factors{1, 4, 16, 64};
    std::vector<int> held(factors.size());
    for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
        const auto points = allanDeviation(whiteNoise(512, 1.0, seed), 1.0, factors);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double truth = 1.0 / std::sqrt(static_cast<double>(factors[i]));
            held[i] += points[i].band.contains(truth) ? 1 : 0;
        }
    }
    for (std::size_t i = 0; i < factors.size(); ++i) {
        EXPECT_GE(held[i], 4000 * 93 / 100) << factors[i];
        EXPECT_LE(held[i], 4000 * 97 / 100) << factors[i];
    }
}

TEST(AllanDeviation, TakesOctavesThatFit) {
    EXPECT_EQ(octaveFactors(9), (std::vector<std::size_t>{1, 2, 4}));
    EXPECT_TRUE(octaveFactors(1).empty());
}

}  // namespace
}  // namespace hedr
