#pragma once

#include <QString>
#include <cstddef>
#include <utility>
#include <vector>

namespace hedr {

// A value and every earlier one, so that each step can be taken back and made again.
template <class Value>
class History {
  public:
    explicit History(Value first = {}) : steps_{{std::move(first), {}}} {}

    const Value& now() const { return steps_[at_].value; }
    void add(Value next, const QString& what) {
        steps_.resize(at_ + 1);
        steps_.push_back({std::move(next), what});
        ++at_;
    }
    // Corrects the newest value without a step of its own.
    void amend(Value value) { steps_[at_].value = std::move(value); }

    bool canUndo() const { return at_ > 0; }
    bool canRedo() const { return at_ + 1 < steps_.size(); }
    const QString& undoText() const { return steps_[at_].what; }  // what would be taken back
    void undo() { at_ -= canUndo() ? 1 : 0; }
    void redo() { at_ += canRedo() ? 1 : 0; }

  private:
    struct Step {
        Value value;
        QString what;
    };
    std::vector<Step> steps_;
    std::size_t at_ = 0;
};

}  // namespace hedr
