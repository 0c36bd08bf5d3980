#pragma once

// The one way to the TOML library. Its own assertions are wrong: they stop the program at a text
// such as "[+a]", for which it has an error a few lines on.
#define TOML_ASSERT(expression) static_cast<void>(0)
#include <toml++/toml.h>
