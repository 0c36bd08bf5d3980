#pragma once

#include <QFileDialog>

#include "ui/theme.h"

namespace hedr {

// What a dialog for a file to be written says.
struct SaveQuestion {
    QString title;
    QString kind;      // "GeoTIFF"
    QString suffix;    // ".tif"
    QString proposal;  // path of a file
};

// Asks where a file is to be written. The name gets its suffix before Qt asks whether a file that
// is there may be replaced.
class SaveDialog : public QFileDialog {
    Q_OBJECT

  public:
    SaveDialog(const SaveQuestion& question, const Theme& theme, QWidget* parent = nullptr);

  protected:
    void accept() override;

  private:
    QString suffix_;
};

}  // namespace hedr
