#include "patterns/penrose.h"

#include "patterns/formula.h"

#include <algorithm>
#include <numbers>

namespace rb {

namespace {

constexpr double phi = std::numbers::phi;
constexpr double inverse_phi = phi - 1.0;
/// By which a class keeps away from the values of the next.
constexpr double gap = 1e-6;

double radians(double degrees) { return degrees * pi / 180.0; }
double tangent(double degrees) { return std::tan(radians(degrees)); }
double cosine(double degrees) { return std::cos(radians(degrees)); }
double sine(double degrees) { return std::sin(radians(degrees)); }

Vec2 turned(double degrees, const Vec2& p) {
    const double c = cosine(degrees);
    const double s = sine(degrees);
    return {p.x * c - p.y * s, p.y * c + p.x * s};
}
Vec2 upper(const Vec2& p) { return {p.x, std::abs(p.y)}; }
/// Distance from the line through (x, 0) with the given direction.
double from_line(double degrees, double x, const Vec2& p) {
    return std::abs(sine(degrees) * (p.x - x) - cosine(degrees) * p.y);
}
/// Into the wedge of 36 degrees beside the x axis, by the symmetry of the regular pentagon.
Vec2 folded(Vec2 p) {
    const double radius = glm::length(p);
    p = upper(p);
    if (p.x < radius * cosine(36.0)) p = upper(turned(p.x < radius * cosine(108.0) ? -144.0 : -72.0, p));
    return p;
}
/// Levels of division so that a tile of the largest kind reaches as far as `size`; each makes it `step` times
/// the golden section larger.
int levels(double size, double step) {
    constexpr double most = 1000.0;
    return static_cast<int>(std::clamp(std::ceil(std::log(size) / (step * std::log(phi))), 0.0, most));
}

/// Kites and darts, or the rhombs that come from the same division.
struct KitesAndDarts {
    bool rhombs;

    double kite(Vec2 p, int level) const {
        p = upper(p);
        if (level > 0) {
            if (p.y < (p.x - inverse_phi) * tangent(144.0)) return dart(phi * p, level - 1);
            return kite(phi * turned(108.0, p - Vec2{cosine(36.0), sine(36.0)}), level - 1);
        }
        if (!rhombs) {
            const double d = std::min(from_line(36.0, 0.0, p), from_line(108.0, 1.0, p));
            return std::clamp(0.5 - 2.23 * d, 0.0, 0.5 - gap);
        }
        if (p.y < (p.x - inverse_phi) * tangent(72.0)) {
            const double d = std::min(from_line(72.0, inverse_phi, p), from_line(108.0, 1.0, p));
            return std::max(1.0 - 2.775 * d, 0.5 + gap);
        }
        return std::clamp(0.5 - 2.775 * std::min(p.y, from_line(72.0, inverse_phi, p)), 0.0, 0.5 - gap);
    }

    double dart(Vec2 p, int level) const {
        p = upper(p);
        if (level > 0) {
            if (p.y < (p.x - inverse_phi) * tangent(108.0)) return kite(phi * turned(-36.0, p), level - 1);
            return dart(phi * turned(-144.0, p - Vec2{1.0, 0.0}), level - 1);
        }
        if (rhombs) {
            const double d = std::min(from_line(36.0, 0.0, p), from_line(144.0, 1.0, p));
            return std::clamp(0.5 - 2.775 * d, 0.0, 0.5 - gap);
        }
        return std::max(1.0 - 2.23 * std::min(p.y, from_line(144.0, 1.0, p)), 0.5 + gap);
    }

    /// From the sun of kites around the origin.
    double sun(Vec2 p) const {
        const double size = std::abs(sine(108.0) * p.x - cosine(108.0) * p.y) / cosine(18.0);
        const int n = levels(size, 2.0);
        p *= std::pow(inverse_phi, 2 * n);
        if (n % 2 != 0) p = upper(turned(-36.0, p));
        return kite(p, 2 * n);
    }
};

/// Circumscribed radius and apothem of the pentagon of side 1.
const double outer = 0.5 / sine(36.0);
const double apothem = 0.5 / tangent(36.0);
const double steepness = 5.55 * inverse_phi;
constexpr double inverse_phi_2 = inverse_phi * inverse_phi;

/// Class 1 to 6 and the distance from the tile's edge.
double of_class(int kind, double distance) {
    const double low = kind == 1 ? 0.0 : (kind - 1) / 6.0 + gap;
    return std::clamp((kind - steepness * distance) / 6.0, low, kind / 6.0 - gap);
}

/// Each takes a point relative to its tile and the level of division.
struct Pentagons {
    /// The pentagon whose five neighbours are pentagons.
    static double first(Vec2 p, int level) {
        p = folded(p);
        if (level == 0) return of_class(1, std::abs(p.x - apothem));
        if (p.y < (p.x - apothem) * tangent(54.0) + 0.5) {
            const Vec2 at{p.x - apothem - inverse_phi * outer * cosine(72.0), p.y};
            return second(phi * at, level - 1, false);
        }
        return star(phi * turned(-36.0, p), level - 1);
    }

