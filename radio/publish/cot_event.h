#pragma once

#include <QByteArray>
#include <QString>

#include "radio/publish/published_pose.h"

namespace hedr {

// One Cursor-on-Target event, version 2.0, in one datagram: where a robot is, who it is, whither
// it goes, and until when that is true. docs/publishing.md has every attribute.
// `station` is what tells this computer from others: two may well have a robot of the same name.
// Errors: kNoData for a pose that is stale or not finite, which must not be sent; those of onGlobe.
Result<QByteArray> cotEvent(const PublishedPose& pose, const PublishTime& time,
                            const QByteArray& station);

// The same for one robot of one computer for ever; it does not give `station` away.
QString cotUid(const std::string& call_sign, const QByteArray& station);

}  // namespace hedr
