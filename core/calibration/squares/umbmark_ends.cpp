#include "core/calibration/squares/umbmark_ends.h"

#include <algorithm>
#include <utility>

#include "core/text/csv.h"

namespace hedr {

namespace {

class EndReader {
  public:
    static Result<EndReader> open(std::string_view csv, const std::string& path) {
        auto reader = CsvReader::open(csv, path);
        if (!reader) return tl::make_unexpected(reader.error());
        EndReader ends(*std::move(reader));
        for (const auto& [column, index] :
             {std::pair{"run", &ends.run_}, {"x_m", &ends.x_}, {"y_m", &ends.y_}}) {
            const auto found = ends.reader_.require(column);
            if (!found) return tl::make_unexpected(found.error());
            *index = *found;
        }
        ends.direction_ = ends.reader_.find("direction");
        return ends;
    }

    Result<std::vector<UmbmarkEnd>> read() {
        std::vector<UmbmarkEnd> ends;
        for (;;) {
            const auto more = reader_.next();
            if (!more) return tl::make_unexpected(more.error());
            if (!*more) return ends;
            const auto end = row();
            if (!end) return tl::make_unexpected(end.error());
            if (std::ranges::find(ends, end->run, &UmbmarkEnd::run) != ends.end()) {
                return bad("run " + std::to_string(end->run) + " twice");
            }
            ends.push_back(*end);
        }
    }

  private:
    explicit EndReader(CsvReader reader) : reader_(std::move(reader)) {}

    tl::unexpected<Error> bad(std::string detail) const {
        return fail(ErrorCode::kBadFormat, reader_.where(), std::move(detail));
    }

    Result<UmbmarkEnd> row() const {
        const auto run = reader_.integer(run_);
        if (!run) return tl::make_unexpected(run.error());
        if (run->value_or(0) < 1) return bad("run must be a whole number from 1 on");
        const auto x = reader_.number(x_);
        if (!x) return tl::make_unexpected(x.error());
        const auto y = reader_.number(y_);
        if (!y) return tl::make_unexpected(y.error());
        const auto said = direction();
        if (!said) return tl::make_unexpected(said.error());
        return UmbmarkEnd{static_cast<std::size_t>(**run), {*x, *y}, *said};
    }

    Result<std::optional<Turning>> direction() const {
        const std::string_view text = direction_ ? reader_.text(*direction_) : std::string_view();
        if (text.empty()) return std::optional<Turning>();
        for (const Turning turning : {Turning::kClockwise, Turning::kCounterClockwise}) {
            if (text == nameOf(turning)) return std::optional(turning);
        }
        return bad("direction must be clockwise or counter-clockwise");
    }

    CsvReader reader_;
    std::size_t run_ = 0;
    std::size_t x_ = 0;
    std::size_t y_ = 0;
    std::optional<std::size_t> direction_{};
};

}  // namespace

Result<std::vector<UmbmarkEnd>> parseUmbmarkEnds(std::string_view csv, const std::string& path) {
    return EndReader::open(csv, path).and_then([](EndReader reader) { return reader.read(); });
}

}  // namespace hedr
