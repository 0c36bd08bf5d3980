#include <QAction>
#include <QDir>
#include <QFileDialog>

#include "ui/calibration/calibration_desk.h"
#include "ui/calibration/ends_page.h"
#include "ui/calibration/history_page.h"
#include "ui/main_window.h"
#include "ui/map/map_view.h"
#include "ui/panels/banner.h"
#include "ui/site/file_dialog_look.h"
#include "ui/site/site_desk.h"

// The calibration of one of the robots; what else the window does is in main_window.cpp.
namespace hedr {

void MainWindow::connectCalibration() {
    connect(calibration_, &CalibrationDesk::openChanged, this, &MainWindow::showCalibration);
    connect(calibration_, &CalibrationDesk::samplesWished, this,
            [this](bool wished) { emit samplesWished(wished, calibrated_); });
    desk_->join(*ends_page_);
    connect(calibration_, &CalibrationDesk::endsWished, this, [this](const ClickedEnds& earlier) {
        ends_page_->choose(earlier);
        desk_->showPage(ends_page_);
    });
    connect(ends_page_, &EndsPage::clicked, calibration_, &CalibrationDesk::takeEnds);
    connect(ends_page_, &EndsPage::finished, calibration_, &CalibrationDesk::comeBack);
    connect(calibration_, &CalibrationDesk::concluded, this,
            [this](const CalibrationOutcome& outcome) {
                emit calibrationConcluded(outcome, outcome.robot);
            });
}

void MainWindow::connectHistory() {
    history_->hide();
    connect(calibration_, &CalibrationDesk::historyWished, this,
            [this] { emit historyWished(calibrated_); });
    connect(
        history_, &HistoryPage::restoreWished, this,
        [this](const QString& entry, RestoreTo to) { emit restoreWished(entry, to, calibrated_); });
    connect(history_, &HistoryPage::exportWished, this, &MainWindow::askWhereToExport);
    connect(history_, &HistoryPage::closed, this, [this] {
        history_->hide();
        showCalibration();
        emit calibrationWished(calibrated_);  // back to the list
    });
}

void MainWindow::showHistory(const HistoryView& view) {
    const bool opens = !showsHistory();
    history_->show(view);
    if (!opens) return;
    history_->raise();
    history_->focusFirst();
    showCalibration();
}

bool MainWindow::showsHistory() const { return history_->isVisibleTo(this); }

void MainWindow::askWhereToExport(const QString& entry) {
    auto* dialog = new QFileDialog(this, tr("Choose a folder for the copy"), QDir::homePath());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dress(*dialog, theme_);
    connect(dialog, &QFileDialog::fileSelected, this, [this, entry](const QString& folder) {
        emit exportWished(entry, folder, calibrated_);
    });
    dialog->open();
}

void MainWindow::calibrate() {
    if (calibration_->isAside()) return desk_->cancel();  // back to it
    if (desk_->open()) return showRefusal(tr("Finish first what is being done on the map."));
    if (!model().last().vehicle) {
        return showRefusal(
            tr("Connect to a robot first (C): a calibration listens to its sensors."));
    }
    calibrated_ = fleet_.chosen().id;
    emit calibrationWished(calibrated_);
}

void MainWindow::chooseCalibration(const CalibrationPast& past) {
    const FleetRobot* robot = fleet_.find(calibrated_);
    if (!robot || !robot->model.last().vehicle) return;
    Vehicle vehicle = *robot->model.last().vehicle;
    for (const Calibration& calibration : past.since_connected)
        vehicle = calibrated(vehicle, calibration).value_or(vehicle);
    calibration_->choose({.id = calibrated_,
                          .robot = fleet_.callSign(*robot),
                          .vehicle = vehicle,
                          .takes_parameters = requestRefusal().isEmpty(),
                          .on_plan = map_->hasPlan(),
                          .surfaces = past.surfaces,
                          .kept = past.kept},
                         past.last);
}

// Its keys are its own: a letter must not move the map behind it.
void MainWindow::showCalibration() {
    const bool open = calibration_->open() || showsHistory();
    for (QAction* action : actions()) action->setEnabled(!open);
    if (!open) map_->setFocus();
    refresh();
}

QString MainWindow::samplesTrouble() const {
    const FleetRobot* robot = fleet_.find(calibrated_);
    if (!robot) return tr("The robot is not in the list any more.");
    const LinkVerdict link = robot->model.link(clock_.now());
    if (link.state == LinkState::kLive) return {};
    return link.state == LinkState::kStale ? tr("Nothing new from the robot")
                                           : tr("The robot is not heard");
}

void MainWindow::showTrouble(const QString& text) {
    error_banner_->add(text, BannerTone::kAlarm);
    placeOverlays();
}

void MainWindow::showNews(const QString& text) { showNote(text, BannerTone::kNews); }

}  // namespace hedr
