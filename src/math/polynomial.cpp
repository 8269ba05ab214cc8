// Roots of polynomials of any degree; roots.cpp has the fast ones of low degree. See solve_polynomial() in
// roots.h.
#include "math/bernstein.h"
#include "math/quick_roots.h"
#include "math/roots.h"
#include "math/twofold.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace rb {

namespace {

/// Power coefficients, lowest first, of a polynomial to be looked at over (0, 1].
struct Powers {
    std::array<double, most_degree + 1> c;  ///< the first degree + 1
    size_t degree = 0;

    Powers() {}  // NOLINT(modernize-use-equals-default): no need to fill the array
    /// Of what there is: mostly a few numbers.
    Powers(const Powers& other) : degree(other.degree) {
        std::copy_n(other.c.begin(), degree + 1, c.begin());
    }
    Powers& operator=(const Powers&) = delete;
};

/// binomials[n][k]: all are exact.
constexpr auto binomials = [] {
    std::array<std::array<double, most_degree + 1>, most_degree + 1> table{};
    for (size_t n = 0; n <= most_degree; ++n) {
        table[n][0] = 1.0;
        for (size_t k = 1; k <= n; ++k) table[n][k] = table[n - 1][k - 1] + table[n - 1][k];
    }
    return table;
}();

/// True if the polynomial of degree N (highest power first) surely has no root in [0, 1].
template <size_t N>
bool misses_unit(const double* c) {
    std::array<double, N + 1> powers;
    double magnitude = 0.0;
#pragma GCC unroll 16
    for (size_t k = 0; k <= N; ++k) {
        powers[k] = c[k];
        magnitude += std::abs(c[k]);
    }
    const std::array<double, N + 1> b = bernstein_over_unit(powers);
    double least = b[0];
    double most = b[0];
#pragma GCC unroll 8
    for (size_t k = 1; k <= N; ++k) {
        least = std::min(least, b[k]);
        most = std::max(most, b[k]);
    }
    const double margin = 4.0 * static_cast<double>(N + 5) * 0x1p-53 * magnitude;
    return least > margin || most < -margin;
}

constexpr size_t quick_degree = 10;
constexpr auto misses_unit_of_degree = []<size_t... N>(std::index_sequence<N...>) {
    return std::array{&misses_unit<N>...};
}
(std::make_index_sequence<quick_degree + 1>());

/// The same for parts of [-1, 1] that are not empty; false in doubt.
bool misses(std::span<const double> c, double lo, double hi) {
    if (c.empty() || c.size() > quick_degree + 1 || lo < -1.0 || hi > 1.0) return false;
    const size_t degree = c.size() - 1;
    const auto unit = misses_unit_of_degree[degree];
    const auto misses_negative_unit = [&] {
        std::array<double, quick_degree + 1> mirrored;
        for (size_t i = 0; i <= degree; ++i) mirrored[i] = (degree - i) % 2 ? -c[i] : c[i];
        return unit(mirrored.data());
    };
    return (hi <= 0.0 || unit(c.data())) && (lo >= 0.0 || misses_negative_unit());
}

/// The sign at x, from as many bits as it needs.
bool is_negative_at(const Powers& p, double x) {
    if (x == 0.0 && p.c[0] != 0.0) return p.c[0] < 0.0;
    double f = p.c[p.degree];
    double magnitude = std::abs(f);
    for (size_t i = p.degree; i-- > 0;) {
        f = f * x + p.c[i];
        magnitude = magnitude * std::abs(x) + std::abs(p.c[i]);
    }
    if (std::abs(f) > 2.0 * static_cast<double>(p.degree + 1) * 0x1p-53 * magnitude) return f < 0.0;
    Twofold g(p.c[p.degree]);
    for (size_t i = p.degree; i-- > 0;) g = g * Twofold(x) + Twofold(p.c[i]);
    return is_negative(g);
}

/// Roots in [0, 1], isolated with numbers of type Real.
template <class Real>
class UnitRoots {
public:
    UnitRoots(const Powers& p, std::span<double> roots) : p_(p), roots_(roots) {
        double magnitude = 0.0;
        for (size_t i = 0; i <= p_.degree; ++i) magnitude += std::abs(p_.c[i]);
        margin_ = 4.0 * static_cast<double>(p_.degree + 4) * unit_rounding * magnitude;
    }

