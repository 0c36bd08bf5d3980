#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "core/text/number.h"
#include "core/text/plain_toml.h"

namespace hedr {

// With a point, so that TOML takes it for no integer, whose digits would have to fit.
inline std::string tomlNumber(double value) {
    std::string text;
    appendNumber(text, value);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

// Lines of "key = value".
class TomlLines {
  public:
    void add(const char* key, const std::string& value) {
        text_ += std::string(key) + " = " + value + '\n';
    }
    void add(const char* key, double value) { add(key, tomlNumber(value)); }
    void addText(const char* key, std::string_view value) { add(key, quotedToml(value)); }
    void addBool(const char* key, bool value) { add(key, value ? "true" : "false"); }
    void beginTable(const char* heading) { text_.append("\n").append(heading).append("\n"); }

    std::string take() && { return std::move(text_); }

  private:
    std::string text_;
};

}  // namespace hedr
