#include "radio/wire/signing/key_text.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>

#include "core/text/trimmed.h"
#include "radio/wire/messages.h"

namespace hedr {
namespace {

std::string quoted(std::string_view name) {
    std::string text = "\"";
    return text.append(name).append("\"");
}

constexpr std::string_view kDigits = "0123456789abcdef";

struct Entry {
    std::string_view name;
    std::optional<std::string_view> value{};
};

// Fills in the value of each of `wanted` from lines `name = value`.
Result<void> readEntries(std::string_view text, const std::string& path, std::span<Entry> wanted) {
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line.front() == '#') continue;
        const std::string where = path + ":" + std::to_string(number);
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos) {
            return fail(ErrorCode::kBadFormat, where, "a line must be NAME = VALUE");
        }
        const std::string_view name = trimmed(line.substr(0, equals));
        const auto entry = std::ranges::find(wanted, name, &Entry::name);
        if (entry == wanted.end()) {
            return fail(ErrorCode::kBadFormat, where, "there is a name that is not known");
        }
        if (entry->value) {
            return fail(ErrorCode::kBadFormat, where, quoted(name).append(" is there twice"));
        }
        entry->value = trimmed(line.substr(equals + 1));
    }
    for (const Entry& entry : wanted) {
        if (!entry.value) {
            return fail(ErrorCode::kBadFormat, path, quoted(entry.name).append(" is missing"));
        }
    }
    return {};
}

Result<std::string_view> unquoted(const Entry& entry, const std::string& path) {
    const std::string_view text = *entry.value;
    if (text.size() < 2 || text.front() != '"' || text.back() != '"') {
        return fail(ErrorCode::kBadFormat, path,
                    quoted(entry.name).append(" must stand in quotes"));
    }
    return text.substr(1, text.size() - 2);
}

Result<SigningKey> keyOfHex(std::string_view hex, const std::string& path) {
    SigningKey key{};
    bool good = hex.size() == 2 * key.size();
    for (std::size_t i = 0; good && i < key.size(); ++i) {
        const char* const digits = hex.data() + 2 * i;
        const auto parsed = std::from_chars(digits, digits + 2, key[i], 16);
        good = parsed.ec == std::errc{} && parsed.ptr == digits + 2;
    }
    if (good) return key;
    return fail(ErrorCode::kBadFormat, path, "\"key\" must be 32 hexadecimal digits");
}

Result<std::uint32_t> counterIn(const Entry& entry, const std::string& path) {
    std::uint32_t counter = 0;
    const char* const end = entry.value->data() + entry.value->size();
    const auto parsed = std::from_chars(entry.value->data(), end, counter);
    if (parsed.ec == std::errc{} && parsed.ptr == end) return counter;
    return fail(ErrorCode::kBadFormat, path,
                quoted(entry.name).append(" must be a whole number below 2^32"));
}

}  // namespace

Result<void> checkRobotName(std::string_view name) {
    const auto refuse = [&](const std::string& why) {
        return fail(ErrorCode::kBadValue, "the robot's name", why);
    };
    if (name.empty()) return refuse("is empty");
    if (name.size() > kMaxNameBytes) return refuse("is longer than the 63 bytes of a hello");
    if (name.front() == '.' || name.front() == '-') return refuse("must not begin with . or -");
    if (trimmed(name) != name) return refuse("must not begin or end with a blank");
    const bool plain = std::ranges::none_of(name, [](char letter) {
        const auto code = static_cast<unsigned char>(letter);
        return code < 0x20 || code == 0x7F || letter == '/' || letter == '"' || letter == '\\';
    });
    return plain ? Result<void>{} : refuse("must not hold / \\ \" or control characters");
}

std::string hexOf(const SigningKey& key) {
    std::string hex;
    for (const unsigned byte : key) {
        hex += kDigits[byte >> 4];
        hex += kDigits[byte & 15U];
    }
    return hex;
}

std::string keyText(const RobotKey& key) {
    return "# The secret that this robot and its laptop share: who reads it can command the robot\n"
           "# and speak in its name. Keep it to yourself (chmod 600).\n"
           "name = \"" +
           key.name + "\"\nkey = \"" + hexOf(key.key) + "\"\n";
}

Result<RobotKey> parseKey(std::string_view text, const std::string& path) {
    Entry entries[] = {{"name"}, {"key"}};
    if (auto read = readEntries(text, path, entries); !read) {
        return tl::make_unexpected(read.error());
    }
    const auto name = unquoted(entries[0], path);
    if (!name) return tl::make_unexpected(name.error());
    if (const auto good = checkRobotName(*name); !good) {
        return fail(ErrorCode::kBadFormat, path, good.error().subject + " " + good.error().detail);
    }
    return unquoted(entries[1], path)
        .and_then([&](std::string_view hex) { return keyOfHex(hex, path); })
        .map([&](const SigningKey& key) {
            return RobotKey{std::string(*name), key};
        });
}

std::string countersText(const KeyCounters& counters) {
    return "# How far the counters of the key beside this file went. Without it frames that were\n"
           "# recorded by somebody could be played again.\n"
           "said = " +
           std::to_string(counters.said) + "\nheard = " + std::to_string(counters.heard) + "\n";
}

Result<KeyCounters> parseCounters(std::string_view text, const std::string& path) {
    Entry entries[] = {{"said"}, {"heard"}};
    if (auto read = readEntries(text, path, entries); !read) {
        return tl::make_unexpected(read.error());
    }
    const auto said = counterIn(entries[0], path);
    if (!said) return tl::make_unexpected(said.error());
    return counterIn(entries[1], path).map([&](std::uint32_t heard) {
        return KeyCounters{*said, heard};
    });
}

std::string cHeaderOf(const RobotKey& key) {
    const std::string hex = hexOf(key.key);
    std::string bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2) {
        bytes += (i == 0 ? "" : ", ") + ("0x" + hex.substr(i, 2));
    }
    return "/* The secret of the robot \"" + key.name +
           "\": never publish this file.\n"
           " *     static const uint8_t key[] = HEDR_KEY; */\n"
           "#define HEDR_KEY {" +
           bytes + "}\n";
}

}  // namespace hedr
