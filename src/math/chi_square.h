#pragma once

namespace rb {

/// The value that a chi-square variable of `degrees` (1 or more) degrees of freedom stays below with
/// probability `p` in (0, 1).
double chi_square_quantile(int degrees, double p);

}  // namespace rb
