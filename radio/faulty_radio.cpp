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
    FaultKey{"duplicate", 1.0, [](RadioFaults& f, double v) { f.duplicate = v; }},
    FaultKey{"truncate", 1.0, [](RadioFaults& f, double v) { f.truncate = v; }},
    FaultKey{"reorder", 1.0, [](RadioFaults& f, double v) { f.reorder = v; }},
    FaultKey{"delay_s", 60.0, [](RadioFaults& f, double v) { f.delay_s = v; }},
    FaultKey{"burst_at_s", 1e6, [](RadioFaults& f, double v) { f.burst_at_s = v; }},
    FaultKey{"burst_s", 1e6, [](RadioFaults& f, double v) { f.burst_s = v; }},
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

bool FaultyRadio::inBurst() const {
    return time_s_ >= faults_.burst_at_s && time_s_ < faults_.burst_at_s + faults_.burst_s;
}

void FaultyRadio::send(std::span<const std::uint8_t> frame, const Deliver& deliver) {
    if (random_.uniform() < faults_.noise) addNoise();
    if (random_.uniform() < faults_.loss || inBurst()) {
        ++deeds_.lost;
        hand(deliver);
        return;
    }
    std::vector<std::uint8_t> bytes = damaged(frame);
    if (happens(faults_.reorder)) {
        ++deeds_.reordered;
        overtaken_.push_back({0.0, 1 + static_cast<int>(random_.uniform() * 5.0), bytes});
        return;
    }
    if (faults_.delay_s > 0.0) {
        last_due_s_ = std::max(last_due_s_, time_s_ + random_.uniform(0.0, faults_.delay_s));
        delayed_.push_back({last_due_s_, 0, std::move(bytes)});
        return;
    }
    carry(bytes, deliver);
    if (happens(faults_.duplicate)) {
        ++deeds_.duplicated;
        carry(bytes, deliver);
    }
    releaseOvertaken(deliver);
}

void FaultyRadio::carry(std::span<const std::uint8_t> frame, const Deliver& deliver) {
    waiting_.insert(waiting_.end(), frame.begin(), frame.end());
    hand(deliver);
}

void FaultyRadio::releaseOvertaken(const Deliver& deliver) {
    std::vector<Held> still;
    for (Held& held : overtaken_) {
        if (--held.frames_first > 0) {
            still.push_back(std::move(held));
        } else {
            carry(held.bytes, deliver);
        }
    }
    overtaken_ = std::move(still);
}

void FaultyRadio::hand(const Deliver& deliver) {
    const std::size_t lump = faults_.lump_bytes == 0 ? waiting_.size() : faults_.lump_bytes;
    std::size_t sent = 0;
    for (; lump > 0 && waiting_.size() - sent >= lump; sent += lump) {
        deliver(std::span(waiting_).subspan(sent, lump));
    }
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(sent));
}

void FaultyRadio::passTime(double time_s, const Deliver& deliver) {
    time_s_ = time_s;
    for (; !delayed_.empty() && delayed_.front().due_s <= time_s; delayed_.pop_front()) {
        carry(delayed_.front().bytes, deliver);
    }
}

void FaultyRadio::flush(const Deliver& deliver) {
    for (const Held& held : delayed_) carry(held.bytes, deliver);
    for (const Held& held : overtaken_) carry(held.bytes, deliver);
    delayed_.clear();
    overtaken_.clear();
    if (!waiting_.empty()) deliver(waiting_);
    waiting_.clear();
}

void FaultyRadio::addNoise() {
    const auto count = 1 + static_cast<std::size_t>(random_.uniform() * kLongestNoise);
    for (std::size_t i = 0; i < count; ++i) {
        waiting_.push_back(static_cast<std::uint8_t>(random_.uniform() * 256.0));
    }
}

std::vector<std::uint8_t> FaultyRadio::damaged(std::span<const std::uint8_t> frame) {
    std::vector<std::uint8_t> bytes(frame.begin(), frame.end());
    bool changed = false;
    for (std::uint8_t& byte : bytes) {
        if (random_.uniform() >= faults_.corrupt) continue;
        byte = static_cast<std::uint8_t>(byte ^ (1 + static_cast<int>(random_.uniform() * 255.0)));
        changed = true;
    }
    if (changed) ++deeds_.corrupted;
    if (bytes.size() > 2 && happens(faults_.truncate)) {
        ++deeds_.truncated;
        const auto left = static_cast<double>(bytes.size() - 2);
        bytes.resize(1 + static_cast<std::size_t>(random_.uniform() * left));
    }
    return bytes;
}

}  // namespace hedr
