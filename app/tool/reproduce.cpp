#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/tool/command.h"
#include "app/tool/json_line.h"
#include "app/tool/progress_line.h"
#include "core/reproduction/papers.h"

namespace hedr::tool {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string paper;
    bool json = false;
};

Json orNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json toJson(const Figure& figure) {
    Json object{{"name", figure.name}, {"place", figure.place}, {"paper", figure.paper}};
    object["ours"] = figure.ours ? orNull(*figure.ours) : Json(nullptr);
    object["unit"] = figure.unit;
    object["agrees_within"] = nullptr;
    if (figure.agrees_within) {
        object["agrees_within"] = {orNull(figure.agrees_within->low),
                                   orNull(figure.agrees_within->high)};
    }
    const auto agrees = figure.agrees();
    object["agrees"] = agrees ? Json(*agrees) : Json(nullptr);
    object["set_to_match"] = figure.set_to_match;
    object["note"] = figure.needsReason() ? figure.note : std::string();
    return object;
}

void printJson(const Paper& paper, const Reproduction& reproduction, int seeds) {
    Json object{{"paper", paper.name}, {"title", paper.title}, {"seeds", seeds}};
    object["figures"] = Json::array();
    for (const Figure& figure : reproduction.figures) object["figures"].push_back(toJson(figure));
    object["remarks"] = reproduction.remarks;
    std::cout << jsonLine(object);
}

// Three significant digits, more for a ratio that hardly differs from 1.
std::string oursOf(const Figure& figure) {
    if (!figure.ours) return "-";
    char text[32];
    const double size = std::abs(*figure.ours);
    const bool whole = size >= 99.95 || size == std::floor(size);
    const bool ratio_near_one = figure.unit.empty() && std::abs(size - 1.0) < 0.05;
    const char* form = ratio_near_one ? "%.4f" : whole ? "%.0f" : size >= 9.995 ? "%.1f" : "%.2f";
    std::snprintf(text, sizeof text, form, *figure.ours);
    return text + (figure.unit.empty() ? "" : ' ' + figure.unit);
}

std::string verdictOf(const Figure& figure) {
    const auto agrees = figure.agrees();
    if (!agrees) return {};
    if (!*agrees) return "NO";
    return figure.set_to_match ? "set to match" : "yes";
}

// A limit: as it was chosen where it is small, as whole millimetres or degrees elsewhere.
std::string plain(double value) {
    char text[32];
    std::snprintf(text, sizeof text, std::abs(value) < 15.0 ? "%.5g" : "%.0f", value);
    return text;
}

// What counts as agreeing.
std::string criterionOf(const Figure& figure) {
    if (!figure.agrees_within) return {};
    const auto& [low, high] = *figure.agrees_within;
    if (std::isinf(low)) return "<= " + plain(high);
    if (std::isinf(high)) return ">= " + plain(low);
    return low == high ? plain(low) : plain(low) + " to " + plain(high);
}

using Row = std::array<std::string, 6>;

std::vector<Row> rowsOf(const Reproduction& reproduction) {
    std::vector<Row> rows{{"figure", "paper", "ours", "agrees", "if it is", "where in the paper"}};
    for (const Figure& figure : reproduction.figures) {
        rows.push_back({figure.name, figure.paper, oursOf(figure), verdictOf(figure),
                        criterionOf(figure), figure.place});
    }
    return rows;
}

void printAligned(const std::vector<Row>& rows) {
    std::array<std::size_t, std::tuple_size_v<Row>> widths{};
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            line += row[i] + std::string(widths[i] - row[i].size() + 2, ' ');
        }
        std::cout << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
    }
}

void print(const Paper& paper, const Reproduction& reproduction, int seeds) {
    std::cout << paper.title << "\nMedians of " << seeds << " seeds.\n\n";
    printAligned(rowsOf(reproduction));
    std::string notes;
    for (const Figure& figure : reproduction.figures) {
        if (figure.needsReason()) notes += figure.name + ": " + figure.note + ".\n";
    }
    std::cout << (notes.empty() ? "" : "\n") << notes << "\nAbout the paper:\n";
    for (const std::string& remark : reproduction.remarks) std::cout << "- " << remark << '\n';
}

Reproduction reproduce(const Paper& paper, ReproductionOptions how) {
    ProgressLine progress("run");
    how.progress = [&progress](int done, int total) {
        progress.show(static_cast<std::size_t>(done), static_cast<std::size_t>(total));
    };
    return paper.reproduce(how);
}

Result<void> runReproduce(const Options& options) {
    const Paper& paper = *findPaper(options.paper);
    const ReproductionOptions how;
    const Reproduction reproduction = reproduce(paper, how);
    if (options.json) {
        printJson(paper, reproduction, how.seeds);
    } else {
        print(paper, reproduction, how.seeds);
    }
    return {};
}

std::string paperNames() {
    std::string names;
    for (const Paper& paper : paperTable()) {
        names += (names.empty() ? "" : ", ") + std::string(paper.name);
    }
    return names;
}

CLI::Validator aPaper() {
    return CLI::Validator(
        [](const std::string& name) {
            return findPaper(name) ? std::string() : "\"" + name + "\" is none of " + paperNames();
        },
        "", "paper");
}

}  // namespace

Job addReproduce(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("PAPER", options->paper, "One of " + paperNames())->required()->check(aPaper());
    app.add_flag("--json", options->json, "One JSON object on standard output");
    return [options] { return runReproduce(*options); };
}

}  // namespace hedr::tool
