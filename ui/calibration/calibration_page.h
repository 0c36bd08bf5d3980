#pragma once

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWidget>

#include "ui/calibration/calibration_view.h"
#include "ui/theme.h"

namespace hedr {

class EvidenceCard;
class PageHeader;
class ResultCard;
class StepsCard;

// The one page for all calibrations: what to do, the evidence, the result. It shows values and says
// which button was wished for; it may be given new values as often as there are any.
class CalibrationPage : public QWidget {
    Q_OBJECT

  public:
    explicit CalibrationPage(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void show(const CalibrationView& view);
    void focusFirst();  // the one thing to do now

  signals:
    void canceled();
    void primaryRequested();
    void alsoRequested();
    void secondaryRequested();
    void procedureActionRequested();
    void entryEdited(int index, const QString& text);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;  // Esc cancels, Enter does what is next

  private:
    void layOut();
    void showPrimary(const PageButton& state);

    Theme theme_ = dayTheme();
    PageHeader* header_;
    StepsCard* steps_;
    EvidenceCard* evidence_;
    ResultCard* result_;
    QPushButton* cancel_;
    QPushButton* secondary_;
    QPushButton* also_;
    QPushButton* primary_;
    QLabel* promise_;
    QHBoxLayout* cards_;
    QHBoxLayout* buttons_;
    QVBoxLayout* below_header_;
};

}  // namespace hedr
