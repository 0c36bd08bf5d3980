#pragma once

#include <string>

namespace hedr {

// A number as it is said: that many significant digits, but all before the point, no zeros at the
// end ("0.2", "0.0031", "123"); an exponent only where nobody would read the digits ("1e+300"); "?"
// for what is no number.
std::string shortNumber(double value, int significant_digits = 2);

// "0.27 %", of 0.0027, kept on one line.
std::string percentText(double share);

}  // namespace hedr
