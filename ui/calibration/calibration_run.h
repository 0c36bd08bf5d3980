#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <vector>

#include "core/calibration/procedures.h"
#include "ui/background_job.h"
#include "ui/calibration/sample_collector.h"
#include "ui/fleet.h"

namespace hedr {

// What came of a calibration, for whoever keeps it.
struct CalibrationOutcome {
    Calibration calibration{};
    ProcedureInput input{};  // the samples it was made of, and the vehicle as it was believed
    bool for_robot = false;  // the robot shall have the values too
    bool declined = false;   // the operator left: nothing is to change, but it is kept
    QString surface{};       // on which it was; may be empty
    RobotId robot = kFirstRobot;
};

// A procedure that looks at all samples so far, again and again while more come in, on a worker.
class CalibrationRun : public QObject {
    Q_OBJECT

  public:
    CalibrationRun(const Procedure& procedure, const Vehicle& believed, QObject* parent = nullptr);

    void add(const std::vector<HeardSensors>& sensors);
    void set(const ProcedureSettings& settings);
    void mark();  // the robot stands at the mark of its closed drives
    const Calibration& latest() const { return latest_; }
    // One last look at all samples, and no more of them, nor of what is told: `concluded` comes.
    void conclude();
    bool concluding() const { return concluding_; }
    bool heardMuch() const;  // more than it costs to hear again

  signals:
    void changed();
    void concluded(const hedr::CalibrationOutcome& outcome);

  private:
    using Stretches = std::vector<std::vector<HeardSensors>>;
    void look();
    void take(Calibration calibration);

    const Procedure& procedure_;
    // The worker's while the job runs, and this thread's otherwise.
    std::shared_ptr<SampleCollector> samples_;
    // Until the job has ended: what was heard before, between and after the marks.
    Stretches waiting_ = Stretches(1);
    ProcedureSettings settings_{};
    int marks_ = 0;             // for the job
    bool looks_again_ = false;  // when the job has ended
    Calibration latest_{};
    std::size_t heard_ = 0;  // readings
    bool concluding_ = false;
    QTimer timer_;
    BackgroundJob job_;
};

}  // namespace hedr