    /// The roots between `from` and `to`, both in [0, 1]; false if the numbers are not precise enough to
    /// tell.
    bool search(double from, double to) {
        Coefficients b = over_unit();
        if (to < 1.0) b = cut(b, Real(to)).left;
        if (from > 0.0) b = cut(b, Real(from) / to).right;
        return search(b, end(from), end(to), most_levels);
    }
    /// All those in [0, 1] if there is surely none or one; else false.
    bool search_few() {
        const Coefficients b = over_unit();
        if (all_beyond_margin(b)) return true;
        const Signs found = signs(b, end(0.0), end(1.0));
        if (!found.sure || found.changes > 1) return false;
        if (found.changes == 1) add(root_between(end(0.0), end(1.0)));
        return true;
    }
    size_t count() const { return count_; }

private:
    using Coefficients = std::array<Real, most_degree + 1>;
    static constexpr bool is_double = std::is_same_v<Real, double>;
    static constexpr double unit_rounding = is_double ? 0x1p-53 : 0x1p-103;
    static constexpr int most_levels = is_double ? 40 : 100;

    struct End {
        double x;
        bool negative;
    };

    End end(double x) const { return {x, is_negative_at(p_, x)}; }

    /// Bernstein coefficients over [0, 1]: of all intervals this one loses least, since the powers begin at
    /// 0.
    Coefficients over_unit() const {
        Coefficients b;
        const auto& choose = binomials[p_.degree];
        for (size_t k = 0; k <= p_.degree; ++k) b[k] = Real(p_.c[k]) / choose[k];
        for (size_t k = 1; k <= p_.degree; ++k) {
            for (size_t i = p_.degree; i >= k; --i) b[i] = b[i] + b[i - 1];
        }
        return b;
    }

    struct Parts {
        Coefficients left;
        Coefficients right;
    };
    /// De Casteljau at the share r.
    Parts cut(const Coefficients& b, const Real& r) const {
        const Real rest = Real(1.0) + Real(-1.0) * r;
        return cut_by(b, [&](const Real& a, const Real& c) { return rest * a + r * c; });
    }
    Parts halve(const Coefficients& b) const {
        return cut_by(b, [](const Real& a, const Real& c) { return half(a + c); });
    }
    template <class Mix>
    Parts cut_by(const Coefficients& b, Mix&& mix) const {
        Parts parts;
        parts.right = b;
        parts.left[0] = b[0];
        for (size_t k = 1; k <= p_.degree; ++k) {
            for (size_t i = 0; i + k <= p_.degree; ++i)
                parts.right[i] = mix(parts.right[i], parts.right[i + 1]);
            parts.left[k] = parts.right[0];
        }
        return parts;
    }

    struct Signs {
        int changes;
        bool sure;   ///< no sign but those of the ends could be rounding
        bool noise;  ///< all could
    };
    Signs signs(const Coefficients& b, const End& lo, const End& hi) const {
        Signs found{0, true, true};
        bool negative = lo.negative;
        for (size_t i = 1; i < p_.degree; ++i) {
            const bool clear = size_of(b[i]) > margin_;
            found.sure = found.sure && clear;
            found.noise = found.noise && !clear;
            found.changes += is_negative(b[i]) != negative ? 1 : 0;
            negative = is_negative(b[i]);
        }
        found.changes += hi.negative != negative ? 1 : 0;
        return found;
    }

    /// True if all are surely of one sign: no root.
    bool all_beyond_margin(const Coefficients& b) const {
        size_t above = 0;
        size_t below = 0;
        for (size_t i = 0; i <= p_.degree; ++i) {
            const double v = static_cast<double>(b[i]);
            above += v > margin_ ? 1 : 0;
            below += v < -margin_ ? 1 : 0;
        }
        return std::max(above, below) > p_.degree;
    }

