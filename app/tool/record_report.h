#pragma once

#include <optional>
#include <string>

#include "ui/link_state.h"

namespace hedr::tool {

// What whoever records without a window has to know, on standard error, each thing once: that the
// robot is not heard and why, that it is heard again, what is wrong with signatures, and at the end
// what was recorded.
class RecordReport {
  public:
    RecordReport(std::string port, std::string mission);

    void take(const LiveBatch& batch);
    // Now and then, for silence brings no batch.
    void tellLink();
    void finish() const;

    bool wasOpen() const { return was_open_; }

  private:
    void tellOfTrust(const LiveBatch& batch);

    std::string port_;
    std::string mission_;
    LinkWatch link_{};
    LiveBatch last_{};  // without tracks and history: a night of them fills the memory
    bool was_open_ = false;
    bool told_waiting_ = false;
    bool told_key_error_ = false;
    bool told_no_key_ = false;
    LinkTrouble told_ = LinkTrouble::kNone;
    LinkTrouble trouble_ = LinkTrouble::kNone;
    ReceiveClock::time_point trouble_since_{};
};

}  // namespace hedr::tool
