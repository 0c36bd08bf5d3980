#pragma once

#include <QtTest/QTest>
#include <functional>
#include <vector>

#include "radio/source/byte_source.h"

namespace hedr {

// What a source has said.
struct SourceListener {
    explicit SourceListener(ByteSource& source) {
        QObject::connect(&source, &ByteSource::opened, [this] { ++opened; });
        QObject::connect(&source, &ByteSource::failed,
                         [this](const Error& error) { errors.push_back(error); });
        QObject::connect(&source, &ByteSource::bytesReceived,
                         [this](const QByteArray& some) { bytes += some; });
    }
    int opened = 0;
    std::vector<Error> errors{};
    QByteArray bytes{};
};

inline bool soon(const std::function<bool()>& condition, int patience_ms = 5000) {
    return QTest::qWaitFor(condition, patience_ms);
}

}  // namespace hedr
