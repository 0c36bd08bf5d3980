#include "tests/ui/calibration/samples.h"

#include <cmath>
#include <numbers>

#include "core/geometry/angle.h"

namespace hedr::test {
namespace {

using Shape = EvidenceSeries::Shape;

struct Cluster {
    std::string name;
    Shape shape;
    std::vector<double> x;
    std::vector<double> y;
};

const Cluster kClockwise{"clockwise, 5 runs",
                         Shape::kDots,
                         {0.152, 0.162, 0.184, 0.176, 0.208},
                         {0.121, 0.119, 0.127, 0.107, 0.118}};

Cluster counterClockwise(int runs) {
    Cluster all{"counter-clockwise, " + std::to_string(runs) + " runs",
                Shape::kSquares,
                {0.040, 0.041, 0.035, 0.070, 0.052},
                {-0.157, -0.196, -0.206, -0.194, -0.188}};
    all.x.resize(static_cast<std::size_t>(runs));
    all.y.resize(static_cast<std::size_t>(runs));
    return all;
}

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value / static_cast<double>(values.size());
    return sum;
}

EvidenceSeries ellipseAround(const Cluster& cluster) {
    EvidenceSeries ellipse{.name = cluster.name, .shape = Shape::kEllipse};
    for (int degree = 0; degree < 360; degree += 6) {
        ellipse.x.push_back(mean(cluster.x) + 0.038 * std::cos(radFromDeg(degree)));
        ellipse.y.push_back(mean(cluster.y) + 0.029 * std::sin(radFromDeg(degree)));
    }
    return ellipse;
}

void add(EvidencePlot& plot, const Cluster& cluster) {
    if (cluster.x.empty()) return;
    plot.series.push_back({cluster.name, cluster.shape, cluster.x, cluster.y});
    plot.series.push_back(
        {cluster.name, Shape::kDashes, {0.0, mean(cluster.x)}, {0.0, mean(cluster.y)}});
    if (cluster.x.size() > 2) plot.series.push_back(ellipseAround(cluster));
}

EvidencePlot squaresPlot(int counter_clockwise) {
    EvidencePlot plot{.title = "Where the squares ended (true minus computed)",
                      .x = {"Along the first side", "m"},
                      .y = {"To the left of it", "m"},
                      .same_scale = true};
    add(plot, kClockwise);
    add(plot, counterClockwise(counter_clockwise));
    return plot;
}

std::vector<CalibrationStep> squaresSteps(bool all_done) {
    return {{"Mark the start", "Tape the front and one side of the robot.", true},
            {"Drive 5 squares clockwise", "4 m sides, stop and turn at the corners.", true},
            {"Drive 5 counter-clockwise", "Same square, other direction.", all_done},
            {"Enter where it stopped", "Click on the map or type x and y.", all_done}};
}

Proof squaresProof(double now_m, Interval times) {
    return {.what = "worst return error",
            .unit = "m",
            .parts = 9,
            .before = 0.205,
            .after = now_m,
            .times_better = 0.205 / now_m,
            .times_better_95 = times,
            .times_better_99 = times};
}

// The same numbers on every machine.
double noise(int i) {
    const double x = std::sin(12.9898 * i + 78.233) * 43758.5453;
    const double y = std::sin(39.346 * i + 11.135) * 24634.6345;
    return (x - std::floor(x)) + (y - std::floor(y)) - 1.0;
}

double warmUp(double t_s) {
    return radFromDeg(0.153) * (1.0 - std::exp(-t_s / 338.0)) - radFromDeg(0.264);
}

EvidencePlot warmUpPlot() {
    EvidencePlot plot{.title = "Rate while standing",
                      .x = {"Time since it was switched on", "s"},
                      .y = {"Rate", "rad/s"}};
    EvidenceSeries samples{.name = "gyro", .shape = Shape::kDots};
    EvidenceSeries curve{.name = "model", .shape = Shape::kLine};
    for (int i = 0; i < 12000; ++i) {
        const double t_s = 0.1 * i;
        samples.x.push_back(t_s);
        samples.y.push_back(warmUp(t_s) + 0.004 * noise(i));
        if (i % 100 != 0) continue;
        curve.x.push_back(t_s);
        curve.y.push_back(warmUp(t_s));
    }
    plot.series = {samples, curve};
    return plot;
}

EvidencePlot residualsPlot() {
    EvidencePlot plot{
        .title = "What the model leaves", .x = {"Lag", "s"}, .y = {"Correlation", ""}};
    EvidenceSeries line{.name = "residuals", .shape = Shape::kLine};
    EvidenceSeries band{.name = "where pure noise stays, 95 %", .shape = Shape::kBand};
    for (int i = 1; i <= 60; ++i) {
        line.x.push_back(i);
        line.y.push_back(0.03 * noise(i));
        band.x.push_back(i);
        band.y.push_back(-0.028);
        band.y_high.push_back(0.028);
    }
    plot.series = {band, line};
    return plot;
}

}  // namespace

