#pragma once

#include <QImage>
#include <QString>

namespace hedr::test {

// Compares with tests/golden/images/NAME.png. Small differences of antialiasing pass; otherwise the
// picture and a difference image are left in the build folder. HEDR_REFRESH_GOLDEN=1 rewrites.
void expectGolden(const QString& name, const QImage& image);

}  // namespace hedr::test
