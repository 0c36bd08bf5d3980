#pragma once

#include <QAbstractButton>
#include <QGridLayout>
#include <QImage>
#include <QLabel>
#include <QProgressBar>
#include <QWidget>
#include <optional>
#include <vector>

#include "ui/theme.h"

namespace hedr {

class RowArea;

struct Choice {
    QImage picture;
    QString caption;
};

// A picture with its caption that can be chosen.
class ChoiceButton : public QAbstractButton {
    Q_OBJECT

  public:
    ChoiceButton(const Choice& choice, QWidget* parent);
    void setTheme(const Theme& theme);
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QImage picture_;
    Theme theme_ = dayTheme();
};

// Says what was found and offers it in pictures; shows how far the search is meanwhile.
class ChoicesPanel : public QWidget {
    Q_OBJECT

  public:
    // Of the pictures, in logical pixels.
    static constexpr QSize kPicture{134, 101};

    explicit ChoicesPanel(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void setProgress(double share);  // 0..1: being searched for
    void setFound(const QString& verdict, const std::vector<Choice>& choices);
    void setChosen(std::optional<std::size_t> choice);

  signals:
    void chosen(std::size_t choice);

  private:
    Theme theme_ = dayTheme();
    QLabel* verdict_;
    QProgressBar* progress_;
    QWidget* pictures_;
    RowArea* area_;
    QGridLayout* grid_;
    std::vector<ChoiceButton*> buttons_{};
};

}  // namespace hedr
