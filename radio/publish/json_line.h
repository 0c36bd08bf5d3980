#pragma once

#include <QByteArray>

#include "radio/publish/published_pose.h"

namespace hedr {

// One JSON object and a line feed: SI units and the site's own metres, and latitude and longitude
// where the site is tied to the globe. "age_s" and "link" ("live", "stale", "lost") say how old it
// is. docs/publishing.md has every key. Error kNoData: a pose that is not finite.
Result<QByteArray> jsonLine(const PublishedPose& pose, const PublishTime& time);

}  // namespace hedr
