#pragma once

#include <QPushButton>

#include "ui/calibration/calibration_view.h"

namespace hedr {

inline void showButton(QPushButton& button, const PageButton& state) {
    button.setText(state.text);
    button.setToolTip(state.tip);
    button.setEnabled(state.enabled);
    button.setVisible(!state.text.isEmpty());
}

}  // namespace hedr
