#include "core/text/toml_keys.h"

#include <array>
#include <cmath>

namespace hedr {

void FirstError::note(ErrorCode code, const toml::source_region& place, std::string detail) {
    if (found_) return;
    const auto line = place.begin.line;
    found_ = Error{code, line == 0 ? name_ : name_ + ':' + std::to_string(line), std::move(detail)};
}

const toml::node* TomlKeys::find(std::string_view key) {
    known_.emplace(key);
    return table_->get(key);
}

const toml::node* TomlKeys::need(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) error_->note(ErrorCode::kMissingKey, table_->source(), std::string(key));
    return node;
}

void TomlKeys::refuse(std::string_view key, std::string_view why) {
    const toml::node* node = table_->get(key);
    error_->note(ErrorCode::kBadValue, node ? node->source() : table_->source(),
                 std::string(key) + ' ' + std::string(why));
}

double TomlKeys::number(std::string_view key, double otherwise, const NumberRule& rule) {
    const toml::node* node = find(key);
    return node ? neededNumber(key, rule) : otherwise;
}

double TomlKeys::neededNumber(std::string_view key, const NumberRule& rule) {
    const toml::node* node = need(key);
    if (!node) return 0.0;
    const auto value = node->is_number() ? node->value<double>() : std::nullopt;
    if (!value) {
        refuse(key, "must be a number");
        return 0.0;
    }
    if (!std::isfinite(*value) || !rule.allows(*value)) refuse(key, rule.otherwise);
    return *value;
}

std::int64_t TomlKeys::neededInteger(std::string_view key) {
    const toml::node* node = need(key);
    if (!node) return 0;
    const auto* value = node->as_integer();
    if (!value) refuse(key, "must be a whole number");
    return value ? value->get() : 0;
}

bool TomlKeys::flag(std::string_view key, bool otherwise) {
    const toml::node* node = find(key);
    if (!node) return otherwise;
    const auto* value = node->as_boolean();
    if (!value) refuse(key, "must be true or false");
    return value ? value->get() : otherwise;
}

std::string TomlKeys::text(std::string_view key, std::string_view otherwise) {
    return find(key) ? neededText(key) : std::string(otherwise);
}

std::string TomlKeys::neededText(std::string_view key) {
    const toml::node* node = need(key);
    if (!node) return {};
    const auto* value = node->as_string();
    if (!value) refuse(key, "must be a text in quotes");
    return value ? value->get() : std::string();
}

bool TomlKeys::readNumbers(const toml::node& list, std::span<double> values) {
    const toml::array* array = list.as_array();
    if (!array || array->size() != values.size()) return false;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const toml::node& node = (*array)[i];
        const auto value = node.is_number() ? node.value<double>() : std::nullopt;
        if (!value || !std::isfinite(*value)) return false;
        values[i] = *value;
    }
    return true;
}

bool TomlKeys::numbers(std::string_view key, std::span<double> values) {
    const toml::node* node = find(key);
    if (!node) return false;
    if (!readNumbers(*node, values))
        refuse(key, "must be a list of " + std::to_string(values.size()) + " numbers");
    return true;
}

std::vector<std::pair<double, double>> TomlKeys::neededPairs(std::string_view key) {
    std::vector<std::pair<double, double>> pairs;
    const toml::node* node = need(key);
    if (!node) return pairs;
    const toml::array* list = node->as_array();
    if (!list) {
        refuse(key, "must be a list of points, [[x, y], ...]");
        return pairs;
    }
    pairs.reserve(list->size());
    for (const toml::node& item : *list) {
        std::array<double, 2> xy{};
        if (!readNumbers(item, xy))
            error_->note(ErrorCode::kBadValue, item.source(),
                         std::string(key) + " must hold points of two numbers, [x, y]");
        pairs.emplace_back(xy[0], xy[1]);
    }
    return pairs;
}

std::vector<std::string> TomlKeys::texts(std::string_view key) {
    std::vector<std::string> texts;
    const toml::node* node = find(key);
    if (!node) return texts;
    const toml::array* list = node->as_array();
    if (!list || (!list->empty() && !list->is_homogeneous(toml::node_type::string))) {
        refuse(key, "must be a list of texts");
        return texts;
    }
    for (const toml::node& item : *list) texts.push_back(item.value_or(std::string()));
    return texts;
}

std::optional<TomlKeys> TomlKeys::table(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (const toml::table* table = node->as_table()) return TomlKeys(*table, *error_);
    refuse(key, "must be a table, [" + std::string(key) + "]");
    return std::nullopt;
}

std::vector<TomlKeys> TomlKeys::tables(std::string_view key) {
    std::vector<TomlKeys> tables;
    const toml::node* node = find(key);
    if (!node) return tables;
    const toml::array* list = node->as_array();
    if (!list) {
        refuse(key, "must be tables, each below its own [[...]]");
        return tables;
    }
    for (const toml::node& item : *list) {
        if (const toml::table* table = item.as_table()) {
            tables.emplace_back(*table, *error_);
        } else {
            error_->note(ErrorCode::kBadValue, item.source(),
                         std::string(key) + " must hold tables only");
        }
    }
    return tables;
}

void TomlKeys::refuseOthers() {
    for (const auto& [key, node] : *table_) {
        if (!known_.contains(key.str()))
            error_->note(ErrorCode::kBadValue, key.source(), "unknown key " + std::string(key));
    }
}

}  // namespace hedr
