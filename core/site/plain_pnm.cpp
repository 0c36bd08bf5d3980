#include "core/site/plain_pnm.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <fstream>
#include <optional>

namespace hedr {
namespace {

constexpr std::size_t kLargestSide = 1U << 20;
constexpr std::size_t kMostPixels = 1'200'000'000;
constexpr int kMostLevels = 65535;

bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

// Takes numbers off a text in which a # hides the rest of its line.
class Numbers {
  public:
    explicit Numbers(std::string_view text) : rest_(text) {}

    std::optional<int> next() {
        skipBlanks();
        int value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc{} || value < 0) return std::nullopt;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    // The digits of P1 may stand side by side.
    std::optional<int> nextDigit() {
        skipBlanks();
        if (rest_.empty() || !isDigit(rest_.front())) return std::nullopt;
        const int digit = rest_.front() - '0';
        rest_.remove_prefix(1);
        return digit;
    }

    std::string_view rest() const { return rest_; }

  private:
    void skipBlanks() {
        while (!rest_.empty() && (isBlank(rest_.front()) || rest_.front() == '#')) {
            const bool comment = rest_.front() == '#';
            rest_.remove_prefix(comment ? std::min(rest_.find('\n'), rest_.size()) : 1);
        }
    }

    std::string_view rest_;
};

struct Header {
    char kind = '2';
    std::size_t width = 0;
    std::size_t height = 0;
    int white = 1;

    bool isBits() const { return kind == '1' || kind == '4'; }
    std::size_t samples() const { return width * height * (kind == '3' ? 3 : 1); }
    // The fewest bytes that can hold the picture: a damaged header must not cost gigabytes.
    std::size_t fewestBytes() const { return kind == '4' ? (width + 7) / 8 * height : samples(); }
};

std::optional<Header> readHeader(char kind, Numbers& numbers) {
    const auto width = numbers.next();
    const auto height = numbers.next();
    Header header{.kind = kind};
    const auto white = header.isBits() ? std::optional(1) : numbers.next();
    if (!width || !height || !white || *width == 0 || *height == 0) return std::nullopt;
    if (*white == 0 || *white > kMostLevels) return std::nullopt;
    header.width = static_cast<std::size_t>(*width);
    header.height = static_cast<std::size_t>(*height);
    header.white = *white;
    return header;
}

std::uint8_t greyOf(int value, const Header& header) {
    if (header.isBits()) return value == 0 ? 255 : 0;
    return static_cast<std::uint8_t>((std::min(value, header.white) * 255 + header.white / 2) /
                                     header.white);
}

bool readText(Numbers& numbers, const Header& header, std::vector<std::uint8_t>& pixels) {
    const auto sample = [&]() -> std::optional<std::uint8_t> {
        const auto value = header.isBits() ? numbers.nextDigit() : numbers.next();
        if (!value) return std::nullopt;
        return greyOf(*value, header);
    };
    for (std::size_t i = 0; i < header.width * header.height; ++i) {
        std::array<std::uint8_t, 3> red_green_blue{};
        for (std::size_t c = 0; c < (header.kind == '3' ? 3U : 1U); ++c) {
            const auto value = sample();
            if (!value) return false;
            red_green_blue[c] = *value;
        }
        const auto [red, green, blue] = red_green_blue;
        if (header.kind == '3') {
            pixels.insert(pixels.end(), {blue, green, red, 255});
        } else {
            pixels.push_back(red);
        }
    }
    return true;
}

void readBits(std::string_view bytes, const Header& header, std::vector<std::uint8_t>& pixels) {
    const std::size_t stride = (header.width + 7) / 8;
    for (std::size_t y = 0; y < header.height; ++y) {
        for (std::size_t x = 0; x < header.width; ++x) {
            const auto byte = static_cast<unsigned char>(bytes[y * stride + x / 8]);
            pixels.push_back(((byte >> (7 - x % 8)) & 1) != 0 ? 0 : 255);
        }
    }
}

}  // namespace

bool isPlainPnm(const std::filesystem::path& file) {
    std::array<char, 3> head{};
    std::ifstream(file, std::ios::binary).read(head.data(), head.size());
    return head[0] == 'P' && head[1] >= '1' && head[1] <= '4' &&
           (isBlank(head[2]) || head[2] == '#');
}

Result<PlanLevel> parsePlainPnm(std::string_view bytes, const std::string& path) {
    if (bytes.size() < 3) return fail(ErrorCode::kNotAnImage, path, "the Netpbm header is cut");
    Numbers numbers(bytes.substr(2));
    const auto header = readHeader(bytes[1], numbers);
    if (!header) return fail(ErrorCode::kNotAnImage, path, "the Netpbm header is damaged");
    if (header->width > kLargestSide || header->height > kLargestSide ||
        header->width * header->height > kMostPixels) {
        return fail(
            ErrorCode::kImageTooLarge, path,
            std::to_string(header->width) + " x " + std::to_string(header->height) + " pixels");
    }
    std::string_view data = numbers.rest();
    if (!data.empty()) data.remove_prefix(1);
    const auto cut = [&] {
        return fail(ErrorCode::kNotAnImage, path, "the Netpbm picture is cut");
    };
    if (data.size() < header->fewestBytes()) return cut();
    const auto pixels = std::make_shared<std::vector<std::uint8_t>>();
    const std::size_t channels = header->kind == '3' ? 4 : 1;
    pixels->reserve(header->width * header->height * channels);
    if (header->kind == '4') {
        readBits(data, *header, *pixels);
    } else if (!readText(numbers, *header, *pixels)) {
        return cut();
    }
    return PlanLevel{static_cast<int>(header->width), static_cast<int>(header->height),
                     static_cast<int>(channels), pixels};
}

}  // namespace hedr
