#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/tool/command.h"
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
    object["note"] = figure.note;
    return object;
}

void printJson(const Paper& paper, const Reproduction& reproduction, int seeds) {
    Json object{{"paper", paper.name}, {"title", paper.title}, {"seeds", seeds}};
    object["figures"] = Json::array();
    for (const Figure& figure : reproduction.figures) object["figures"].push_back(toJson(figure));
    object["remarks"] = reproduction.remarks;
    std::cout << object.dump() << '\n';
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
    if (!agrees) return "-";
    if (!*agrees) return "NO";
    return figure.set_to_match ? "set to match" : "yes";
}

struct Row {
    std::string name, paper, ours, agrees, place;
};

void print(const Paper& paper, const Reproduction& reproduction, int seeds) {
    std::vector<Row> rows{{"figure", "paper", "ours", "agrees", "where"}};
    for (const Figure& figure : reproduction.figures) {
        rows.push_back({figure.name, figure.paper.empty() ? "-" : figure.paper, oursOf(figure),
                        verdictOf(figure), figure.place});
    }
    const auto width = [&rows](std::string Row::*column) {
        std::size_t most = 0;
        for (const Row& row : rows) most = std::max(most, (row.*column).size());
        return static_cast<int>(most);
    };
    std::printf("%s\nMedians of %d seeds.\n\n", std::string(paper.title).c_str(), seeds);
    for (const Row& row : rows) {
        std::printf("%-*s  %-*s  %-*s  %-*s  %s\n", width(&Row::name), row.name.c_str(),
                    width(&Row::paper), row.paper.c_str(), width(&Row::ours), row.ours.c_str(),
                    width(&Row::agrees), row.agrees.c_str(), row.place.c_str());
    }
    std::printf("\n");
    for (const Figure& figure : reproduction.figures) {
        if (!figure.note.empty())
            std::printf("%s: %s.\n", figure.name.c_str(), figure.note.c_str());
    }
    std::printf("\nAbout the paper:\n");
    for (const std::string& remark : reproduction.remarks) std::printf("- %s\n", remark.c_str());
}

Result<void> runReproduce(const Options& options) {
    const Paper& paper = *findPaper(options.paper);
    ReproductionOptions how;
    const bool watched = isatty(STDERR_FILENO) != 0;
    if (watched) {
        how.progress = [](int done, int total) {
            std::fprintf(stderr, "\r%d of %d", done, total);
            if (done == total) std::fprintf(stderr, "\r\x1b[K");
        };
    }
    const Reproduction reproduction = paper.reproduce(how);
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
