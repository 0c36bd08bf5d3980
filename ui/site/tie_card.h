#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <array>

#include "ui/panels/card.h"
#include "ui/site/tie_draft.h"

namespace hedr {

// The card of the tie page: the places with their coordinates, the bearing, and how both agree.
class TieCard : public Card {
    Q_OBJECT

  public:
    explicit TieCard(QWidget* parent);
    void setTheme(const Theme& theme) override;
    // `trouble`: what is wrong with what was typed last; empty: nothing.
    void show(const TieDraft& draft, const TieFit& fit, const QString& trouble);

  signals:
    void placeTyped(std::size_t place, const QString& text);
    void removeWished(std::size_t place);
    void bearingTyped(const QString& text);
    void untieWished();

  private:
    struct Row {
        QLabel* number;
        QLineEdit* field;
        QPushButton* remove;
    };
    Row makeRow(std::size_t place);
    void showRow(std::size_t place, const TieDraft& draft);

    QLabel* state_;
    QLabel* advice_;
    std::array<Row, TieDraft::kMostPlaces> rows_;
    QLabel* bearing_label_;
    QLineEdit* bearing_;
    QPushButton* untie_;
    std::size_t shown_places_ = 0;
};

}  // namespace hedr
