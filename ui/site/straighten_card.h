#pragma once

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <optional>

#include "core/site/survey/sheet_aspect.h"
#include "ui/panels/card.h"

namespace hedr {

class FlatPreview;

// The card beside the map while a photo is made flat: what becomes of it, and the sheet's format.
class StraightenCard : public Card {
    Q_OBJECT

  public:
    explicit StraightenCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;

    FlatPreview& preview() { return *preview_; }
    void setVerdict(const QString& text);
    // `aspect`: none, as the photo shows them; `seen`: what it shows, which makes formats likely.
    void setSides(std::optional<double> aspect, const std::optional<SheetAspect>& seen);
    void setStraightenedBefore(bool before);
    void setProgress(std::optional<double> progress);  // 0..1; none: nothing is being computed

  signals:
    void sidesChosen(std::optional<double> longer_by_shorter);
    void photoWished();  // not flat any more

  private:
    FlatPreview* preview_;
    QLabel* verdict_;
    QLabel* sides_label_;
    QComboBox* sides_;
    QProgressBar* bar_;
    QPushButton* photo_;
};

}  // namespace hedr
