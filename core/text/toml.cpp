#include "core/text/toml.h"

#include "core/text/plain_toml.h"

namespace hedr {

Result<toml::table> parseToml(std::string_view text, const std::string& path) {
    const auto plain = plainToml(text, path);
    if (!plain) return tl::make_unexpected(plain.error());
    try {
        return toml::parse(*plain);
    } catch (const toml::parse_error& error) {
        return fail(ErrorCode::kBadFormat, path + ':' + std::to_string(error.source().begin.line),
                    std::string(error.description()));
    }
}

}  // namespace hedr
