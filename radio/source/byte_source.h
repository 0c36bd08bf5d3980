#pragma once

#include <QByteArray>
#include <QObject>
#include <memory>

#include "core/result.h"
#include "radio/source/link_address.h"

namespace hedr {

// Where the bytes of a robot come from, and where requests go. One that went away is opened again,
// as soon as it is back, until close().
class ByteSource : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    virtual void open() = 0;
    virtual void close() = 0;
    // Lost where it is not open: a request is repeated anyhow.
    virtual void write(const QByteArray& bytes) = 0;
    // What comes makes sense: a source that tries settings stops with those it has.
    virtual void noteUnderstood() {}
    // What comes makes sense, but the robot said how to read it before anybody listened, as boards
    // do that print a header line when they start.
    virtual void noteNamesMissing() {}
    // With what was found out since, such as the baud rate.
    virtual LinkAddress address() const = 0;
    // Whether the robot cannot know of us before we have sent something.
    virtual bool speaksFirst() const { return false; }
    // Whether there is anybody who could do what a request asks for.
    virtual bool canAnswer() const { return true; }

  signals:
    // Bytes that follow do not continue those before.
    void opened();
    void bytesReceived(const QByteArray& bytes);
    // It could not be opened or went away: once for each reason.
    void failed(const hedr::Error& error);
};

std::unique_ptr<ByteSource> makeByteSource(const LinkAddress& address);

}  // namespace hedr

Q_DECLARE_METATYPE(hedr::Error)
