#include "radio/wire/mavlink/mavlink_codec.h"

#include <gtest/gtest.h>

#include <set>
#include <typeinfo>

#include "radio/wire/mavlink/mavlink_crc.h"
#include "radio/wire/mavlink/mavlink_decoder.h"
#include "tests/radio/wire/mavlink/golden_frames.h"

namespace hedr {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Calls test(Message{}) for each message that is known.
template <class Test>
void forEachMessage(Test test) {
    test(MavlinkHeartbeat{}), test(MavlinkSysStatus{}), test(MavlinkParamRequestRead{});
    test(MavlinkParamValue{}), test(MavlinkParamSet{}), test(MavlinkScaledImu{});
    test(MavlinkRawImu{}), test(MavlinkAttitude{}), test(MavlinkLocalPositionNed{});
    test(MavlinkCommandLong{}), test(MavlinkCommandAck{}), test(MavlinkHighresImu{});
    test(MavlinkRadioStatus{}), test(MavlinkTimesync{}), test(MavlinkStatustext{});
    test(MavlinkOdometry{}), test(MavlinkWheelDistance{});
}

template <class T>
constexpr const char* mavlinkTypeName() {
    if constexpr (std::is_same_v<T, char>) return "char";
    if constexpr (std::is_same_v<T, float>) return "float";
    if constexpr (std::is_same_v<T, double>) return "double";
    if constexpr (std::is_same_v<T, std::uint8_t>) return "uint8_t";
    if constexpr (std::is_same_v<T, std::int8_t>) return "int8_t";
    if constexpr (std::is_same_v<T, std::uint16_t>) return "uint16_t";
    if constexpr (std::is_same_v<T, std::int16_t>) return "int16_t";
    if constexpr (std::is_same_v<T, std::uint32_t>) return "uint32_t";
    if constexpr (std::is_same_v<T, std::int32_t>) return "int32_t";
    if constexpr (std::is_same_v<T, std::uint64_t>) return "uint64_t";
    if constexpr (std::is_same_v<T, std::int64_t>) return "int64_t";
}

// MAVLink's rule: the checksum of the message's name and its fields' types and names.
class CrcExtra {
  public:
    explicit CrcExtra(const std::string& message) { add(message + " "); }
    template <class T>
    void operator()(const char* name, const T&) {
        field(mavlinkTypeName<T>(), name, sizeof(T), sizeof(T));
    }
    template <class T, std::size_t n>
    void operator()(const char* name, const std::array<T, n>&) {
        field(mavlinkTypeName<T>(), name, sizeof(T), sizeof(T) * n);
        if (!extended_) add(std::string(1, static_cast<char>(n)));
    }
    void extensions() { extended_ = true; }

    int value() const { return (crc_ & 0xFF) ^ (crc_ >> 8); }
    std::size_t min_length = 0;
    std::size_t max_length = 0;
    bool sorted = true;

  private:
    void field(const std::string& type, const char* name, std::size_t width, std::size_t size) {
        max_length += size;
        if (extended_) return;
        min_length += size;
        sorted = sorted && width <= last_width_;
        last_width_ = width;
        add(type + " " + name + " ");
    }
    void add(const std::string& text) { crc_ = mavlinkCrc(Bytes(text.begin(), text.end()), crc_); }
    std::uint16_t crc_ = kMavlinkCrcStart;
    std::size_t last_width_ = 8;
    bool extended_ = false;
};

TEST(MavlinkCrc, HasThePublishedCheckValue) {
    const std::string digits = "123456789";
    EXPECT_EQ(mavlinkCrc(Bytes(digits.begin(), digits.end())), 0x6F91);
}

TEST(MavlinkCrc, GoesOnWhereItWasCut) {
    Bytes bytes;
    for (int i = 0; i < 40; ++i) bytes.push_back(static_cast<std::uint8_t>(i * 37));
    for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
        const auto all = std::span(bytes);
        EXPECT_EQ(mavlinkCrc(all.subspan(cut), mavlinkCrc(all.first(cut))), mavlinkCrc(all));
    }
}

TEST(MavlinkMessages, HaveTheChecksumsAndLengthsOfTheirFields) {
    std::size_t count = 0;
    forEachMessage([&](const auto& message) {
        ++count;
        const MavlinkMessageInfo* info = findMavlinkMessage(message.kId);
        ASSERT_NE(info, nullptr);
        CrcExtra rule(info->name);
        mavlinkFields(rule, message);
        EXPECT_EQ(rule.value(), info->crc_extra) << info->name;
        EXPECT_EQ(rule.min_length, info->min_length) << info->name;
        EXPECT_EQ(rule.max_length, info->max_length) << info->name;
        EXPECT_TRUE(rule.sorted) << info->name;
    });
    EXPECT_EQ(count, kMavlinkMessages.size());
}

TEST(MavlinkMessages, HaveThePublishedChecksums) {
    const std::vector<int> published{50,  124, 214, 220, 168, 170, 144, 39, 185,
                                     152, 143, 93,  185, 34,  83,  91,  113};
    std::vector<int> ours;
    for (const MavlinkMessageInfo& info : kMavlinkMessages) ours.push_back(info.crc_extra);
    EXPECT_EQ(ours, published);
    EXPECT_EQ(findMavlinkMessage(2), nullptr);
    EXPECT_EQ(findMavlinkMessage(9001), nullptr);
}

