#include "radio/faulty_radio.h"

#include <algorithm>
#include <array>

#include "core/text/number.h"

namespace hedr {

namespace {

constexpr std::size_t kLongestNoise = 12;

struct FaultKey {
    std::string_view name;
    double max;
    void (*set)(RadioFaults& faults, double value);
};

constexpr std::array kFaultKeys{
    FaultKey{"loss", 1.0, [](RadioFaults& f, double v) { f.loss = v; }},
    FaultKey{"corrupt", 1.0, [](RadioFaults& f, double v) { f.corrupt = v; }},
    FaultKey{"noise", 1.0, [](RadioFaults& f, double v) { f.noise = v; }},
    FaultKey{"lump", 65536.0,
             [](RadioFaults& f, double v) { f.lump_bytes = static_cast<std::size_t>(v); }},
    FaultKey{"seed", 1e15,
             [](RadioFaults& f, double v) { f.seed = static_cast<std::uint64_t>(v); }},
};

}  // namespace

Result<void> setRadioFault(RadioFaults& faults, std::string_view key, std::string_view value) {
    std::string known;
    for (const FaultKey& fault : kFaultKeys) {
        known += (known.empty() ? "" : ", ") + std::string(fault.name);
        if (fault.name != key) continue;
        const std::optional<double> number = parseNumber(value);
        if (!number || !(*number >= 0.0 && *number <= fault.max)) {
            return fail(ErrorCode::kBadValue, std::string(key),
                        "is \"" + std::string(value) + "\", must be a number from 0 to " +
                            std::to_string(static_cast<std::int64_t>(fault.max)));
        }
        fault.set(faults, *number);
        return {};
    }
    return fail(ErrorCode::kUnknownName, std::string(key), "known are " + known);
}

FaultyRadio::FaultyRadio(const RadioFaults& faults) : faults_(faults), random_(faults.seed) {}

void FaultyRadio::send(std::span<const std::uint8_t> frame, const Deliver& deliver) {
    if (random_.uniform() < faults_.noise) addNoise();
    if (random_.uniform() >= faults_.loss) addCorrupted(frame);
    const std::size_t lump = std::max<std::size_t>(faults_.lump_bytes, 1);
    if (faults_.lump_bytes == 0) {
        flush(deliver);
        return;
    }
    std::size_t sent = 0;
    for (; waiting_.size() - sent >= lump; sent += lump) {
        deliver(std::span(waiting_).subspan(sent, lump));
    }
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(sent));
}

void FaultyRadio::flush(const Deliver& deliver) {
    if (!waiting_.empty()) deliver(waiting_);
    waiting_.clear();
}

void FaultyRadio::addNoise() {
    const auto count = 1 + static_cast<std::size_t>(random_.uniform() * kLongestNoise);
    for (std::size_t i = 0; i < count; ++i) {
        waiting_.push_back(static_cast<std::uint8_t>(random_.uniform() * 256.0));
    }
}

void FaultyRadio::addCorrupted(std::span<const std::uint8_t> frame) {
    for (std::uint8_t byte : frame) {
        if (random_.uniform() < faults_.corrupt) {
            byte =
                static_cast<std::uint8_t>(byte ^ (1 + static_cast<int>(random_.uniform() * 255.0)));
        }
        waiting_.push_back(byte);
    }
}

}  // namespace hedr
