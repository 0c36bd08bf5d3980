// Compiles the robot's encoders as a robot's program would, as strict C99, and weighs the object.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace hedr {
namespace {

int runs(const std::string& command) { return std::system(command.c_str()); }

std::string outputOf(const std::string& command) {
    std::string text;
    FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 256> line{};
    while (pipe != nullptr && std::fgets(line.data(), line.size(), pipe) != nullptr) {
        text += line.data();
    }
    if (pipe != nullptr) {
        pclose(pipe);
    }
    return text;
}

// Text and constants in bytes, 0 where it does not compile.
int bytesOf(const std::string& name) {
    const std::string compiler = "gcc";
    const std::string object =
        (std::filesystem::temp_directory_path() / ("hedr_" + name + std::to_string(getpid())))
            .string();
    const std::string source = HEDR_SOURCE_DIR "/tests/radio/firmware/" + name;
    const bool compiled = runs(compiler +
                               " -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror -Os"
                               " -fno-asynchronous-unwind-tables -I" HEDR_SOURCE_DIR " -c " +
                               source + " -o " + object) == 0;
    const std::string sizes = compiled ? outputOf("size " + object + " | tail -1") : "0";
    std::filesystem::remove(object);
    return std::atoi(sizes.c_str());
}

bool canWeigh() {
    return runs("gcc --version >/dev/null 2>&1") == 0 &&
           runs("size --version >/dev/null 2>&1") == 0;
}

TEST(FirmwareHeader, IsStrictC99AndItsEncodersTakeLessThanAKilobyte) {
    if (!canWeigh()) {
        GTEST_SKIP() << "needs gcc and size";
    }
    const int bytes = bytesOf("encoders.c");
    EXPECT_GT(bytes, 0) << "does not compile";
    EXPECT_LT(bytes, 1024);
    RecordProperty("encoder_bytes", bytes);
}

TEST(FirmwareHeader, SignsAndVerifiesInLessThanAKilobyteAndAHalf) {
    if (!canWeigh()) {
        GTEST_SKIP() << "needs gcc and size";
    }
    const int bytes = bytesOf("signing.c");
    EXPECT_GT(bytes, 0) << "does not compile";
    EXPECT_LT(bytes, 1536);
    RecordProperty("signing_bytes", bytes);
}

}  // namespace
}  // namespace hedr
