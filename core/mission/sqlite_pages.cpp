#include "core/mission/sqlite_pages.h"

#include <algorithm>
#include <bit>
#include <string_view>

#include "core/mission/mission_database.h"

namespace hedr {

namespace {

constexpr std::string_view kMagic{"SQLite format 3\0", 16};
constexpr std::size_t kFileHeaderBytes = 100;
constexpr std::size_t kLogHeaderBytes = 32;
constexpr std::size_t kLogFrameHeaderBytes = 24;
constexpr std::uint8_t kTableLeaf = 0x0d;
constexpr std::uint8_t kIndexLeaf = 0x0a;
constexpr std::uint64_t kLargestPayloadBytes = 64U << 20U;  // none of a mission comes near

using Bytes = std::span<const std::uint8_t>;

std::uint64_t bigEndian(Bytes bytes) {
    std::uint64_t value = 0;
    for (const std::uint8_t byte : bytes) value = value << 8U | byte;
    return value;
}

std::uint32_t u32At(Bytes bytes, std::size_t offset) {
    return static_cast<std::uint32_t>(bigEndian(bytes.subspan(offset, 4)));
}

// Takes an integer of variable length from the front; nothing where it is cut.
std::optional<std::uint64_t> takeVarint(Bytes& bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < 9 && i < bytes.size(); ++i) {
        const std::uint8_t byte = bytes[i];
        const bool last = i == 8 || (byte & 0x80U) == 0;
        value = i == 8 ? value << 8U | byte : value << 7U | (byte & 0x7fU);
        if (!last) continue;
        bytes = bytes.subspan(i + 1);
        return value;
    }
    return std::nullopt;
}

// Section 2.1, the serial type codes.
std::uint64_t sizeOfType(std::uint64_t type) {
    constexpr std::uint64_t kSizes[] = {0, 1, 2, 3, 4, 6, 8, 8, 0, 0, 0, 0};
    return type < 12 ? kSizes[type] : (type - 12) / 2;
}

std::int64_t signedNumber(Bytes bytes) {
    const auto unused = static_cast<unsigned>(64 - 8 * bytes.size());
    return static_cast<std::int64_t>(bigEndian(bytes) << unused) >> unused;
}

SqlValue valueOf(std::uint64_t type, Bytes bytes) {
    if (type == 0 || type == 10 || type == 11) return std::monostate{};
    if (type == 7) return std::bit_cast<double>(bigEndian(bytes));
    if (type == 8 || type == 9) return static_cast<std::int64_t>(type - 8);
    if (type < 7) return signedNumber(bytes);
    if (type % 2 == 0) return SqlBlob(bytes.begin(), bytes.end());
    return std::string(bytes.begin(), bytes.end());
}

std::optional<std::vector<SqlValue>> recordOf(Bytes record) {
    Bytes rest = record;
    const auto header_size = takeVarint(rest);
    if (!header_size || *header_size > record.size()) return std::nullopt;
    const std::size_t own = record.size() - rest.size();
    if (*header_size < own) return std::nullopt;
    Bytes types = rest.first(static_cast<std::size_t>(*header_size) - own);
    Bytes body = record.subspan(static_cast<std::size_t>(*header_size));
    std::vector<SqlValue> values;
    while (!types.empty()) {
        const auto type = takeVarint(types);
        if (!type || sizeOfType(*type) > body.size()) return std::nullopt;
        const auto size = static_cast<std::size_t>(sizeOfType(*type));
        values.push_back(valueOf(*type, body.first(size)));
        body = body.subspan(size);
    }
    return values;
}

}  // namespace

Result<SqlitePages> SqlitePages::open(const std::filesystem::path& file) {
    SqlitePages pages;
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    if (error) return fail(ErrorCode::kFileUnreadable, file.string(), error.message());
    pages.file_.open(file, std::ios::binary);
    if (!pages.file_) return fail(ErrorCode::kFileUnreadable, file.string());
    if (!pages.readHeader(size)) return fail(ErrorCode::kNotAMission, file.string());
    for (std::uint64_t offset = 0; offset < size; offset += pages.page_size_) {
        pages.places_.push_back({false, offset});
    }
    pages.pages_present_ = size / pages.page_size_;
    pages.listLog(missionLogFile(file));
    return pages;
}

bool SqlitePages::readHeader(std::uint64_t size) {
    if (size < kFileHeaderBytes) return false;
    SqlBlob head(kFileHeaderBytes);
    file_.read(reinterpret_cast<char*>(head.data()), static_cast<std::streamsize>(head.size()));
    if (!file_ || !std::equal(kMagic.begin(), kMagic.end(), head.begin())) return false;
    const auto stored = bigEndian(Bytes(head).subspan(16, 2));
    page_size_ = stored == 1 ? 65536 : static_cast<std::size_t>(stored);
    if (page_size_ < 512 || !std::has_single_bit(page_size_)) return false;
    usable_size_ = page_size_ - std::min<std::size_t>(head[20], page_size_ - 480);
    pages_promised_ = u32At(head, 28);
    application_id_ = u32At(head, 68);
    return true;
}