    /// `quad`: seen from the side where four tiles meet.
    static double second(Vec2 p, int level, bool quad) {
        p = upper(p);
        if (level == 0) return of_class(2, std::abs(folded(p).x - apothem));
        if (quad) {
            if (p.y < (p.x - inverse_phi_2 * outer) * tangent(54.0))
                return first(phi * Vec2{p.x - outer, p.y}, level - 1);
            if (p.y < (p.x - inverse_phi_2 * outer) * tangent(162.0))
                return diamond(phi * Vec2{-p.x, p.y}, level - 1, true);
            const Vec2 at = turned(108.0, p);
            return second(phi * Vec2{at.x + inverse_phi * outer, at.y}, level - 1, true);
        }
        if (p.y < (p.x + outer) * tangent(18.0))
            return diamond(phi * Vec2{p.x + outer - inverse_phi_2 * outer, p.y}, level - 1, false);
        return beside(turned(-36.0, p), level);
    }

    /// `wedge`: cut along its axis of symmetry.
    static double third(Vec2 p, int level, bool wedge) {
        p = upper(p);
        if (level == 0) return of_class(3, std::abs(folded(p).x - apothem));
        const double cut = inverse_phi_2 * outer * cosine(72.0);
        if (wedge && p.x > cut)
            return second(phi * Vec2{-(p.x - cut - inverse_phi * apothem), p.y}, level - 1, true);
        if (!wedge && p.x < outer * cosine(108.0)) {
            const Vec2 at = turned(-144.0, p);
            return second(phi * Vec2{at.x - outer, at.y}, level - 1, false);
        }
        if (!wedge && p.y > (p.x - inverse_phi_2 * outer) * tangent(126.0))
            return beside(turned(36.0, p), level);
        return boat(phi * p, level - 1, wedge);
    }

    static double star(Vec2 p, int level) {
        p = upper(p);
        if (level == 0) return of_class(4, from_line(162.0, phi * outer, p));
        if (p.x < inverse_phi * apothem) return first(phi * p, level - 1);
        return third(phi * Vec2{-(p.x - 2.0 * inverse_phi * apothem), p.y}, level - 1, true);
    }

    static double boat(Vec2 p, int level, bool wedge) {
        p = upper(p);
        if (level == 0) {
            const double waist = std::abs(p.x - inverse_phi * outer * cosine(72.0));
            const Vec2 at = folded({-p.x, p.y});
            return of_class(5, std::min(waist, from_line(162.0, phi * outer, at)));
        }
        if (wedge && p.x > phi * outer * cosine(108.0)) return first(phi * Vec2{-p.x, p.y}, level - 1);
        const Vec2 at = wedge ? p : turned(72.0, p);
        return third(phi * Vec2{at.x + outer, at.y}, level - 1, true);
    }

    static double diamond(Vec2 p, int level, bool pentagon) {
        p = upper(p);
        if (level == 0) return of_class(6, from_line(18.0, -inverse_phi * outer, p));
        return pentagon ? first(phi * p, level - 1) : third(phi * p, level - 1, true);
    }

private:
    /// Into the third pentagon that leans on this tile, as `at` has been turned.
    static double beside(const Vec2& at, int level) {
        return third(phi * Vec2{-at.x - outer * cosine(72.0), at.y - outer * sine(72.0)}, level - 1, false);
    }
};

bool at_centre(double x, double z) { return std::hypot(x, z) <= 1e-10; }

}  // namespace

double penrose_pentagons(double x, double z) {
    if (at_centre(x, z)) return 1.0;
    Vec2 p = folded({x, z});
    const int n = levels(2.0 * p.x * tangent(36.0), 4.0);
    p *= std::pow(inverse_phi, 4 * n);
    return Pentagons::first(p, 4 * n);
}

double penrose_kites(double x, double z) {
    return at_centre(x, z) ? 1.0 : KitesAndDarts{false}.sun(folded({x, z}));
}

double penrose_rhombs(double x, double z) {
    return at_centre(x, z) ? 1.0 : KitesAndDarts{true}.sun(inverse_phi * folded({x, z}));
}

}  // namespace rb
