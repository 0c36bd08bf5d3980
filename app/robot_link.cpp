#include "app/robot_link.h"

namespace hedr {

RobotLink::RobotLink(const LiveLink::Setup& setup, QObject* parent)
    : QObject(parent), link_(new LiveLink(setup)) {
    qRegisterMetaType<LiveBatch>();
    thread_.setObjectName("radio");
    link_->moveToThread(&thread_);
    connect(&thread_, &QThread::finished, link_, &QObject::deleteLater);
    connect(link_, &LiveLink::batchReady, this, &RobotLink::batchReady);
    thread_.start();
}

RobotLink::~RobotLink() {
    thread_.quit();
    thread_.wait();
}

void RobotLink::open(const LinkAddress& address) {
    QMetaObject::invokeMethod(link_, [link = link_, address] { link->open(address); });
}

void RobotLink::close() { QMetaObject::invokeMethod(link_, &LiveLink::close); }

void RobotLink::setFramePeriod(std::chrono::milliseconds period) {
    QMetaObject::invokeMethod(link_, [link = link_, period] { link->setFramePeriod(period); });
}

void RobotLink::notePlan(const MissionPlan& plan) {
    QMetaObject::invokeMethod(link_, [link = link_, plan] { link->notePlan(plan); });
}

void RobotLink::noteSite(const Site& site) {
    QMetaObject::invokeMethod(link_, [link = link_, site] { link->noteSite(site); });
}

void RobotLink::noteFloor(const std::string& name) {
    QMetaObject::invokeMethod(link_, [link = link_, name] { link->noteFloor(name); });
}

void RobotLink::ask(std::uint64_t ticket, const Request& request) {
    QMetaObject::invokeMethod(link_,
                              [link = link_, ticket, request] { link->ask(ticket, request); });
}

void RobotLink::cancelRequest(std::uint64_t ticket) {
    QMetaObject::invokeMethod(link_, [link = link_, ticket] { link->cancelRequest(ticket); });
}

void RobotLink::keepSensors(bool keep) {
    QMetaObject::invokeMethod(link_, [link = link_, keep] { link->keepSensors(keep); });
}

}  // namespace hedr
