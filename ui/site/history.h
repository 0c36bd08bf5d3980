#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace hedr {

// A value and every earlier one, so that each step can be taken back and made again.
template <class Value>
class History {
  public:
    explicit History(Value first = {}) : values_{std::move(first)} {}

    const Value& now() const { return values_[at_]; }
    void add(Value next) {
        values_.resize(at_ + 1);
        values_.push_back(std::move(next));
        ++at_;
    }
    // Changes every value there is, by `change(value)`; a step that no longer changes anything
    // goes.
    template <class Change>
    void rewrite(Change change) {
        std::vector<Value> kept;
        std::size_t at = 0;
        for (std::size_t i = 0; i < values_.size(); ++i) {
            change(values_[i]);
            if (kept.empty() || kept.back() != values_[i]) kept.push_back(std::move(values_[i]));
            if (i <= at_) at = kept.size() - 1;
        }
        values_ = std::move(kept);
        at_ = at;
    }
    bool canUndo() const { return at_ > 0; }
    void undo() { at_ -= canUndo() ? 1 : 0; }
    void redo() { at_ += at_ + 1 < values_.size() ? 1 : 0; }

  private:
    std::vector<Value> values_;
    std::size_t at_ = 0;
};

}  // namespace hedr
