#include "ui/calibration/calibration_desk.h"

#include <algorithm>
#include <utility>

#include "radio/link/robot_parameters.h"
#include "ui/calibration/calibration_page.h"
#include "ui/calibration/procedure_entries.h"

namespace hedr {

namespace {

constexpr QStringView kHistory = u"history";

QStringList namesOf(const std::vector<SurfaceProfile>& profiles) {
    QStringList names;
    for (const SurfaceProfile& profile : profiles) names << QString::fromStdString(profile.surface);
    return names;
}

QString words(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

std::vector<ProcedureEntry> entriesWith(const std::vector<ProcedureEntry>& last) {
    std::vector<ProcedureEntry> entries;
    for (const Procedure& procedure : procedures()) {
        ProcedureEntry entry{words(procedure.name), words(procedure.title),
                             words(procedure.purpose)};
        const auto before = std::ranges::find(last, entry.procedure, &ProcedureEntry::procedure);
        if (before != last.end()) {
            entry.last = before->last;
            entry.verdict = before->verdict;
        }
        entries.push_back(entry);
    }
    return entries;
}

int stepOf(const Calibration& calibration) {
    const auto next = std::ranges::find(calibration.steps, false, &CalibrationStep::done);
    const auto number = next - calibration.steps.begin() + 1;
    return static_cast<int>(
        std::min<std::ptrdiff_t>(number, static_cast<std::ptrdiff_t>(calibration.steps.size())));
}

}  // namespace

CalibrationDesk::CalibrationDesk(QWidget* window)
    : QObject(window),
      window_(window),
      list_(new ProcedureList(window)),
      page_(new CalibrationPage(window)) {
    page_->hide();
    connect(list_, &ProcedureList::chosen, this, &CalibrationDesk::start);
    connect(list_, &ProcedureList::closeWished, this, &CalibrationDesk::close);
    connect(page_, &CalibrationPage::canceled, this, &CalibrationDesk::close);
    connect(page_, &CalibrationPage::entryEdited, this, &CalibrationDesk::takeEntry);
    connect(page_, &CalibrationPage::procedureActionRequested, this, &CalibrationDesk::takeAction);
    connect(page_, &CalibrationPage::secondaryRequested, this, &CalibrationDesk::startAgain);
    connect(page_, &CalibrationPage::primaryRequested, this, [this] { conclude(false); });
    connect(page_, &CalibrationPage::alsoRequested, this, [this] { conclude(true); });
}

CalibrationDesk::~CalibrationDesk() = default;

void CalibrationDesk::setTheme(const Theme& theme) {
    list_->setTheme(theme);
    page_->setTheme(theme);
}

bool CalibrationDesk::open() const {
    return list_->isVisibleTo(window_) || page_->isVisibleTo(window_);
}

void CalibrationDesk::place() {
    const QSize wanted = list_->sizeHint().boundedTo(window_->size() * 0.9);
    list_->setGeometry(
        {{(window_->width() - wanted.width()) / 2, (window_->height() - wanted.height()) / 2},
         wanted});
    page_->setGeometry(window_->rect());
}

void CalibrationDesk::choose(const CalibrationSubject& subject,
                             const std::vector<ProcedureEntry>& last) {
    subject_ = subject;
    std::vector<ProcedureEntry> entries = entriesWith(last);
    entries.push_back({kHistory.toString(), tr("History"),
                       tr("What was found when: compare, restore, export."),
                       subject.kept == 1 ? tr("1 entry") : tr("%1 entries").arg(subject.kept)});
    list_->show(entries);
    place();
    list_->raise();
    list_->focusFirst();
    emit openChanged();
}

void CalibrationDesk::start(const QString& procedure) {
    if (procedure == kHistory) {
        close();
        emit historyWished();
        return;
    }
    procedure_ = findProcedure(procedure.toStdString());
    if (!procedure_) return;
    list_->hide();
    typed_ = firstTyped(*procedure_, last_surface_);
    startAgain();
    place();
    page_->raise();
    page_->QWidget::show();
    page_->focusFirst();
    emit samplesWished(true);
    emit openChanged();
}

// What may have taken hours is kept, whatever comes of it: it ends its work by itself.
void CalibrationDesk::leaveRun() {
    if (!run_) return;
    CalibrationRun* left = run_.release();
    left->setParent(this);
    disconnect(left, nullptr, this, nullptr);
    // It may be the run that asks for it.
    if (left->concluding() || !left->heardMuch()) return left->deleteLater();
    connect(left, &CalibrationRun::concluded, this,
            [this, left, surface = surface(), robot = subject_.id](CalibrationOutcome outcome) {
                outcome.declined = true;
                outcome.surface = surface;
                outcome.robot = robot;
                emit concluded(outcome);
                left->deleteLater();
            });
    left->conclude();
}

void CalibrationDesk::startAgain() {
    leaveRun();
    marked_ = 0;
    clicked_ = {};
    typed_ = withoutEnds(*procedure_, typed_);
    run_ = std::make_unique<CalibrationRun>(*procedure_, subject_.vehicle);
    connect(run_.get(), &CalibrationRun::changed, this, &CalibrationDesk::showRun);
    connect(run_.get(), &CalibrationRun::concluded, this, [this](CalibrationOutcome outcome) {
        close();
        outcome.for_robot = for_robot_;
        outcome.surface = surface();
        outcome.robot = subject_.id;
        emit concluded(outcome);
    });
    run_->set(settings());
    showRun();
}

void CalibrationDesk::take(const std::vector<HeardSensors>& sensors) {
    if (run_ && !sensors.empty()) run_->add(sensors);
}

void CalibrationDesk::sayLink(const QString& trouble) {
    if (link_trouble_ == trouble) return;
    link_trouble_ = trouble;
    if (run_) showRun();
}

void CalibrationDesk::showRun() {
    if (aside_) return;
    CalibrationView view{.title = words(procedure_->title), .calibration = run_->latest()};
    const auto& steps = view.calibration.steps;
    showSurfaces(view.calibration, subject_.surfaces, surface().toStdString());
    QStringList context{subject_.robot};
    if (!surface().isEmpty()) context << surface();
    if (!steps.empty()) {
        context << tr("step %1 of %2")
                       .arg(stepOf(view.calibration))
                       .arg(static_cast<qsizetype>(steps.size()));
    }
    view.context = context.join(QStringLiteral(" · "));
    view.entries = procedureEntries(*procedure_, typed_, namesOf(subject_.surfaces));
    view.progress_title = link_trouble_;
    showButtons(view);
    page_->show(view);
}

void CalibrationDesk::showButtons(CalibrationView& view) const {
    const bool much = run_->heardMuch();
    view.leave = {much ? tr("Close, and keep the record") : tr("Cancel"), true,
                  much ? tr("No value changes; what was measured is in the robot's history (Esc)")
                       : tr("Leave everything as it was (Esc)")};
    const bool accepted = view.calibration.verdict == Verdict::kAccepted;
    const bool robot_has_them =
        accepted && !robotParametersIn(view.calibration, subject_.vehicle).empty();
    const bool for_robot = robot_has_them && subject_.takes_parameters;
    view.primary = {for_robot ? tr("Accept here only") : tr("Accept"), accepted,
                    !accepted ? QString::fromStdString(view.calibration.reason)
                    : robot_has_them
                        ? tr("The vehicle file takes the new values; the robot keeps its own")
                        : tr("The vehicle file takes the new values")};
    if (for_robot) {
        view.also = {tr("Accept, and write to the robot"), true,
                     tr("The robot takes the new values too: read back, or all as it was")};
    }
    view.procedure_action = procedureAction();
    view.secondary = {tr("Start again"), true,
                      much ? tr("With new samples; those so far are kept in the history")
                           : tr("Forget the samples so far")};
}

void CalibrationDesk::conclude(bool for_robot) {
    for_robot_ = for_robot;
    if (run_) run_->conclude();
}

void CalibrationDesk::takeEntry(int index, const QString& text) {
    while (typed_.size() <= index) typed_ << QString();
    typed_[index] = text;
    takeTyped();
}

void CalibrationDesk::takeTyped() {
    if (procedure_->depends_on_floor) last_surface_ = surface();
    run_->set(settings());
    showRun();
}

QString CalibrationDesk::surface() const { return surfaceTyped(*procedure_, typed_); }

ProcedureSettings CalibrationDesk::settings() const {
    ProcedureSettings settings = settingsTyped(*procedure_, typed_);
    if (marked_ == 0) return settings;
    settings.closed = true;
    settings.distance_m.reset();
    return settings;
}

PageButton CalibrationDesk::procedureAction() const {
    if (takesClosedDrives(*procedure_)) {
        const bool straight_runs = settings().distance_m.has_value();
        return {marked_ == 0 ? tr("It is at its mark") : tr("Back at its mark"), !straight_runs,
                straight_runs ? tr("Not for straight runs: empty their field first")
                              : tr("For closed drives, which need no gyro: press it at the start, "
                                   "and each time the robot stands there again, heading as it "
                                   "began. What came before the start is forgotten.")};
    }
    if (!asksForEnds(*procedure_)) return {};
    return {tr("Click on the map"), subject_.on_plan,
            subject_.on_plan ? tr("Instead of a tape")
                             : tr("Needs a floor plan of true scale on the map (P)")};
}

void CalibrationDesk::takeAction() {
    if (run_->concluding()) return;
    if (!takesClosedDrives(*procedure_)) return goAside();
    ++marked_;
    run_->set(settings());
    run_->mark();
    showRun();
}

void CalibrationDesk::goAside() {
    aside_ = true;
    page_->hide();
    emit openChanged();
    if (clicked_.marks().empty()) clicked_ = ClickedEnds(runsTyped(*procedure_, typed_) + 1);
    emit endsWished(clicked_);
}

void CalibrationDesk::takeEnds(const ClickedEnds& ends) {
    typed_ = withEnds(*procedure_, typed_, clicked_.ends(), ends.ends());
    clicked_ = ends;
    takeTyped();
}

void CalibrationDesk::comeBack() {
    if (!std::exchange(aside_, false)) return;
    showRun();
    page_->raise();
    page_->focusFirst();
    emit openChanged();
}

void CalibrationDesk::close() {
    if (!open() && !aside_) return;
    aside_ = false;
    list_->hide();
    page_->hide();
    if (run_) emit samplesWished(false);
    leaveRun();
    emit openChanged();
}

}  // namespace hedr
