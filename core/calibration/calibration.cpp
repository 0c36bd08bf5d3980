#include "core/calibration/calibration.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace hedr {

namespace {

constexpr double kSure = 0.99;
constexpr std::string_view kTooSmall =
    "The difference is too small to be sure of. More samples may tell.";

bool isUsable(const FoundParameter& found) {
    return std::isfinite(found.now.value) && std::isfinite(found.now.standard_error) &&
           found.now.standard_error >= 0.0 && found.now.degrees_of_freedom > 0.0;
}

bool differs(const FoundParameter& found) {
    if (found.stays) return false;
    return !found.was || !found.now.interval(kSure).contains(*found.was);
}

bool isNearer(const FoundParameter& found) {
    if (found.stays) return false;
    return !found.was || found.now.isNearerThan(*found.was, kSure);
}

Calibration decided(Calibration calibration, Verdict verdict, std::string reason) {
    calibration.verdict = verdict;
    calibration.reason = std::move(reason);
    return calibration;
}

}  // namespace

Calibration refused(Calibration calibration, std::string reason) {
    std::erase_if(calibration.found, [](const auto& found) { return !isUsable(found); });
    return decided(std::move(calibration), Verdict::kRefused, std::move(reason));
}

Calibration judged(Calibration calibration) {
    if (!std::all_of(calibration.found.begin(), calibration.found.end(), isUsable)) {
        return refused(std::move(calibration), "The samples do not determine the parameters.");
    }
    const bool nothing_changes =
        !calibration.found.empty() &&
        std::all_of(calibration.found.begin(), calibration.found.end(),
                    [](const FoundParameter& found) { return found.stays; });
    if (nothing_changes && calibration.proof && calibration.proof->better()) {
        return decided(std::move(calibration), Verdict::kNotProven, std::string(kTooSmall));
    }
    // Before the proof: the values found lose a little by it, as a part is held out.
    if (std::none_of(calibration.found.begin(), calibration.found.end(), differs)) {
        return decided(std::move(calibration), Verdict::kUnchanged,
                       "The old values are as good as these samples can tell.");
    }
    if (calibration.proof && calibration.proof->worse()) {
        return refused(std::move(calibration),
                       "The part of the data that was held out fits the old values better.");
    }
    if (!calibration.proof || calibration.proof->parts < Proof::kFewestParts) {
        return decided(std::move(calibration), Verdict::kNotProven,
                       "Too little data could be held out to prove that it is better.");
    }
    if (!calibration.proof->better()) {
        return decided(std::move(calibration), Verdict::kNotProven,
                       "The part of the data that was held out does not tell old and new apart.");
    }
    if (std::none_of(calibration.found.begin(), calibration.found.end(), isNearer)) {
        return decided(std::move(calibration), Verdict::kNotProven, std::string(kTooSmall));
    }
    return decided(std::move(calibration), Verdict::kAccepted,
                   "The part of the data that was held out fits the new values better.");
}

Result<Vehicle> calibrated(const Vehicle& believed, const Calibration& calibration) {
    Vehicle vehicle = believed;
    for (const FoundParameter& found : calibration.found) {
        if (found.stays) continue;
        const auto set = setVehicleNumber(vehicle, found.key, found.now.value);
        if (!set) return tl::make_unexpected(set.error());
    }
    return vehicle;
}

}  // namespace hedr
