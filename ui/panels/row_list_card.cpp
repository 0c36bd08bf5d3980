#include "ui/panels/row_list_card.h"

#include <QKeyEvent>
#include <algorithm>

#include "ui/panels/row_button.h"

namespace hedr {

void RowListCard::focusFirst() {
    const auto all = rows();
    if (!all.empty()) all.front()->setFocus();
}

void RowListCard::moveFocus(int step) {
    const auto all = rows();
    if (all.empty()) return;
    const auto focused = std::ranges::find_if(all, &QWidget::hasFocus);
    const auto last = static_cast<int>(all.size()) - 1;
    const auto at = static_cast<int>(focused - all.begin());
    RowButton* row = all.at(static_cast<std::size_t>(std::clamp(at + step, 0, last)));
    row->setFocus();
    reached(row);
}

void RowListCard::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Up:
            return moveFocus(-1);
        case Qt::Key_Down:
            return moveFocus(1);
        case Qt::Key_Return:
        case Qt::Key_Enter:
            for (RowButton* row : rows()) {
                if (row->hasFocus()) return row->click();
            }
            return;
        case Qt::Key_Escape:
            emit closeWished();
            return;
        default:
            Card::keyPressEvent(event);
    }
}

}  // namespace hedr
