#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"
#include "core/text/toml.h"

namespace hedr {

// The values of a TOML table, each checked.

// The first thing that was wrong with a text; what follows it is not looked at.
class FirstError {
  public:
    explicit FirstError(std::string name) : name_(std::move(name)) {}
    void note(ErrorCode code, const toml::source_region& place, std::string detail);
    const std::optional<Error>& found() const { return found_; }

  private:
    std::string name_;  // of the text, in front of the line
    std::optional<Error> found_{};
};

struct NumberRule {
    bool (*allows)(double);
    const char* otherwise;  // "must be positive"
};

// Hands out the values of one table; what is wrong goes to `error`, and any value comes back.
class TomlKeys {
  public:
    TomlKeys(const toml::table& table, FirstError& error) : table_(&table), error_(&error) {}

    bool has(std::string_view key) const { return table_->contains(key); }
    double number(std::string_view key, double otherwise, const NumberRule& rule);
    double neededNumber(std::string_view key, const NumberRule& rule);
    std::int64_t neededInteger(std::string_view key);
    bool flag(std::string_view key, bool otherwise);
    std::string text(std::string_view key, std::string_view otherwise);
    std::string neededText(std::string_view key);
    // A list of exactly so many finite numbers; false where there is no such key.
    bool numbers(std::string_view key, std::span<double> values);
    std::vector<std::pair<double, double>> neededPairs(std::string_view key);
    std::vector<std::string> texts(std::string_view key);  // none where there is no such key
    std::optional<TomlKeys> table(std::string_view key);
    std::vector<TomlKeys> tables(std::string_view key);  // none where there is no such key

    // Says that a value, or its absence, is wrong.
    void refuse(std::string_view key, std::string_view why);
    // A misspelt key must not pass silently. To be called last.
    void refuseOthers();

  private:
    const toml::node* find(std::string_view key);
    const toml::node* need(std::string_view key);
    bool readNumbers(const toml::node& list, std::span<double> values);

    const toml::table* table_;
    FirstError* error_;
    std::set<std::string, std::less<>> known_{};  // what was asked for
};

}  // namespace hedr
