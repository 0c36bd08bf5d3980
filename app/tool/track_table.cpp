#include "app/tool/track_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "app/tool/comparison.h"
#include "app/tool/progress_line.h"
#include "core/geometry/angle.h"
#include "core/track/track_file.h"

namespace hedr::tool {

namespace {

using Row = std::vector<std::string>;

// NaN: the method or the truth does not say.
std::string figure(double value) {
    if (std::isnan(value)) return "-";
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << value;
    return text.str();
}

Row header(bool with_truth) {
    Row row{"estimator", "end_x_m", "end_y_m", "end_heading_deg", "sigma_m", "sigma_deg"};
    if (with_truth) {
        row.insert(row.end(), {"heading_rmse_deg", "ape_rmse_m", "end_position_error_m"});
    }
    return row;
}

Row rowOf(const NamedTrack& track) {
    assert(!track.points.empty());
    const auto& [position, heading_rad] = track.points.back().pose;
    Row row{track.name, figure(position.x), figure(position.y), figure(degFromRad(heading_rad))};
    const PoseVariance& variance = track.points.back().variance;
    if (!variance.known()) {
        row.insert(row.end(), {"-", "-"});
        return row;
    }
    const auto position_m2 = static_cast<double>(variance.var_x_m2 + variance.var_y_m2);
    const auto heading_rad2 = static_cast<double>(variance.var_heading_rad2);
    row.push_back(figure(std::sqrt(position_m2)));
    row.push_back(figure(degFromRad(std::sqrt(heading_rad2))));
    return row;
}

}  // namespace

Result<std::string> trackTable(const std::vector<NamedTrack>& tracks, const Truth& truth) {
    std::vector<Row> rows{header(truth.has_value())};
    for (const NamedTrack& track : tracks) {
        rows.push_back(rowOf(track));
        if (!truth) continue;
        const auto judged = compare(track.points, *truth, Alignment::kStart,
                                    "The track " + track.name + " or the truth");
        if (!judged) return tl::make_unexpected(judged.error());
        for (const double value :
             {judged->heading_rmse_deg, judged->ape_rmse_m, judged->end_position_error_m}) {
            rows.back().push_back(figure(value));
        }
    }
    return aligned(rows) +
           "sigma: one standard deviation of the end, as the estimator sees it; -: not known\n";
}

Result<void> saveTracks(const std::filesystem::path& folder,
                        const std::vector<NamedTrack>& tracks) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return fail(ErrorCode::kFileUnwritable, folder.string(), error.message());
    ProgressLine progress("writing track");
    std::size_t written = 0;
    for (const NamedTrack& track : tracks) {
        progress.show(++written, tracks.size());
        auto saved = saveTrack(folder / (track.name + ".csv"), track.points);
        if (!saved) return saved;
    }
    return {};
}

std::string aligned(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const Row& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blanks(widths[i] - row[i].size(), ' ');
            text += i == 0 ? row[i] + blanks : "  " + blanks + row[i];
        }
        text += '\n';
    }
    return text;
}

}  // namespace hedr::tool
