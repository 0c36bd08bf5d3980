#pragma once

#include <QMetaType>
#include <QString>

namespace hedr {

// A floor plan that the operator wants to see, and what only the operator knows of it.
struct PlanFileWish {
    QString file{};
    int page = 1;                // of a file that has several
    double paper_scale = 100.0;  // of a page drawn 1 : 100
    friend bool operator==(const PlanFileWish&, const PlanFileWish&) = default;
};

}  // namespace hedr

Q_DECLARE_METATYPE(hedr::PlanFileWish)
