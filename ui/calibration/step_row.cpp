#include "ui/calibration/step_row.h"

#include <QPainter>
#include <QRegularExpression>
#include <QVBoxLayout>

#include "ui/fonts.h"

namespace hedr {
namespace {

constexpr int kCircle_px = 32;
constexpr int kWordsFrom_px = 48;

// A number stays with its unit where the line breaks.
QString unbroken(const std::string& text) {
    static const QRegularExpression kUnit(QStringLiteral("(\\d) (?=\\S{1,3}\\b)"));
    return QString::fromStdString(text).replace(kUnit, QStringLiteral("\\1\u00A0"));
}

QString stateWord(StepRow::State state) {
    switch (state) {
        case StepRow::State::kDone:
            return StepRow::tr("done");
        case StepRow::State::kNow:
            return StepRow::tr("now");
        case StepRow::State::kLater:
            break;
    }
    return StepRow::tr("later");
}

}  // namespace

StepRow::StepRow(int number, QWidget* parent)
    : QWidget(parent), number_(number), title_(new QLabel(this)), detail_(new QLabel(this)) {
    title_->setProperty("role", QStringLiteral("step"));
    detail_->setProperty("role", QStringLiteral("detail"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kWordsFrom_px, 6, 0, 0);
    column->setSpacing(4);
    for (QLabel* label : {title_, detail_}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        column->addWidget(label);
    }
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setMinimumHeight(kCircle_px);
}

void StepRow::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void StepRow::show(const CalibrationStep& step, State state) {
    title_->setText(QString::fromStdString(step.title));
    detail_->setText(unbroken(step.detail));
    state_ = state;
    setAccessibleName(tr("Step %1, %2: %3").arg(number_).arg(stateWord(state), title_->text()));
    setVisible(true);
    update();
}

void StepRow::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF circle(0.0, 0.0, kCircle_px, kCircle_px);
    const bool now = state_ == State::kNow;
    const QColor on_accent = theme_.name == ThemeName::kDay ? theme_.paper : theme_.background;
    painter.setPen(Qt::NoPen);
    painter.setBrush(now ? theme_.accent : theme_.chip);
    painter.drawEllipse(circle);
    painter.setPen(
        QPen(now ? on_accent : theme_.ink, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (state_ == State::kDone) {
        painter.setBrush(Qt::NoBrush);
        painter.drawPolyline(QPolygonF({{11.0, 16.5}, {14.5, 20.0}, {21.0, 12.5}}));
        return;
    }
    painter.setFont(uiFont(15, QFont::DemiBold));
    painter.drawText(circle, Qt::AlignCenter, QString::number(number_));
}

}  // namespace hedr