// Also frames that were not committed: what they hold was written once.
void SqlitePages::listLog(const std::filesystem::path& log) {
    std::error_code error;
    const auto size = std::filesystem::file_size(log, error);
    if (error) return;
    log_.open(log, std::ios::binary);
    const std::size_t frame = kLogFrameHeaderBytes + page_size_;
    for (std::uint64_t offset = kLogHeaderBytes; offset + frame <= size; offset += frame) {
        SqlBlob number(4);
        log_.clear();
        log_.seekg(static_cast<std::streamoff>(offset));
        log_.read(reinterpret_cast<char*>(number.data()), 4);
        if (!log_) return;
        const Place place{true, offset + kLogFrameHeaderBytes};
        places_.push_back(place);
        newest_in_log_[u32At(number, 0)] = place;
    }
}

// As much of the page as there is.
SqlBlob SqlitePages::readAt(Place place) {
    std::ifstream& from = place.in_log ? log_ : file_;
    SqlBlob page(page_size_);
    from.clear();
    from.seekg(static_cast<std::streamoff>(place.offset));
    from.read(reinterpret_cast<char*>(page.data()), static_cast<std::streamsize>(page.size()));
    page.resize(static_cast<std::size_t>(std::max<std::streamsize>(from.gcount(), 0)));
    return page;
}

SqlBlob SqlitePages::overflowPage(std::uint32_t number) {
    const auto in_log = newest_in_log_.find(number);
    if (in_log != newest_in_log_.end()) return readAt(in_log->second);
    return readAt({false, (number - 1ULL) * page_size_});
}

void SqlitePages::forEachRow(const std::function<void(const FoundRow&)>& visit) {
    for (const Place& place : places_) {
        const SqlBlob page = readAt(place);
        const bool first = !place.in_log && place.offset == 0;
        visitLeaf(page, first ? kFileHeaderBytes : 0, visit);
    }
}

void SqlitePages::visitLeaf(Bytes page, std::size_t header,
                            const std::function<void(const FoundRow&)>& visit) {
    constexpr std::size_t kLeafHeaderBytes = 8;
    if (page.size() < header + kLeafHeaderBytes) return;
    const std::uint8_t type = page[header];
    if (type != kTableLeaf && type != kIndexLeaf) return;
    const auto cells = static_cast<std::size_t>(bigEndian(page.subspan(header + 3, 2)));
    for (std::size_t i = 0; i < cells; ++i) {
        const std::size_t pointer = header + kLeafHeaderBytes + 2 * i;
        if (pointer + 2 > page.size()) return;
        const auto cell = static_cast<std::size_t>(bigEndian(page.subspan(pointer, 2)));
        if (const auto row = rowAt(page, cell, type == kTableLeaf)) visit(*row);
    }
}

std::optional<FoundRow> SqlitePages::rowAt(Bytes page, std::size_t cell, bool has_id) {
    if (cell >= page.size()) return std::nullopt;
    Bytes rest = page.subspan(cell);
    const auto size = takeVarint(rest);
    const auto id = has_id ? takeVarint(rest) : std::optional<std::uint64_t>(0);
    if (!size || !id || *size > kLargestPayloadBytes) return std::nullopt;
    const auto record = payload(rest, *size, has_id);
    if (!record) return std::nullopt;
    auto values = recordOf(*record);
    if (!values) return std::nullopt;
    return FoundRow{static_cast<std::int64_t>(*id), std::move(*values)};
}

// Section 1.6, how much of a payload lies in the page itself; the rest is a chain of pages.
std::optional<SqlBlob> SqlitePages::payload(Bytes local, std::uint64_t size, bool has_id) {
    const std::uint64_t usable = usable_size_;
    const std::uint64_t most = has_id ? usable - 35 : (usable - 12) * 64 / 255 - 23;
    const std::uint64_t least = (usable - 12) * 32 / 255 - 23;
    std::uint64_t here = size;
    if (size > most) {
        const std::uint64_t fitting = least + (size - least) % (usable - 4);
        here = fitting <= most ? fitting : least;
    }
    if (local.size() < here + (here < size ? 4 : 0)) return std::nullopt;
    SqlBlob bytes(local.begin(), local.begin() + static_cast<std::ptrdiff_t>(here));
    std::uint32_t next = here < size ? u32At(local, static_cast<std::size_t>(here)) : 0;
    while (bytes.size() < size) {
        if (next == 0) return std::nullopt;
        const SqlBlob page = overflowPage(next);
        const auto wanted =
            static_cast<std::size_t>(std::min<std::uint64_t>(size - bytes.size(), usable - 4));
        if (page.size() < 4 + wanted) return std::nullopt;
        bytes.insert(bytes.end(), page.begin() + 4,
                     page.begin() + 4 + static_cast<std::ptrdiff_t>(wanted));
        next = u32At(page, 0);
    }
    return bytes;
}

}  // namespace hedr