// Holds each field against the golden words, or takes it from them.
class Words {
  public:
    explicit Words(const nlohmann::json& fields) : fields_(fields) {}
    template <class T>
    void operator()(const char* name, const T& value) {
        EXPECT_EQ(value, fields_.at(name).get<T>()) << name;
        ++count;
    }
    template <std::size_t n>
    void operator()(const char* name, const std::array<char, n>& value) {
        const auto text = fields_.at(name).get<std::string>();
        EXPECT_STREQ(value.data(), text.c_str()) << name;  // they have a zero at the end
        ++count;
    }
    template <class T, std::size_t n>
    void operator()(const char* name, const std::array<T, n>& value) {
        EXPECT_EQ(value, (fields_.at(name).get<std::array<T, n>>())) << name;
        ++count;
    }
    void extensions() {}
    std::size_t count = 0;

  private:
    const nlohmann::json& fields_;
};

struct FromWords {
    const nlohmann::json& fields;
    template <class T>
    void operator()(const char* name, T& value) {
        value = fields.at(name).get<T>();
    }
    template <std::size_t n>
    void operator()(const char* name, std::array<char, n>& value) {
        std::ranges::copy(fields.at(name).get<std::string>(), value.begin());
    }
    void extensions() {}
};

TEST(MavlinkGolden, IsReadFieldByField) {
    std::set<std::uint32_t> ids;
    for (const test::GoldenMavlink& golden : test::goldenMavlink()) {
        SCOPED_TRACE(golden.name);
        int frames = 0;
        MavlinkDecoder decoder;
        decoder.feed(golden.bytes, [&](const MavlinkFrame& frame) {
            ++frames;
            ids.insert(frame.message_id);
            EXPECT_EQ(frame.version, golden.words.at("version"));
            EXPECT_EQ(frame.is_signed, golden.words.at("signed"));
            EXPECT_EQ(frame.sequence, golden.words.at("sequence"));
            EXPECT_EQ(frame.system, golden.words.at("system"));
            EXPECT_EQ(frame.component, golden.words.at("component"));
            EXPECT_EQ(frame.message_id, golden.words.at("id"));
            forEachMessage([&](auto message) {
                if (message.kId != frame.message_id) return;
                message = readMavlink<decltype(message)>(frame.payload);
                Words words(golden.words.at("fields"));
                mavlinkFields(words, std::as_const(message));
                EXPECT_EQ(words.count, golden.words.at("fields").size());
            });
        });
        EXPECT_EQ(frames, 1);
        EXPECT_EQ(decoder.counters().bad_frames, 0U);
    }
    EXPECT_EQ(ids.size(), kMavlinkMessages.size());
}

TEST(MavlinkGolden, IsWrittenByteByByte) {
    int written = 0;
    for (const test::GoldenMavlink& golden : test::goldenMavlink()) {
        const auto& words = golden.words;
        if (words.at("signed") || words.at("version") == 1) continue;
        forEachMessage([&](auto message) {
            if (message.kId != words.at("id")) return;
            FromWords from{words.at("fields")};
            mavlinkFields(from, message);
            const MavlinkBytes bytes = encodeMavlink(message, {.sequence = words.at("sequence"),
                                                               .system = words.at("system"),
                                                               .component = words.at("component")});
            EXPECT_EQ(Bytes(bytes.view().begin(), bytes.view().end()), golden.bytes) << golden.name;
            ++written;
        });
    }
    EXPECT_EQ(written, 18);  // each message, and one cut short
}

TEST(MavlinkCodec, LeavesTheExtensionsOutOfVersion1) {
    const MavlinkCommandAck ack{.command = 31010, .result = 2, .progress = 9, .target_system = 255};
    const MavlinkBytes bytes = encodeMavlink(ack, {.version = 1, .system = 1, .component = 1});
    EXPECT_EQ(bytes.view().size(), 6U + 3U + 2U);
    MavlinkDecoder decoder;
    decoder.feed(bytes.view(), [&](const MavlinkFrame& frame) {
        const auto read = readMavlink<MavlinkCommandAck>(frame.payload);
        EXPECT_EQ(read.command, 31010);
        EXPECT_EQ(read.result, 2);
        EXPECT_EQ(read.progress, 0);
        EXPECT_EQ(read.target_system, 0);
    });
    EXPECT_EQ(decoder.counters().good_frames, 1U);
}

TEST(MavlinkCodec, LeavesZerosOutButForTheFirst) {
    const MavlinkBytes bytes = encodeMavlink(MavlinkAttitude{}, {.system = 1, .component = 1});
    EXPECT_EQ(bytes.view().size(), 10U + 1U + 2U);
    EXPECT_EQ(encodeMavlink(MavlinkAttitude{}, {.version = 1}).view().size(), 6U + 28U + 2U);
}

// A later version of the message may have grown.
TEST(MavlinkCodec, ReadsAPayloadLongerThanItKnows) {
    Bytes payload(kMaxMavlinkPayloadBytes, 0xAB);
    const auto read = readMavlink<MavlinkTimesync>(payload);
    EXPECT_EQ(read.target_component, 0xAB);
}

}  // namespace
}  // namespace hedr
