#pragma once
#include <span>

namespace rb {

/// Puts the sine of each number in its place: as near to it as std::sin() but for the last bits, and the same
/// bits on every processor.
void sines(std::span<double> values);

}  // namespace rb
