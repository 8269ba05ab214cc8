#include "math/chi_square.h"

#include <gtest/gtest.h>

namespace rb {
namespace {

// Tables of the distribution, as printed in any handbook.
TEST(ChiSquare, Quantiles) {
    EXPECT_NEAR(chi_square_quantile(1, 0.95), 3.841458820694124, 1e-12);
    EXPECT_NEAR(chi_square_quantile(2, 0.5), 1.3862943611198906, 1e-12);
    EXPECT_NEAR(chi_square_quantile(3, 0.1), 0.5843743741551833, 1e-12);
    EXPECT_NEAR(chi_square_quantile(10, 0.9), 15.987179172105261, 1e-11);
    EXPECT_NEAR(chi_square_quantile(49, 0.1), 36.81822, 1e-4);
}

}  // namespace
}  // namespace rb
