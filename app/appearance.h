#pragma once

namespace hedr {

class MainWindow;

// Gives the window its looks of the last time, and stores what the operator changes from now on:
// theme, trails, and its place when saveGeometry() is called.
void rememberAppearance(MainWindow& window);
void saveGeometry(const MainWindow& window);

}  // namespace hedr
