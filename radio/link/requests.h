#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "core/robot/report.h"
#include "radio/wire/request.h"

namespace hedr {

enum class RequestState : std::uint8_t {
    kWaiting,      // behind another one about the same thing
    kAsked,        // sent, perhaps more than once
    kReadingBack,  // written; what the robot has now is being asked
    kDone,
    kRefused,  // the robot says why
    kDiffers,  // written, but the robot has another value
    kNoAnswer,
    kCanceled
};

inline bool isOver(RequestState state) { return state >= RequestState::kDone; }

// How far one request is.
struct RequestProgress {
    std::uint64_t ticket = 0;
    Request wish{};
    RequestState state = RequestState::kWaiting;
    int tries = 0;                        // times it was sent, reading back included
    std::optional<std::int32_t> value{};  // of the parameter, as the robot said last
    AcknowledgeResult reason = AcknowledgeResult::kDone;  // of kRefused
    friend bool operator==(const RequestProgress&, const RequestProgress&) = default;
};

// In one line, for the record: "set parameter 5 to 123: done after 2 tries, reads 123".
std::string describe(const RequestProgress& progress);

// Requests to a robot over a link that loses a part of everything. Each is repeated until it is
// answered; a parameter that was written is read back and compared. One about parameters at a time
// is on its way, for a refusal does not name its parameter, and one command, so that the last wish
// comes last. Times are
// seconds of the receive clock.
class Requests {
  public:
    static constexpr double kRetry_s = 0.4;     // a robot answers within 0.2 s
    static constexpr double kPatience_s = 8.0;  // for the answer to one question
    // So long after the last of several tries may an answer to it still come.
    static constexpr double kLinger_s = 4.0;
    // So many answers with another value than the one written are no late ones.
    static constexpr int kSureAfter = 3;

    // `ticket` is the caller's, another for each request. A time request is not for here.
    void ask(std::uint64_t ticket, const Request& wish);
    // What was sent cannot be taken back: the robot may have done it.
    void cancel(std::uint64_t ticket);
    void cancelAll();

    // What is to be sent now. `answer_after_s`: what the link takes for it, as far as is known.
    std::vector<Request> due(double now_s, double answer_after_s = 0.0);
    void hear(const Report& report) {
        std::visit([this](const auto& known) { take(known); }, report);
        forgetEnded();
    }

    // Each change of a request since the last call, the latest of each.
    std::vector<RequestProgress> takeNews();

  private:
    // What an answer can be about: a parameter, or a command.
    struct Subject {
        bool parameter = false;
        std::uint8_t number = 0;
        friend auto operator<=>(const Subject&, const Subject&) = default;
    };
    struct Open {
        RequestProgress progress{};
        double first_sent_s = 0.0;  // of this question
        double last_sent_s = 0.0;
        int question_tries = 0;
        int answers = 0;       // heard, of all questions
        int other_values = 0;  // answers to this question that are not what was written
    };

    static Subject subjectOf(const Request& wish);
    bool mayStart(std::size_t index, double now_s) const;
    bool isDue(Open& open, double now_s, double retry_s);
    void take(const ParameterReport& parameter);
    void take(const AcknowledgeReport& acknowledge);
    template <class Other>
    void take(const Other&) {}
    void beginQuestion(Open& open, RequestState state);
    void end(Open& open, RequestState state);
    void note(const RequestProgress& progress);
    void forgetEnded();

    std::vector<Open> open_;                  // in the order asked
    std::map<Subject, double> not_before_s_;  // late answers may still come until then
    std::vector<RequestProgress> news_;
};

}  // namespace hedr
