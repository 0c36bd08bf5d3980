#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <vector>

#include "core/calibration/procedures.h"
#include "ui/background_job.h"
#include "ui/calibration/sample_collector.h"

namespace hedr {

// What came of a calibration, for whoever keeps it.
struct CalibrationOutcome {
    Calibration calibration{};
    ProcedureInput input{};  // the samples it was made of, and the vehicle as it was believed
    bool for_robot = false;  // the robot shall have the values too
    QString surface{};       // on which it was; may be empty
};

// A procedure that looks at all samples so far, again and again while more come in, on a worker.
class CalibrationRun : public QObject {
    Q_OBJECT

  public:
    CalibrationRun(const Procedure& procedure, const Vehicle& believed, QObject* parent = nullptr);

    void add(const std::vector<HeardSensors>& sensors);
    void set(const ProcedureSettings& settings);
    const Calibration& latest() const { return latest_; }
    // One last look at all samples, and no more of them: `concluded` comes.
    void conclude();

  signals:
    void changed();
    void concluded(const hedr::CalibrationOutcome& outcome);

  private:
    void look();
    void take(Calibration calibration);

    const Procedure& procedure_;
    // The worker's while the job runs, and this thread's otherwise.
    std::shared_ptr<SampleCollector> samples_;
    std::vector<HeardSensors> waiting_{};  // until the job has ended
    ProcedureSettings settings_{};
    bool looks_again_ = false;  // when the job has ended
    Calibration latest_{};
    bool concluding_ = false;
    QTimer timer_;
    BackgroundJob job_;
};

}  // namespace hedr
