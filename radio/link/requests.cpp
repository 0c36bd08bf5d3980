#include "radio/link/requests.h"

#include <algorithm>
#include <utility>

namespace hedr {

namespace {

constexpr std::uint8_t kGetId = 0x81;  // by which a refusal names what was refused
constexpr std::uint8_t kSetId = 0x82;

const ParameterSet* writing(const RequestProgress& progress) {
    return std::get_if<ParameterSet>(&progress.wish);
}

bool onItsWay(RequestState state) {
    return state == RequestState::kAsked || state == RequestState::kReadingBack;
}

AcknowledgeResult resultOf(std::uint8_t raw) {
    const bool known = raw <= static_cast<std::uint8_t>(AcknowledgeResult::kNotSupported);
    return known ? static_cast<AcknowledgeResult>(raw) : AcknowledgeResult::kNotSupported;
}

Request questionOf(const RequestProgress& progress) {
    const auto* set = writing(progress);
    return set && progress.state == RequestState::kReadingBack ? Request(ParameterGet{set->id})
                                                               : progress.wish;
}

}  // namespace

std::string describe(const RequestProgress& progress) {
    constexpr const char* kStates[] = {"waiting",   "asked",   "reading back",
                                       "done",      "refused", "the robot has another value",
                                       "no answer", "canceled"};
    std::string text;
    if (const auto* get = std::get_if<ParameterGet>(&progress.wish)) {
        text.append("get parameter ").append(std::to_string(get->id));
    } else if (const auto* set = writing(progress)) {
        text.append("set parameter ").append(std::to_string(set->id));
        text.append(" to ").append(std::to_string(set->value));
    } else if (const auto* command = std::get_if<RobotCommand>(&progress.wish)) {
        text.append("command ").append(std::to_string(static_cast<int>(command->kind)));
    }
    text.append(": ").append(kStates[static_cast<std::size_t>(progress.state)]);
    text.append(" after ").append(std::to_string(progress.tries)).append(" tries");
    if (progress.value) text.append(", reads ").append(std::to_string(*progress.value));
    if (progress.state == RequestState::kRefused) {
        text.append(", reason ").append(std::to_string(static_cast<int>(progress.reason)));
    }
    return text;
}

Requests::Subject Requests::subjectOf(const Request& wish) {
    if (const auto* get = std::get_if<ParameterGet>(&wish)) return {true, get->id};
    if (const auto* set = std::get_if<ParameterSet>(&wish)) return {true, set->id};
    const auto* command = std::get_if<RobotCommand>(&wish);
    return {false, command ? static_cast<std::uint8_t>(command->kind) : std::uint8_t{0}};
}

void Requests::ask(std::uint64_t ticket, const Request& wish) {
    open_.push_back({.progress = {.ticket = ticket, .wish = wish}});
    note(open_.back().progress);
}

void Requests::cancel(std::uint64_t ticket) {
    for (Open& open : open_) {
        if (open.progress.ticket == ticket) end(open, RequestState::kCanceled);
    }
    forgetEnded();
}

void Requests::cancelAll() {
    for (Open& open : open_) end(open, RequestState::kCanceled);
    forgetEnded();
}

std::vector<Request> Requests::due(double now_s, double answer_after_s) {
    std::vector<Request> questions;
    for (std::size_t i = 0; i < open_.size(); ++i) {
        Open& open = open_[i];
        if (open.progress.state == RequestState::kWaiting) {
            if (!mayStart(i, now_s)) continue;
            beginQuestion(open, RequestState::kAsked);
        }
        if (isDue(open, now_s, std::max(kRetry_s, 2.0 * answer_after_s)))
            questions.push_back(questionOf(open.progress));
    }
    forgetEnded();
    return questions;
}

bool Requests::mayStart(std::size_t index, double now_s) const {
    const Subject subject = subjectOf(open_[index].progress.wish);
    const auto late = not_before_s_.find(subject);
    const auto all = not_before_s_.find({subject.parameter, 0});
    if (late != not_before_s_.end() && now_s < late->second) return false;
    if (subject.parameter && all != not_before_s_.end() && now_s < all->second) return false;
    return std::none_of(open_.begin(), open_.begin() + static_cast<std::ptrdiff_t>(index),
                        [&](const Open& earlier) {
                            const Subject other = subjectOf(earlier.progress.wish);
                            return !isOver(earlier.progress.state) &&
                                   other.parameter == subject.parameter;
                        });
}

// Gives up what was not answered for too long.
bool Requests::isDue(Open& open, double now_s, double retry_s) {
    if (!onItsWay(open.progress.state)) return false;
    if (open.question_tries == 0) open.first_sent_s = now_s;
    if (now_s - open.first_sent_s >= kPatience_s) {
        end(open, open.other_values > 0 ? RequestState::kDiffers : RequestState::kNoAnswer);
        return false;
    }
    if (open.question_tries > 0 && now_s - open.last_sent_s < retry_s) return false;
    open.last_sent_s = now_s;
    ++open.question_tries;
    ++open.progress.tries;
    note(open.progress);
    return true;
}

void Requests::take(const ParameterReport& parameter) {
    for (Open& open : open_) {
        RequestProgress& progress = open.progress;
        if (!onItsWay(progress.state) || subjectOf(progress.wish) != Subject{true, parameter.id})
            continue;
        ++open.answers;
        progress.value = parameter.value;
        const auto* set = writing(progress);
        if (!set) return end(open, RequestState::kDone);
        const bool as_written = parameter.value == set->value;
        // Perhaps a late answer to an earlier request: only several of them are believed.
        if (!as_written && ++open.other_values < kSureAfter) return note(progress);
        if (progress.state == RequestState::kAsked)
            return beginQuestion(open, RequestState::kReadingBack);
        return end(open, as_written ? RequestState::kDone : RequestState::kDiffers);
    }
}

void Requests::take(const AcknowledgeReport& acknowledge) {
    const bool about_parameters = acknowledge.command == kGetId || acknowledge.command == kSetId;
    for (Open& open : open_) {
        RequestProgress& progress = open.progress;
        const Subject subject = subjectOf(progress.wish);
        const bool meant =
            about_parameters ? subject.parameter : subject == Subject{false, acknowledge.command};
        if (!onItsWay(progress.state) || !meant) continue;
        ++open.answers;
        progress.reason = resultOf(acknowledge.result);
        return end(open, progress.reason == AcknowledgeResult::kDone ? RequestState::kDone
                                                                     : RequestState::kRefused);
    }
}

void Requests::beginQuestion(Open& open, RequestState state) {
    open.progress.state = state;
    open.question_tries = 0;
    open.other_values = 0;
    note(open.progress);
}

void Requests::end(Open& open, RequestState state) {
    const bool more_may_come = open.progress.tries > open.answers;
    const Subject subject = subjectOf(open.progress.wish);
    const double until_s = open.last_sent_s + kLinger_s;
    if (more_may_come) not_before_s_[subject] = until_s;
    // A refusal that comes late would be taken for one of the next parameter.
    const bool refusable = state == RequestState::kRefused || state == RequestState::kCanceled;
    if (more_may_come && subject.parameter && refusable) not_before_s_[{true, 0}] = until_s;
    open.progress.state = state;
    note(open.progress);
}

void Requests::note(const RequestProgress& progress) {
    const auto same = std::ranges::find(news_, progress.ticket, &RequestProgress::ticket);
    if (same == news_.end()) {
        news_.push_back(progress);
    } else {
        *same = progress;
    }
}

void Requests::forgetEnded() {
    std::erase_if(open_, [](const Open& open) { return isOver(open.progress.state); });
}

std::vector<RequestProgress> Requests::takeNews() { return std::exchange(news_, {}); }

}  // namespace hedr
