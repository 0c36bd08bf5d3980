#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "core/result.h"
#include "radio/publish/publish_target.h"

namespace hedr {

// The command line of hedr-ocu.
struct Options {
    QStringList ports;  // one for each robot
    bool demo = false;
    QString plan;
    QString vehicle;
    QString mission;
    std::vector<PublishTarget> publish{};  // none: nobody is told
    QString screenshot;
    double screenshot_after_s = 1.0;
    std::optional<double> exit_after_s{};
};

// What to do instead of starting: print `text` and leave with `exit_code`.
struct Instead {
    QString text;
    int exit_code = 0;
};

tl::expected<Options, Instead> parseOptions(const QStringList& arguments);

}  // namespace hedr
