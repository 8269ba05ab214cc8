// Root solvers against 50 decimal digits (Boost.Multiprecision). Failure is defined by backward error, tol
// times the sum of |a_i x^i|: a reported root is false if the polynomial is larger there; a root is missed if
// the signs at two places differ, the polynomial is larger at both, and no root is reported between them.
#include "math/roots.h"
#include "stress.h"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rb::stress {

namespace {

using Exact =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

struct Polynomial {
    std::vector<double> c;       ///< highest first
    std::vector<double> places;  ///< about where its roots lie
    double lo = -1;
    double hi = 1;
};

/// Roots turned to coefficients, rounded once.
Polynomial with_roots(std::vector<double> roots, size_t complex_pairs, Dice& dice) {
    std::vector<Exact> c{1};
    const auto times = [&](const std::vector<Exact>& factor) {
        std::vector<Exact> product(c.size() + factor.size() - 1, Exact(0));
        for (size_t i = 0; i < c.size(); ++i) {
            for (size_t k = 0; k < factor.size(); ++k) product[i + k] += c[i] * factor[k];
        }
        c = product;
    };
    for (const double r : roots) times({1, Exact(-r)});
    for (size_t i = 0; i < complex_pairs; ++i) {
        const Exact re = dice.between(-1, 1);
        const Exact im = dice.scale(1e-9, 1);
        times({1, -2 * re, re * re + im * im});
        roots.push_back(static_cast<double>(re));
    }
    Polynomial p;
    for (const Exact& a : c) p.c.push_back(static_cast<double>(a));
    p.places = std::move(roots);
    return p;
}

Polynomial spread(size_t degree, Dice& dice) {
    const size_t pairs = dice.below(degree / 2 + 1);
    std::vector<double> roots(degree - 2 * pairs);
    for (double& r : roots) r = dice.between(-1.2, 1.2);
    return with_roots(roots, pairs, dice);
}

Polynomial clusters(size_t degree, Dice& dice) {
    std::vector<double> roots(degree);
    const double gap = dice.scale(1e-8, 1e-1);
    for (size_t i = 0; i < degree; ++i) {
        const bool follows = i > 0 && dice.unit() < 0.7;
        roots[i] = follows ? roots[i - 1] + gap * dice.between(0.5, 2) : dice.between(-1, 1);
    }
    return with_roots(roots, 0, dice);
}

/// A double root, torn apart or lifted by a last bits' change of the constant.
Polynomial near_double(size_t degree, Dice& dice) {
    std::vector<double> roots(degree);
    for (double& r : roots) r = dice.between(-1, 1);
    if (degree > 1) roots[1] = roots[0];
    Polynomial p = with_roots(roots, 0, dice);
    p.c.back() += dice.scale(1e-17, 1e-6) * (dice.coin() ? 1 : -1);
    return p;
}

Polynomial huge_ratios(size_t degree, Dice& dice) {
    Polynomial p;
    for (size_t i = 0; i <= degree; ++i) p.c.push_back(dice.scale(1e-12, 1e12) * (dice.coin() ? 1 : -1));
    return p;
}

Polynomial random_coefficients(size_t degree, Dice& dice) {
    Polynomial p;
    for (size_t i = 0; i <= degree; ++i) p.c.push_back(dice.unit() < 0.1 ? 0.0 : dice.between(-1, 1));
    return p;
}

struct Place {
    double x;
    bool negative;
};

struct Value {
    Exact f;
    double magnitude;
};

/// What counts as clear of zero.
struct Measure {
    double tol;
    double least_x;  ///< magnitudes are taken at |x| or here
};

Value value(const Polynomial& p, double x, double least_x = 0) {
    const double size = std::max(std::abs(x), least_x);
    Value v{0, 0.0};
    for (const double a : p.c) {
        v.f = v.f * x + a;
        v.magnitude = v.magnitude * size + std::abs(a);
    }
    return v;
}

bool is_clear(const Polynomial& p, double x, const Measure& measure) {
    const Value v = value(p, x, measure.least_x);
    return abs(v.f) > Exact(measure.tol * v.magnitude);
}

/// Places where the sign is beyond doubt: between the roots, near them, at the ends and anywhere.
std::vector<Place> clear_places(const Polynomial& p, std::span<const double> found, const Measure& measure,
                                Dice& dice) {
    std::vector<double> x{p.lo, p.hi};
    std::vector<double> roots = p.places;
    roots.insert(roots.end(), found.begin(), found.end());
    std::ranges::sort(roots);
    for (size_t i = 0; i + 1 < roots.size(); ++i) x.push_back(0.5 * (roots[i] + roots[i + 1]));
    for (int i = 0; i < 4; ++i) x.push_back(dice.between(p.lo, p.hi));
    for (int i = 0; i < 2; ++i) x.push_back(dice.scale(1e-12, 1) * (dice.coin() ? p.lo : p.hi));
    std::ranges::sort(x);
    std::vector<Place> places;
    for (const double at : x) {
        if (!(at >= p.lo && at <= p.hi)) continue;
        if (is_clear(p, at, measure)) places.push_back({at, value(p, at).f < 0});
    }
    return places;
}

/// `counts_turns`: the solver promises an odd number of roots exactly where the sign changes.
Trial judge(const Polynomial& p, std::span<const double> found, const Measure& measure, bool counts_turns,
            Dice& dice) {
    const auto fail = [&](std::string_view what, double at) {
        return Trial{true, fmt::format("{} at {:.17g} of {:.17g} in [{}, {}], reported {:.17g}", what, at,
                                       fmt::join(p.c, " "), p.lo, p.hi, fmt::join(found, " "))};
    };
    for (size_t i = 0; i < found.size(); ++i) {
        if (!(found[i] >= p.lo && found[i] <= p.hi)) return fail("root outside", found[i]);
        if (i > 0 && found[i] < found[i - 1]) return fail("order", found[i]);
        if (is_clear(p, found[i], measure)) return fail("false root", found[i]);
    }
    const std::vector<Place> places = clear_places(p, found, measure, dice);
    for (size_t i = 0; i + 1 < places.size(); ++i) {
        const auto between =
            std::ranges::count_if(found, [&](double x) { return x >= places[i].x && x <= places[i + 1].x; });
        const bool changes = places[i].negative != places[i + 1].negative;
        if (changes && between == 0) return fail("missed root", places[i].x);
        if (counts_turns && (between % 2 == 1) != changes) return fail("wrong number", places[i].x);
    }
    return {};
}

/// For solvers in double precision over an interval.
Measure over_interval(const Polynomial& p) { return {0x1p-42, std::max(std::abs(p.lo), std::abs(p.hi))}; }
/// For those that are right to the last bits of the coefficients.
Measure local(const Polynomial& p) { return {4.0 * static_cast<double>(p.c.size()) * 0x1p-53, 0.0}; }

Trial try_quadratic(const Polynomial& p, Dice& dice) {
    Polynomial q = p;
    q.lo = -1e300;
    q.hi = 1e300;
    std::array<double, 2> roots{};
    const int n = solve_quadratic(p.c[0], 0.5 * p.c[1], p.c[2], roots);
    q.lo = -10;
    q.hi = 10;
    std::vector<double> found;
    for (int i = 0; i < n; ++i) {
        const double x = roots[static_cast<size_t>(i)];
        if (x >= q.lo && x <= q.hi) found.push_back(x);
    }
    return judge(q, found, local(q), false, dice);
}

template <size_t N>
Trial try_fixed(const Polynomial& p, Dice& dice) {
    std::array<double, N + 1> c;
    std::ranges::copy(p.c, c.begin());
    std::array<double, N> roots{};
    int n = 0;
    if constexpr (N == 3) n = solve_cubic(c, p.lo, p.hi, roots);
    if constexpr (N == 4) n = solve_quartic(c, p.lo, p.hi, roots);
    return judge(p, std::span(roots).first(static_cast<size_t>(n)), over_interval(p), false, dice);
}

template <size_t N>
Trial try_sign_changes(Polynomial p, Dice& dice) {
    p.lo = 0;
    std::array<double, N + 1> c;
    std::ranges::copy(p.c, c.begin());
    std::array<double, N> roots{};
    const int n = sign_changes<N>(c, value(p, 0).f < 0, value(p, 1).f < 0, std::span<double, N>(roots));
    return judge(p, std::span(roots).first(static_cast<size_t>(n)), over_interval(p), true, dice);
}

Trial try_any_degree(const Polynomial& p, Dice& dice) {
    std::vector<double> roots(p.c.size());
    const int n = solve_polynomial(p.c, p.lo, p.hi, roots);
    return judge(p, std::span(roots).first(static_cast<size_t>(n)), local(p), true, dice);
}

/// Where it tells.
Trial try_quickly(const Polynomial& p, Dice& dice) {
    std::vector<double> roots(p.c.size());
    const int n = try_solve_polynomial(p.c, p.lo, p.hi, roots);
    if (n < 0) return Trial::nothing();
    return judge(p, std::span(roots).first(static_cast<size_t>(n)), local(p), true, dice);
}

struct Solver {
    std::string_view name;
    size_t least_degree;
    size_t most_degree;
    Trial (*run)(const Polynomial& p, Dice& dice);
};

void run(const Effort& effort, Table& table) {
    static constexpr std::array<Solver, 10> all{{
        {"quadratic", 2, 2, try_quadratic},
        {"cubic", 3, 3, try_fixed<3>},
        {"quartic", 4, 4, try_fixed<4>},
        {"sign changes, degree 2", 2, 2,
         [](const Polynomial& p, Dice& d) { return try_sign_changes<2>(p, d); }},
        {"sign changes, degree 3", 3, 3,
         [](const Polynomial& p, Dice& d) { return try_sign_changes<3>(p, d); }},
        {"sign changes, degree 4", 4, 4,
         [](const Polynomial& p, Dice& d) { return try_sign_changes<4>(p, d); }},
        {"sign changes, degree 6", 6, 6,
         [](const Polynomial& p, Dice& d) { return try_sign_changes<6>(p, d); }},
        {"any degree, 2 to 8", 2, 8, try_any_degree},
        {"any degree, 9 to 30", 9, 30, try_any_degree},
        {"quickly, degree 2 to 6", 2, 6, try_quickly},
    }};
    struct Kind {
        std::string_view name;
        Polynomial (*make)(size_t degree, Dice& dice);
    };
    static constexpr std::array<Kind, 5> kinds{{{"roots spread", spread},
                                                {"clusters", clusters},
                                                {"near double", near_double},
                                                {"ratios to 1e24", huge_ratios},
                                                {"coefficients", random_coefficients}}};
    for (const Solver& solver : all) {
        for (const Kind& kind : kinds) {
            table.run(fmt::format("{}: {}", solver.name, kind.name), effort.of(2.5e5), [&](Dice& dice) {
                const size_t degree =
                    solver.least_degree + dice.below(solver.most_degree - solver.least_degree + 1);
                return solver.run(kind.make(degree, dice), dice);
            });
        }
    }
}

}  // namespace

const Family solvers{"solvers", "Root solvers against 50 digits", run};

}  // namespace rb::stress