    bool search(const Coefficients& b, const End& lo, const End& hi, int levels) {
        const auto [changes, sure, noise] = signs(b, lo, hi);
        if (sure && changes == 0) return true;
        const double x = 0.5 * (lo.x + hi.x);
        const bool cannot_tell = (noise && p_.degree > 1) || levels == 0 || !(x > lo.x && x < hi.x);
        if (is_double && cannot_tell && !(sure && changes == 1)) return false;
        if ((sure && changes == 1) || cannot_tell) {
            if (lo.negative != hi.negative) add(root_between(lo, hi));
            return true;
        }
        const Parts parts = halve(b);
        const End middle = end(x);
        return search(parts.left, lo, middle, levels - 1) && search(parts.right, middle, hi, levels - 1);
    }

    /// Newton's iteration, kept in the bracket, to the last bits.
    double root_between(const End& lo, const End& hi) const {
        double a = lo.x;
        double b = hi.x;
        double x = 0.5 * (a + b);
        double before = b - a;
        constexpr int most = 200;
        for (int i = 0; i < most; ++i) {
            Real f(p_.c[p_.degree]);
            double slope = 0.0;
            for (size_t k = p_.degree; k-- > 0;) {
                slope = slope * x + static_cast<double>(f);
                f = f * Real(x) + Real(p_.c[k]);
            }
            const auto miss = static_cast<double>(f);
            if (miss == 0.0) return x;
            ((miss < 0.0) == lo.negative ? a : b) = x;
            double next = x - miss / slope;
            if (!(next > a && next < b) || std::abs(next - x) > 0.5 * before) next = 0.5 * (a + b);
            before = std::abs(next - x);
            if (!(next > a && next < b) || before <= std::numeric_limits<double>::epsilon() * std::abs(next))
                return next;
            x = next;
        }
        return x;
    }

    void add(double x) {
        if (count_ < roots_.size()) roots_[count_++] = x;
    }

    const Powers& p_;
    std::span<double> roots_;
    size_t count_ = 0;
    double margin_ = 0;  ///< of the coefficients' rounding
};

size_t roots_between(const Powers& p, double from, double to, std::span<double> roots) {
    UnitRoots<double> quick(p, roots);
    if (quick.search(from, to)) return quick.count();
    UnitRoots<Twofold> precise(p, roots);
    precise.search(from, to);
    return precise.count();
}

/// Roots of p between `from` and `to`, both in [0, 1], in any order. Octave after octave is scaled to end at
/// 1 (exactly), so that small roots are seen as well as large ones.
size_t unit_roots(Powers p, double from, double to, std::span<double> roots) {
    size_t count = 0;
    double scale = 1.0;
    while (from < to) {
        const size_t before = count;
        UnitRoots<double> few(p, roots.subspan(count));
        if (few.search_few()) {
            if (few.count() == 1 && roots[before] >= from && roots[before] <= to)
                roots[count++] = scale * roots[before];
            break;
        }
        if (to > 0.5) count += roots_between(p, std::max(from, 0.5), to, roots.subspan(count));
        for (size_t i = before; i < count; ++i) roots[i] *= scale;
        double power = 1.0;
        for (size_t i = 0; i <= p.degree; ++i) {
            p.c[i] *= power;
            power *= 0.5;
        }
        from *= 2.0;
        to = std::min(2.0 * to, 1.0);
        scale *= 0.5;
        if (scale == 0.0) break;
    }
    return count;
}

/// True if no product of them overflows and what underflows does not matter.
bool are_moderate(std::span<const double> c) {
    constexpr double least = 0x1p-200;
    constexpr double most = 0x1p200;
    return std::ranges::all_of(c, [](double a) {
        const double size = std::abs(a);
        return a == 0.0 || (size >= least && size <= most);
    });
}

/// p(sign 2^exponent u), divided by a power of two so that its largest coefficient is about 1: exact.
Powers scaled(std::span<const double> c, double sign, int exponent) {
    Powers out;
    out.degree = c.size() - 1;
    constexpr int most_shift = 200;
    if (std::abs(exponent) * static_cast<int>(out.degree) <= most_shift && are_moderate(c)) {
        const double step = sign * std::ldexp(1.0, exponent);
        double power = 1.0;
        for (size_t i = 0; i <= out.degree; ++i) {
            out.c[i] = power * c[out.degree - i];
            power *= step;
        }
        return out;
    }
    int largest = std::numeric_limits<int>::min();
    for (size_t i = 0; i <= out.degree; ++i) {
        const double a = c[out.degree - i];
        if (a != 0.0) largest = std::max(largest, std::ilogb(a) + exponent * static_cast<int>(i));
    }
    double power = 1.0;
    for (size_t i = 0; i <= out.degree; ++i) {
        const double a = c[out.degree - i];
        double small = std::ldexp(a, exponent * static_cast<int>(i) - largest);
        // What underflows keeps its sign: at 0 the first of all decides.
        if (small == 0.0 && a != 0.0) small = std::copysign(std::numeric_limits<double>::min(), a);
        out.c[i] = power * small;
        power *= sign;
    }
    return out;
}

template <size_t N>
int try_solve(const double* c, double lo, double hi, std::span<double> roots) {
    std::array<double, N + 1> own;
    std::copy_n(c, N + 1, own.begin());
    const auto count = quick_roots_between<N>(own, lo, hi, roots.first<N>());
    return count ? static_cast<int>(*count) : -1;
}

}  // namespace

