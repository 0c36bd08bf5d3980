#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

// The house has four floors and arrows only go down; some rooms keep a secret (a library that no
// other room includes). Both are read off the #include lines.
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 4> kFloors{"core", "radio", "ui", "app"};

struct Secret {
    const char* headers;  // a pattern for what is included
    const char* room;     // a pattern for the files that may
};

const std::array kSecrets{
    Secret{"SQLiteCpp/.*|sqlite3.*", "core/mission/.*"},
    Secret{"(gdal|ogr|cpl_|vrt).*", "core/site/.*"},
    Secret{"opencv.*", "core/site/.*"},
    Secret{"openssl/.*", "core/text/file_hash.cpp"},
    Secret{"(librsvg/|cairo).*", "core/site/.*"},
    Secret{"boost/.*", "core/calibration/distributions.cpp"},
    Secret{"toml\\+\\+.*|toml\\.hpp", "core/text/toml\\.h"},
    Secret{"core/text/toml\\.h",
           "core/(robot|site|simulation|calibration)/.*|core/text/toml(_keys)?\\..*"},
    Secret{"(QtSerialPort/)?QSerialPort.*", "radio/source/.*"},
    Secret{"(QtNetwork/)?Q(Tcp|Udp|Abstract)(Socket|Server).*", "radio/(source|publish)/.*"},
    Secret{"sodium.*", "radio/wire/signing/.*"},
    Secret{"(QtCore/)?QSettings", "app/settings.*"},
    Secret{"CLI/.*|nlohmann/.*", "app/.*"},
    Secret{"termios\\.h|pty\\.h", "radio/(?!wire/).*"},
    // What is simulated, calibrated or judged does not know how it is estimated.
    Secret{"core/(fusion|reproduction)/.*",
           "(?!core/(geometry|text|robot|site|track|simulation|calibration)/).*"},
    Secret{"core/simulation/.*", "(?!core/(fusion|calibration)/).*"},
    // The floors below the windows: no Qt in core and in the wire, no widgets in the radio.
    Secret{"Q[A-Z].*|Qt[A-Z].*", "(radio/(?!wire/|firmware/).*|ui/.*|app/.*)"},
    Secret{"QtWidgets.*|QtGui.*|Q(Widget|Painter|Application|Image|Pixmap|Color)", "(ui|app)/.*"},
};

bool matches(const std::string& text, const char* pattern) {
    return std::regex_match(text, std::regex(pattern));
}

// 0 for the ground floor; -1 for what is no part of the house.
int floorOf(const std::string& path) {
    const std::string room = path.substr(0, path.find('/'));
    const auto found = std::find(kFloors.begin(), kFloors.end(), room);
    return found == kFloors.end() ? -1 : static_cast<int>(found - kFloors.begin());
}

// A quoted name is a path from the top of the tree, so that every include can be followed by eye.
bool isGuessable(const std::string& file, const std::string& header) {
    const bool firmware = file.starts_with("radio/firmware/");  // copied out alone
    return firmware || floorOf(header) >= 0 || header.ends_with(".moc");
}

// Why `file` must not include `header`; empty where it may.
std::string objection(const std::string& file, const std::string& header, bool quoted) {
    if (quoted && !isGuessable(file, header)) return "is not a path from the top";
    if (floorOf(header) > floorOf(file)) return "is on a higher floor";
    const bool wire = file.starts_with("radio/wire/") || file.starts_with("radio/firmware/");
    const bool below = header.starts_with("radio/wire/") || header.starts_with("radio/firmware/") ||
                       !header.starts_with("radio/");
    if (wire && !below) return "is above the wire";
    if (file.starts_with("radio/firmware/") && floorOf(header) >= 0) {
        return "does not come along to a robot";
    }
    for (const Secret& secret : kSecrets) {
        if (matches(header, secret.headers) && !matches(file, secret.room)) {
            return std::string("belongs in ") + secret.room;
        }
    }
    return {};
}

std::vector<std::string> violations(const std::string& file, const std::string& text) {
    static const std::regex include_line(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
    std::vector<std::string> found;
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::smatch match;
        if (!std::regex_search(line, match, include_line)) continue;
        const std::string why = objection(file, match[2].str(), match[1].str() == "\"");
        if (why.empty()) continue;
        found.push_back(file + ":" + std::to_string(number) + ": " + match[2].str() + " " + why);
    }
    return found;
}

std::string contentOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

bool isSource(const fs::path& file) {
    const std::string kind = file.extension().string();
    return kind == ".h" || kind == ".cpp" || kind == ".c";
}

