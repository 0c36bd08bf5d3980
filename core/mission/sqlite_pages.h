#pragma once

// Private to core/mission: the rows of an SQLite file whose trees are damaged.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/result.h"

namespace hedr {

using SqlBlob = std::vector<std::uint8_t>;
using SqlValue = std::variant<std::monostate, std::int64_t, double, std::string, SqlBlob>;

struct FoundRow {
    std::int64_t id = 0;  // of a table with row ids, 0 elsewhere
    std::vector<SqlValue> values;
};

// Reads leaf pages one by one, those of a write-ahead log beside the file too, without any tree: a
// page tells by itself which rows it holds (the SQLite database file format, sections 1.3, 1.6 and
// 2). A page that is cut gives the rows that are whole. To which table a row belongs, its shape
// must tell. The same row may come twice.
class SqlitePages {
  public:
    // Errors: kFileUnreadable, kNotAMission.
    static Result<SqlitePages> open(const std::filesystem::path& file);

    void forEachRow(const std::function<void(const FoundRow&)>& visit);

    std::uint32_t applicationId() const { return application_id_; }
    std::uint32_t pagesPromised() const { return pages_promised_; }  // by the file's header
    std::uint64_t pagesPresent() const { return pages_present_; }    // whole ones

  private:
    using Bytes = std::span<const std::uint8_t>;
    struct Place {
        bool in_log = false;
        std::uint64_t offset = 0;
    };

    SqlitePages() = default;
    bool readHeader(std::uint64_t size);
    void listLog(const std::filesystem::path& log);
    SqlBlob readAt(Place place);
    SqlBlob overflowPage(std::uint32_t number);
    void visitLeaf(Bytes page, std::size_t header,
                   const std::function<void(const FoundRow&)>& visit);
    std::optional<FoundRow> rowAt(Bytes page, std::size_t cell, bool has_id);
    std::optional<SqlBlob> payload(Bytes local, std::uint64_t size, bool has_id);

    std::ifstream file_;
    std::ifstream log_;
    std::size_t page_size_ = 0;
    std::size_t usable_size_ = 0;
    std::uint32_t application_id_ = 0;
    std::uint32_t pages_promised_ = 0;
    std::uint64_t pages_present_ = 0;
    std::vector<Place> places_;                     // of every page, older versions first
    std::map<std::uint32_t, Place> newest_in_log_;  // by page number
};

}  // namespace hedr
