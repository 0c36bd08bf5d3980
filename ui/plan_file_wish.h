#pragma once

#include <QMetaType>
#include <QString>

#include "core/site/plan.h"

namespace hedr {

// A floor plan that the operator wants to see.
struct PlanFileWish {
    QString file{};
    PlanChoice choice{};
    bool lasting = true;  // false: nobody will want to open it again
    friend bool operator==(const PlanFileWish&, const PlanFileWish&) = default;
};

}  // namespace hedr

Q_DECLARE_METATYPE(hedr::PlanFileWish)
