#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <optional>
#include <vector>

#include "ui/panels/card.h"
#include "ui/site/plan_glance.h"

namespace hedr {

// Which page of a file is the plan, and the scale of its paper if that is known.
class PageCard : public Card {
    Q_OBJECT

  public:
    explicit PageCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setFile(const QString& file, const std::vector<QString>& pages);  // the pages' sizes
    void setGlance(const PlanFileWish& page, const PlanGlance& glance);
    void focusFirst();

  signals:
    void chosen(const hedr::PlanFileWish& wish);
    void closeWished();

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void layOut();
    void showPicture(int page);
    void fitToPages();
    void updateButton();
    void choose();

    QLabel* title_;
    QLabel* name_;
    QListWidget* pages_;
    QLabel* scale_label_;
    QLineEdit* scale_;
    QLabel* advice_;
    QPushButton* cancel_;
    QPushButton* open_;
    QString file_{};
    std::vector<QImage> pictures_{};
};

// The scale of a paper as people write it, "1 : 100", "1:100" or "100". None: it is no scale.
std::optional<double> paperScaleOf(const QString& text);

}  // namespace hedr
