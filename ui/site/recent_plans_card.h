#pragma once

#include <QLabel>
#include <QStringList>
#include <QVBoxLayout>
#include <vector>

#include "ui/panels/row_list_card.h"
#include "ui/site/plan_glance.h"

namespace hedr {

class PlanRow;

// The plans that were open before, the newest first, and the way to others.
class RecentPlansCard : public RowListCard {
    Q_OBJECT

  public:
    explicit RecentPlansCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setFiles(const QStringList& files);
    void setGlance(const QString& file, const PlanGlance& glance);

  signals:
    void fileChosen(const QString& file);
    void anotherWished();

  protected:
    std::vector<RowButton*> rows() const override;

  private:
    PlanRow* addRow(const QString& icon, const QString& name, const QString& detail);
    void fitToRows();

    QLabel* title_;
    QVBoxLayout* column_;
    QStringList files_{};
    std::vector<PlanRow*> rows_{};  // one of each file, and the last for another
};

}  // namespace hedr
