#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

#include "core/calibration/history/surface_profile.h"
#include "ui/calibration/calibration_run.h"
#include "ui/calibration/calibration_view.h"
#include "ui/calibration/clicked_ends.h"
#include "ui/calibration/procedure_list.h"
#include "ui/theme.h"

namespace hedr {

class CalibrationPage;

// Whose calibration it is.
struct CalibrationSubject {
    RobotId id = kFirstRobot;
    QString robot;      // as the operator knows it
    Vehicle vehicle{};  // as it is believed
    bool takes_parameters = false;
    bool on_plan = false;  // the map has a plan on which to click
    std::vector<SurfaceProfile> surfaces{};
    std::size_t kept = 0;  // entries of its history
};

// What is known of a robot's earlier calibrations.
struct CalibrationPast {
    std::vector<ProcedureEntry> last{};      // how each procedure went
    std::size_t kept = 0;                    // entries of its history
    std::vector<SurfaceProfile> surfaces{};  // the floors that it was calibrated on
    // What was found since it was connected: the estimators take it with the next connection, other
    // procedures build on it now.
    std::vector<Calibration> since_connected{};
};

// The operator's work on a robot's parameters: first the list of procedures, then the page of one,
// over the whole window. It asks for what the sensors say, and hands over what came of it; nothing
// counts before the operator accepts.
class CalibrationDesk : public QObject {
    Q_OBJECT

  public:
    explicit CalibrationDesk(QWidget* window);
    ~CalibrationDesk() override;
    void setTheme(const Theme& theme);
    void place();  // over all of the window

    bool open() const;
    bool isAside() const { return aside_; }  // until the operator has clicked on the map
    // Asks which procedure; `last` says how each went, in the order of procedures().
    void choose(const CalibrationSubject& subject, const std::vector<ProcedureEntry>& last = {});
    void take(const std::vector<HeardSensors>& sensors);
    // Why no samples come, "The robot is not heard."; empty where they do.
    void sayLink(const QString& trouble);
    void takeEnds(const ClickedEnds& ends);
    void comeBack();  // from being aside
    void close();     // what was measured is kept

  signals:
    void openChanged();
    void samplesWished(bool wished);
    void historyWished();                               // the list has gone for it
    void endsWished(const hedr::ClickedEnds& earlier);  // the page has gone aside for it
    void concluded(const hedr::CalibrationOutcome& outcome);

  private:
    void start(const QString& procedure);
    void startAgain();
    void leaveRun();
    void showButtons(CalibrationView& view) const;
    void showRun();
    void conclude(bool for_robot);
    void takeEntry(int index, const QString& text);
    void takeTyped();
    PageButton procedureAction() const;
    void takeAction();
    ProcedureSettings settings() const;  // as they were told so far
    void goAside();
    QString surface() const;

    QWidget* window_;
    ProcedureList* list_;
    CalibrationPage* page_;
    CalibrationSubject subject_{};
    const Procedure* procedure_ = nullptr;
    std::unique_ptr<CalibrationRun> run_{};
    bool for_robot_ = false;
    QStringList typed_{};     // in the fields of the page
    QString last_surface_{};  // that was typed, of any calibration
    ClickedEnds clicked_{};
    int marked_ = 0;  // how often it stood at the mark of closed drives
    bool aside_ = false;
    QString link_trouble_{};
};

}  // namespace hedr
