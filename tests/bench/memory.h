#pragma once

namespace hedr {

// The largest memory of this process since it began, or since the last call of forgetPeak, and what
// it has now; with the pages of its programs and libraries, in bytes.
double peakMemory_bytes();
double memory_bytes();
void forgetPeak();

}  // namespace hedr