std::vector<fs::path> sourcesOf(const char* floor) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(HEDR_SOURCE_DIR) / floor)) {
        if (entry.is_regular_file() && isSource(entry.path())) files.push_back(entry.path());
    }
    return files;
}

TEST(Layering, HoldsInEverySourceFile) {
    for (const char* floor : kFloors) {
        const std::vector<fs::path> files = sourcesOf(floor);
        EXPECT_FALSE(files.empty()) << floor << " has no sources: is HEDR_SOURCE_DIR right?";
        for (const fs::path& file : files) {
            const std::string name = fs::relative(file, HEDR_SOURCE_DIR).generic_string();
            for (const std::string& line : violations(name, contentOf(file))) {
                ADD_FAILURE() << line;
            }
        }
    }
}

struct Case {
    const char* file;
    const char* line;
};

const std::array kRefused{Case{"core/track/track.h", "#include \"radio/link_health.h\""},
                          Case{"core/track/track.h", "#include <QString>"},
                          Case{"core/track/track.h", "#  include <QtCore/QString>"},
                          Case{"radio/link.cpp", "#include \"ui/error_text.h\""},
                          Case{"radio/link.cpp", "#include <QWidget>"},
                          Case{"radio/wire/packet.cpp", "#include <QByteArray>"},
                          Case{"radio/wire/packet.cpp", "#include \"radio/link_health.h\""},
                          Case{"radio/firmware/hedr_wire.h", "#include \"core/result.h\""},
                          Case{"ui/main_window.cpp", "#include \"app/settings.h\""},
                          Case{"ui/main_window.cpp", "#include <QSettings>"},
                          Case{"ui/main_window.cpp", "#include <QSerialPortInfo>"},
                          Case{"radio/live_link.cpp", "#include <QSerialPort>"},
                          Case{"radio/wire/mavlink/mavlink.h", "#include <QByteArray>"},
                          Case{"ui/main_window.cpp", "#include \"theme.h\""},
                          Case{"app/session.cpp", "#include <SQLiteCpp/Database.h>"},
                          Case{"core/track/track.cpp", "#include <sqlite3.h>"},
                          Case{"core/track/track.cpp", "#include <gdal_priv.h>"},
                          Case{"ui/map/plan_layer.cpp", "#include <opencv2/imgproc.hpp>"},
                          Case{"ui/site/site_desk.cpp", "#include <openssl/evp.h>"},
                          Case{"ui/map/plan_layer.cpp", "#include <librsvg/rsvg.h>"},
                          Case{"core/fusion/hedr.cpp", "#include <toml++/toml.h>"},
                          Case{"core/simulation/drive.cpp", "#include \"core/fusion/hedr.h\""},
                          Case{"core/fusion/hedr.cpp", "#include \"core/simulation/drive.h\""},
                          Case{"core/fusion/hedr.cpp", "#include <nlohmann/json.hpp>"}};

const std::array kAllowed{
    Case{"app/session.cpp", "#include \"ui/main_window.h\""},
    Case{"app/settings_store.cpp", "#include <QSettings>"},
    Case{"app/tool/fuse.cpp", "#include <CLI/CLI.hpp>"},
    Case{"ui/main_window.cpp", "#include \"main_window.moc\""},
    Case{"radio/source/serial_source.cpp", "#include <QSerialPort>"},
    Case{"radio/source/udp_source.cpp", "#include <QUdpSocket>"},
    Case{"radio/simulated_robot.cpp", "#include \"radio/firmware/hedr_wire.h\""},
    Case{"radio/wire/packet.cpp", "#include \"core/robot/report.h\""},
    Case{"radio/firmware/hedr_robot.h", "#include \"hedr_wire.h\""},
    Case{"core/mission/mission.cpp", "#include <SQLiteCpp/SQLiteCpp.h>"},
    Case{"core/site/plan.cpp", "#include <gdal_priv.h>"},
    Case{"core/reproduction/hedr_paper.cpp", "#include \"core/fusion/hedr.h\""},
    Case{"core/track/track.cpp", "// #include <QString>"}};

TEST(Layering, RefusesWhatRunsUpOrGivesASecretAway) {
    for (const Case& c : kRefused) {
        const std::vector<std::string> found =
            violations(c.file, std::string("#pragma once\n") + c.line + "\n");
        ASSERT_EQ(found.size(), 1U) << c.file << " may include " << c.line;
        EXPECT_TRUE(found[0].starts_with(std::string(c.file) + ":2: ")) << found[0];
    }
}

TEST(Layering, AllowsWhatRunsDownOrStaysInItsRoom) {
    for (const Case& c : kAllowed) {
        EXPECT_TRUE(violations(c.file, c.line).empty()) << c.file << " may not " << c.line;
    }
}

}  // namespace
