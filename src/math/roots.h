#pragma once
#include <array>
#include <cstddef>
#include <span>

namespace rb {

/// Real roots of a x^2 + 2 half_b x + c, ascending; returns their number (a double root counts once). Linear
/// when a is 0. The discriminant is compensated (Kahan) and the small root comes from the product of the
/// roots, so nothing cancels.
int solve_quadratic(double a, double half_b, double c, std::span<double, 2> roots);

/// The distinct real roots of a polynomial (highest power first) in [lo, hi], ascending, and no more than the
/// first `most`; returns their number. The interval is cut until Bernstein coefficients or the roots of the
/// derivative isolate each root, then a bracketed Newton iteration runs to the last bits, so no simple root
/// is lost. Shift and scale first: coefficients and interval should be about 1.
int solve_cubic(const std::array<double, 4>& c, double lo, double hi, std::span<double, 3> roots,
                int most = 3);
int solve_quartic(const std::array<double, 5>& c, double lo, double hi, std::span<double, 4> roots,
                  int most = 4);

/// The places in [lo, hi] where a polynomial of any degree up to most_degree (highest power first) changes
/// its sign, ascending; a place where it comes near zero without a change of sign is no root. `roots` has
/// room for the degree. Each side of 0 is scaled to (0, 1], where power and Bernstein coefficients lose least
/// to each other, and halved until the signs of the Bernstein coefficients change once or not at all
/// (Descartes' rule; Eigenwillig 2008). What double precision cannot tell is told with twice as many bits
/// (`Twofold`): then roots that the coefficients themselves tell apart are found, though a change of a
/// coefficient's last bit may turn a close pair to none.
constexpr size_t most_degree = 36;
int solve_polynomial(std::span<const double> c, double lo, double hi, std::span<double> roots);

/// The same for polynomials up to degree 6, quickly; -1 where double precision or a few halvings of the
/// interval cannot tell.
int try_solve_polynomial(std::span<const double> c, double lo, double hi, std::span<double> roots);

/// True if the polynomial changes its sign within [lo, hi]: as the above, without asking where.
bool changes_sign(const std::array<double, 4>& c, double lo, double hi);
bool changes_sign(const std::array<double, 5>& c, double lo, double hi);

/// Where a polynomial of degree N = 1 to 6 (highest power first) changes its sign between 0 and 1,
/// ascending; returns their number. The signs at 0 and 1 are given, and their number agrees with them: so
/// pieces of a curve that share an end and its sign have together neither a gap nor a double root there.
template <size_t N>
int sign_changes(const std::array<double, N + 1>& c, bool negative_at_0, bool negative_at_1,
                 std::span<double, N> roots);

/// A radius that holds all real roots (Cauchy's bound), for callers without an interval. Leading zeros are
/// skipped.
double root_bound(std::span<const double> coefficients);

}  // namespace rb
