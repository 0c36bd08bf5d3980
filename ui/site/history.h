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
    bool canUndo() const { return at_ > 0; }
    void undo() { at_ -= canUndo() ? 1 : 0; }
    void redo() { at_ += at_ + 1 < values_.size() ? 1 : 0; }

  private:
    std::vector<Value> values_;
    std::size_t at_ = 0;
};

}  // namespace hedr