CalibrationView squaresView(int counter_clockwise) {
    CalibrationView view{.title = "Wheel parameters · squares (UMBmark)",
                         .context = "PackBot 3 · concrete floor · step 2 of 3"};
    view.progress_title = QString("Counter-clockwise run %1 of 5").arg(counter_clockwise);
    view.leave = {"Close, and keep the record"};
    view.primary = {"Accept"};
    view.secondary = {"Start again"};
    view.procedure_action = {"Click on the map"};
    Calibration& calibration = view.calibration;
    calibration.procedure = "wheels_squares";
    calibration.found = {
        {"wheelbase_m", 0.410, {0.5531, 0.0009, 8.0}},
        {"left_wheel_diameter_m", 0.2000, {0.19959, 0.000026, 8.0}},
        {"right_wheel_diameter_m", 0.2000, {0.20041, 0.000026, 8.0}},
    };
    calibration.steps = squaresSteps(false);
    calibration.progress = {0.8, "Known so far: wheelbase ±0.0021 m, wheels ±0.06 mm.",
                            "One more run gives ±0.0017 m and ±0.05 mm."};
    calibration.plots = {squaresPlot(counter_clockwise)};
    calibration.remarks = {"Needs one more run to be accepted."};
    calibration.proof = squaresProof(0.016, {9.0, 17.0});
    calibration.verdict = Verdict::kAccepted;
    calibration.reason = "The part of the data that was held out fits the new values better.";
    return view;
}

CalibrationView decidedView(Verdict verdict) {
    CalibrationView view = squaresView(5);
    view.context = "PackBot 3 · concrete floor · step 3 of 3";
    view.progress_title.clear();
    view.primary = {"Accept", verdict == Verdict::kAccepted};
    Calibration& calibration = view.calibration;
    calibration.steps = squaresSteps(true);
    calibration.progress = {1.0, "Known: wheelbase ±0.0017 m, wheels ±0.05 mm.", ""};
    calibration.remarks.clear();
    calibration.verdict = verdict;
    if (verdict == Verdict::kRefused) {
        calibration.reason = "The part of the data that was held out fits the old values better.";
        calibration.proof = squaresProof(0.312, {0.4, 0.91});
    } else if (verdict == Verdict::kNotProven) {
        calibration.reason = "Too little data could be held out to prove that it is better.";
        calibration.proof.reset();
    } else if (verdict == Verdict::kUnchanged) {
        calibration.reason = "The old values are as good as these samples can tell.";
        calibration.proof = squaresProof(0.204, {0.97, 1.04});
    }
    return view;
}

CalibrationView emptyView() {
    CalibrationView view{.title = "Gyro bias · standing still",
                         .context = "PackBot 3 · concrete floor"};
    view.leave = {"Cancel"};
    view.primary = {"Start", false, "Waits for the robot"};
    Calibration& calibration = view.calibration;
    calibration.steps = {
        {"Let it stand", "Nobody touches the robot for about a minute.", false},
        {"Look at the result", "The vehicle file takes it when it is better.", false}};
    calibration.progress.more = "Waits for the first samples of the gyro.";
    return view;
}

CalibrationView warmUpView() {
    CalibrationView view{.title = "Gyro warm-up", .context = "PackBot 3 · 21 °C · step 1 of 2"};
    view.primary = {"Accept", false};
    view.leave = {"Close, and keep the record"};
    view.secondary = {"Start again"};
    Calibration& calibration = view.calibration;
    const double degree = radFromDeg(1.0);
    calibration.found = {
        {"gyro_drift_c1_rad_s", {}, {0.153 * degree, 0.0021 * degree, 400.0}},
        {"gyro_drift_c2_rad_s", {}, {-0.264 * degree, 0.0018 * degree, 400.0}},
        {"gyro_drift_time_s", {}, {338.0, 11.0, 400.0}},
        {"gyro_bias_rad_s", -0.111 * degree, {0.0, std::nan("")}},
    };
    calibration.figures = {
        {"Drift now", 0.012 * degree, "rad/s", Interval{0.010 * degree, 0.014 * degree}},
        {"Ready in", 340.0, "s"},
        {"Noise of one sample", 0.2 * degree, "rad/s"}};
    calibration.steps = {
        {"Let it stand and warm up", "Do not switch the gyro off.", false},
        {"Look at the result", "The vehicle file takes it when it is better.", false}};
    calibration.progress = {0.41, "Warm-up time known to ±0.4 min.", "6 min more give ±0.2 min."};
    calibration.plots = {warmUpPlot(), residualsPlot(), allanPlot()};
    calibration.remarks = {"The temperature rose by 6 °C.", "The robot stood still all the time."};
    calibration.reason = "Too little data could be held out to prove that it is better.";
    return view;
}

