#pragma once

#include <QDir>
#include <QProcess>
#include <QStandardPaths>
#include <QStringList>
#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "radio/replay.h"
#include "radio/robot_line.h"

namespace hedr {

// Where packaging/mavlink-peer.sh puts node-mavlink: one folder for all builds.
inline const QString kMavlinkPeerModules = QStringLiteral(HEDR_SOURCE_DIR "/build/mavlink_peer");

// Why there can be no peer, and what to do about it; empty where there can be one.
inline std::string noMavlinkPeer() {
    const bool node = !QStandardPaths::findExecutable("node").isEmpty();
    const bool modules = QDir(kMavlinkPeerModules + "/node_modules/node-mavlink").exists();
    if (node && modules) return {};
    return std::string(node ? "node-mavlink" : "node") +
           " is not installed: run packaging/install-deps.sh test, then packaging/mavlink-peer.sh";
}

// A robot on a pseudo-terminal that is a program of its own: mavlink_peer/peer.mjs. It begins when
// somebody opens the terminal.
class MavlinkPeer {
  public:
    MavlinkPeer(const QString& port, const QStringList& options)
        : line_(RobotLine::openPseudoTerminal(port.toStdString()).value()),
          thread_([this, options] { run(options); }) {}
    ~MavlinkPeer() {
        stop_ = true;
        thread_.join();
    }
    // Whether it ended by itself, or could not be started.
    bool failed() const { return failed_; }

  private:
    void run(const QStringList& options) {
        if (!waitForListener(line_, [this] { return stop_.load(); })) return;
        QProcess node;
        node.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        node.start("node", QStringList{kPeer, kMavlinkPeerModules} + options);
        while (!stop_ && node.state() != QProcess::NotRunning) {
            node.waitForReadyRead(kNap_ms);
            const QByteArray said = node.readAllStandardOutput();
            line_.send({reinterpret_cast<const std::uint8_t*>(said.constData()),
                        static_cast<std::size_t>(said.size())});
            const std::vector<std::uint8_t> heard = line_.receive();
            node.write(reinterpret_cast<const char*>(heard.data()),
                       static_cast<qint64>(heard.size()));
        }
        failed_ = !stop_;
        node.closeWriteChannel();
        if (!node.waitForFinished(kPatience_ms)) node.kill();
        node.waitForFinished(kPatience_ms);
    }

    static constexpr int kNap_ms = 2;
    static constexpr int kPatience_ms = 5000;
    inline static const QString kPeer =
        QStringLiteral(HEDR_SOURCE_DIR "/tests/e2e/mavlink_peer/peer.mjs");

    RobotLine line_;
    std::atomic<bool> stop_{false};
    std::atomic<bool> failed_{false};
    std::thread thread_;
};

}  // namespace hedr