int try_solve_polynomial(std::span<const double> c, double lo, double hi, std::span<double> roots) {
    constexpr double far = 1e3;  // there the powers cancel
    if (!(lo < hi && lo > -far && hi < far)) return -1;
    switch (c.size()) {
        case 3:
            return try_solve<2>(c.data(), lo, hi, roots);
        case 4:
            return try_solve<3>(c.data(), lo, hi, roots);
        case 5:
            return try_solve<4>(c.data(), lo, hi, roots);
        case 6:
            return try_solve<5>(c.data(), lo, hi, roots);
        case 7:
            return try_solve<6>(c.data(), lo, hi, roots);
        default:
            return -1;
    }
}

int solve_polynomial(std::span<const double> c, double lo, double hi, std::span<double> roots) {
    if (lo < hi && misses(c, lo, hi)) return 0;
    while (!c.empty() && c.front() == 0.0) c = c.subspan(1);
    size_t at_zero = 0;
    while (!c.empty() && c.back() == 0.0) {
        c = c.first(c.size() - 1);
        ++at_zero;
    }
    if (c.empty() || !(lo < hi)) return 0;
    const bool all_finite = std::ranges::all_of(c, [](double a) { return std::isfinite(a); });
    if (!all_finite || !std::isfinite(lo) || !std::isfinite(hi)) return 0;
    size_t count = 0;
    std::array<double, most_degree> found;
    // Either side of 0 is scaled into [0, 1] by a power of two.
    const auto side = [&](double sign, double near, double far) {
        if (!(far > 0.0) || c.size() < 2) return size_t{0};
        int exponent = std::ilogb(far);
        if (std::ldexp(1.0, exponent) < far) ++exponent;
        const Powers p = scaled(c, sign, exponent);
        const double from = std::ldexp(std::max(near, 0.0), -exponent);
        const size_t n = unit_roots(p, from, std::ldexp(far, -exponent), found);
        for (size_t i = 0; i < n; ++i) found[i] = std::ldexp(found[i], exponent);
        std::sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(n));
        for (size_t i = 0; i < n; ++i) found[i] *= sign;
        return n;
    };
    const size_t below = side(-1.0, -hi, -lo);
    for (size_t i = below; i-- > 0;) roots[count++] = found[i];
    if (at_zero % 2 == 1 && lo <= 0.0 && hi >= 0.0 && count < roots.size()) roots[count++] = 0.0;
    const size_t above = side(1.0, lo, hi);
    for (size_t i = 0; i < above && count < roots.size(); ++i) roots[count++] = found[i];
    return static_cast<int>(count);
}

}  // namespace rb