EvidencePlot allanPlot() {
    EvidencePlot plot{.title = "Allan deviation",
                      .x = {"Averaging time", "s", true},
                      .y = {"Deviation of the rate", "rad/s", true}};
    EvidenceSeries band{.name = "95 % confidence", .shape = Shape::kBand};
    EvidenceSeries line{.name = "Allan deviation", .shape = Shape::kLine};
    EvidenceSeries slope{.name = "angle random walk", .shape = Shape::kDashes};
    for (double tau_s = 0.01; tau_s < 4000.0; tau_s *= 2.0) {
        const double white = 5e-5 / std::sqrt(tau_s);
        const double deviation = std::hypot(white, 4e-6, 2e-7 * std::sqrt(tau_s));
        const double spread = 0.05 + 0.3 * std::sqrt(tau_s / 4000.0);
        band.x.push_back(tau_s);
        band.y.push_back(deviation * (1.0 - spread));
        band.y_high.push_back(deviation * (1.0 + spread));
        line.x.push_back(tau_s);
        line.y.push_back(deviation);
        slope.x.push_back(tau_s);
        slope.y.push_back(white);
    }
    plot.series = {band, slope, line};
    return plot;
}

CalibrationView wordyView() {
    CalibrationView view = warmUpView();
    view.title = "Wheel parameters from any drive that was recorded on whatever floor it was";
    view.context =
        "The large blue PackBot with the new tracks · polished concrete with sand · step 12 of 13";
    view.primary = {"Accept and write to the robot"};
    view.secondary = {"Start again with new samples"};
    view.procedure_action = {"Click on the map"};
    view.progress_title = "Counter-clockwise run four of five, on the polished part of the floor";
    Calibration& calibration = view.calibration;
    calibration.found.push_back({"ticks_per_revolution", 35999.994, {36000.1234, 0.0051, 3.0}});
    calibration.found.push_back({"track_width_of_a_robot_from_tomorrow_m", {}, {1.0, 0.5, 3.0}});
    calibration.steps.insert(
        calibration.steps.begin(), 6,
        {"Drive straight along the longest corridor that there is and back again",
         "At least twenty metres, not faster than walking, and without a single turn in between.",
         true});
    calibration.remarks.assign(4, "The robot slipped on 5 % of the way; those samples count less.");
    calibration.proof = {.what = "distance between computed and taped end of the whole drive",
                         .unit = "m",
                         .parts = 6,
                         .before = 12.3,
                         .after = 11.9,
                         .times_better = 1.034,
                         .times_better_95 = {0.94, 1.12},
                         .times_better_99 = {0.9, 1.2}};
    calibration.reason = "The part of the data that was held out does not tell old and new apart.";
    return view;
}

std::vector<ProcedureEntry> procedureEntries() {
    return {
        {"gyro_bias", "Gyro bias", "What the gyro says while it stands still.", "12 Nov, accepted",
         Verdict::kAccepted},
        {"gyro_warm_up", "Gyro warm-up", "How the bias drifts after switching on.",
         "3 Oct, not proven", Verdict::kNotProven},
        {"gyro_allan", "Gyro noise", "How good the gyro is; sets the filters.", {}, {}},
        {"gyro_scale", "Gyro scale", "Whether a full turn is a full turn.", "12 Nov, unchanged",
         Verdict::kUnchanged},
        {"wheels_squares", "Wheels, squares", "Wheelbase and wheels from ten squares.",
         "28 Sep, refused", Verdict::kRefused},
        {"wheels_drive",
         "Wheels, any drive",
         "Wheelbase and wheels from ordinary missions.",
         {},
         {}},
        {"encoders", "Encoder check", "Finds swapped sides, wrong signs, missing magnets.", {}, {}},
        {"compass", "Compass", "Takes the robot's own field out of the compass.", {}, {}}};
}

std::vector<HeardSensors> standingSensors(double begin_s, double seconds, Random& random,
                                          std::uint64_t boot) {
    std::vector<HeardSensors> heard;
    for (double t_s = begin_s; t_s < begin_s + seconds; t_s += 0.02) {
        const double rate_rad_s = radFromDeg(0.9 + 0.1 * random.normal());
        heard.push_back(
            {boot,
             {.robot_time_s = t_s, .odometry = WheelTicks{5, 5}, .gyro = GyroRate{rate_rad_s}}});
    }
    return heard;
}

}  // namespace hedr::test
