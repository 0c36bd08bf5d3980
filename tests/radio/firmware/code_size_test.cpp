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
int encoderBytes(const std::string& compiler) {
    const std::string object =
        (std::filesystem::temp_directory_path() / ("hedr_encoders_" + std::to_string(getpid())))
            .string();
    const std::string source = HEDR_SOURCE_DIR "/tests/radio/firmware/encoders.c";
    const bool compiled = runs(compiler +
                               " -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror -Os"
                               " -fno-asynchronous-unwind-tables -I" HEDR_SOURCE_DIR " -c " +
                               source + " -o " + object) == 0;
    const std::string sizes = compiled ? outputOf("size " + object + " | tail -1") : "0";
    std::filesystem::remove(object);
    return std::atoi(sizes.c_str());
}

TEST(FirmwareHeader, IsStrictC99AndItsEncodersTakeLessThanAKilobyte) {
    if (runs("gcc --version >/dev/null 2>&1") != 0 || runs("size --version >/dev/null 2>&1") != 0) {
        GTEST_SKIP() << "needs gcc and size";
    }
    const int bytes = encoderBytes("gcc");
    EXPECT_GT(bytes, 0) << "does not compile";
    EXPECT_LT(bytes, 1024);
    RecordProperty("encoder_bytes", bytes);
}

}  // namespace
}  // namespace hedr
