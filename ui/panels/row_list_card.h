#pragma once

#include <vector>

#include "ui/panels/card.h"

namespace hedr {

class RowButton;

// A card with rows to choose from: arrows go from row to row, Enter chooses, Esc leaves.
class RowListCard : public Card {
    Q_OBJECT

  public:
    using Card::Card;
    void focusFirst();

  signals:
    void closeWished();

  protected:
    virtual std::vector<RowButton*> rows() const = 0;  // from above
    virtual void reached(RowButton*) {}                // by an arrow: it may be out of sight
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void moveFocus(int step);
};

}  // namespace hedr
