#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace hedr {

// Walks over the rows of a comma-separated text with one header row, without copying it. A byte
// order mark, CRLF, spaces around fields, blank lines and lines that begin with # are tolerated; a
// row with more or fewer fields than the header is not. Errors carry path:line and the column.
class CsvReader {
  public:
    // `text` must outlive the reader. Errors: kFileEmpty, kBadFormat (not a text, a column twice).
    static Result<CsvReader> open(std::string_view text, std::string path);

    const std::vector<std::string>& columns() const { return columns_; }
    std::optional<std::size_t> find(std::string_view column) const;
    Result<std::size_t> require(std::string_view column) const;  // kMissingColumn

    // Steps to the next row; false at the end. Error: kBadFormat.
    Result<bool> next();
    std::string where() const;  // path:line of the current row

    // Fields of the current row. Error: kBadFormat.
    std::string_view text(std::size_t column) const { return fields_[column]; }
    Result<double> number(std::size_t column) const;       // must be finite
    Result<double> numberOrNan(std::size_t column) const;  // NaN where empty or "nan"
    Result<std::optional<std::int64_t>> integer(std::size_t column) const;

  private:
    CsvReader(std::string_view text, std::string path) : rest_(text), path_(std::move(path)) {}
    bool nextLine(std::string_view& line);
    tl::unexpected<Error> badField(std::size_t column, const char* wanted) const;

    std::string_view rest_;
    std::string path_;
    std::size_t line_number_ = 0;
    std::vector<std::string> columns_;
    std::vector<std::string_view> fields_;
};

}  // namespace hedr
