// mandel, julia, magnet (manual 3.4.7.1.16): escape time fractals in the xy plane.
#include "patterns/formula.h"
#include "patterns/quad.h"

#include <algorithm>
#include <array>
#include <complex>

namespace rb {

namespace {

using Complex = std::complex<double>;

struct FractalShape {
    int magnet = 0;  ///< 0: z^exponent + c; 1, 2: the magnet formulas
    bool julia = false;
    Complex seed{0.0, 0.0};
    int iterations = 1;
    int exponent = 2;
    int exterior = 1;
    double exterior_factor = 1;
    int interior = 0;
    double interior_factor = 1;
};

Complex power(const Complex& z, int exponent) {
    Complex result = z;
    for (int i = 1; i < exponent; ++i) result *= z;
    return result;
}

/// Without the scaling of std::complex, whose other rounding fifty iterations make visible.
Complex quotient(const Complex& a, const Complex& b) {
    const double size = b.real() * b.real() + b.imag() * b.imag();
    return {(a.real() * b.real() + a.imag() * b.imag()) / size,
            (a.imag() * b.real() - a.real() * b.imag()) / size};
}

/// Where an orbit ended: after `steps` steps it escaped, or it was followed to the last of them.
struct OrbitEnd {
    Complex z;
    int steps = 0;
    double smallest = 0;  ///< norm on the way
};

/// Watches for an orbit to come back to the very same numbers: from then on it repeats itself for ever. Looks
/// at every `stride`th step only, at a distance from a place that moves on (Brent's rule).
class CycleWatch {
public:
    static constexpr int stride = 64;

    bool is_due(int step) const { return step % stride == stride - 1; }
    /// How many steps the place is back.
    int distance(int step) const { return step - at_; }
    /// True if the place has to be moved to `step`.
    bool moves_on(int step) {
        if (step - at_ < window_) return false;
        at_ = step;
        window_ *= 2;
        return true;
    }

private:
    int at_ = -1;
    int64_t window_ = stride;
};

constexpr size_t lanes = 8;

/// Orbits of z^2 + c side by side.
struct Squares {
    std::array<double, lanes> x;
    std::array<double, lanes> y;
    std::array<double, lanes> cx;
    std::array<double, lanes> cy;
    std::array<OrbitEnd, lanes> ends;
};

RB_INLINE void step_square(Quad& x, Quad& y, const Quad& cx, const Quad& cy) {
    const Quad re = x * x - y * y;
    const Quad im = x * y + y * x;
    x = re + cx;
    y = im + cy;
}

template <class Lanes>
RB_INLINE bool any(const Lanes& a, const Lanes& b) {
    const auto both = a | b;
    return (both[0] | both[1] | both[2] | both[3]) != 0;
}

/// The same bits as one by one.
RB_FOR_EACH_TARGET void follow(Squares& orbits, int iterations) {
    Quad x[2], y[2], cx[2], cy[2], smallest[2], from_x[2], from_y[2];
    for (size_t h = 0; h < 2; ++h) {
        load(&orbits.x[4 * h], x[h]);
        load(&orbits.y[4 * h], y[h]);
        load(&orbits.cx[4 * h], cx[h]);
        load(&orbits.cy[4 * h], cy[h]);
        smallest[h] = x[h] * x[h] + y[h] * y[h];
        from_x[h] = x[h];
        from_y[h] = y[h];
    }
    CycleWatch watch;
    unsigned done = 0;
    constexpr unsigned all = (1u << lanes) - 1;
    const auto end = [&](unsigned lane, int steps) RB_INLINED {
        const size_t h = lane / 4;
        orbits.ends[lane] = {{x[h][lane % 4], y[h][lane % 4]}, steps, smallest[h][lane % 4]};
        done |= 1u << lane;
    };
    for (int k = 0; k < iterations && done != all; ++k) {
        decltype(x[0] > 4.0) escaped[2];
        for (size_t h = 0; h < 2; ++h) {
            step_square(x[h], y[h], cx[h], cy[h]);
            const Quad norm = x[h] * x[h] + y[h] * y[h];
            smallest[h] = norm < smallest[h] ? norm : smallest[h];
            escaped[h] = norm > 4.0;
        }
        if (any(escaped[0], escaped[1])) {
            for (unsigned lane = 0; lane < lanes; ++lane) {
                if (escaped[lane / 4][lane % 4] != 0 && !(done >> lane & 1)) end(lane, k);
            }
        }
        if (!watch.is_due(k)) continue;
        for (unsigned lane = 0; lane < lanes; ++lane) {
            const size_t h = lane / 4;
            const unsigned i = lane % 4;
            if (done >> lane & 1 || x[h][i] != from_x[h][i] || y[h][i] != from_y[h][i]) continue;
            Quad last_x = x[h];
            Quad last_y = y[h];
            for (int left = (iterations - 1 - k) % watch.distance(k); left > 0; --left)
                step_square(last_x, last_y, cx[h], cy[h]);
            end(lane, iterations);
            orbits.ends[lane].z = {last_x[i], last_y[i]};
        }
        if (!watch.moves_on(k)) continue;
        for (size_t h = 0; h < 2; ++h) {
            from_x[h] = x[h];
            from_y[h] = y[h];
        }
    }
    for (unsigned lane = 0; lane < lanes; ++lane) {
        if (!(done >> lane & 1)) end(lane, iterations);
    }
}

class Fractal final : public Pattern {
public:
    explicit Fractal(const FractalShape& chosen) : shape(chosen) {}
    std::string_view keyword() const override {
        return shape.magnet > 0 ? "magnet" : (shape.julia ? "julia" : "mandel");
    }
    bool takes_default_map() const override { return shape.exponent == 2; }
    std::string describe() const override {
        return fmt::format("{} {} {} <{},{}> {} exponent {} exterior {},{} interior {},{}", keyword(),
                           shape.magnet, shape.julia, shape.seed.real(), shape.seed.imag(), shape.iterations,
                           shape.exponent, shape.exterior, shape.exterior_factor, shape.interior,
                           shape.interior_factor);
    }

    void evaluate(const PatternContext&, std::span<const Vec3> points,
                  std::span<double> values) const override {
        const bool of_squares = shape.magnet == 0 && shape.exponent == 2;
        // Fewer are followed one by one in about that time.
        constexpr size_t fewest = 3;
        size_t i = 0;
        for (; of_squares && i + fewest <= points.size(); i += lanes) {
            const size_t n = std::min(lanes, points.size() - i);
            follow_squares(points.subspan(i, n), values.subspan(i, n));
        }
        for (; i < points.size(); ++i) values[i] = value(end_of(points[i]));
    }

    const FractalShape shape;

private:
    void follow_squares(std::span<const Vec3> points, std::span<double> values) const {
        Squares orbits;
        for (size_t k = 0; k < lanes; ++k) {
            const Vec3& p = points[std::min(k, points.size() - 1)];
            orbits.x[k] = p.x;
            orbits.y[k] = p.y;
            orbits.cx[k] = shape.julia ? shape.seed.real() : p.x;
            orbits.cy[k] = shape.julia ? shape.seed.imag() : p.y;
        }
        follow(orbits, shape.iterations);
        for (size_t k = 0; k < points.size(); ++k) values[k] = value(orbits.ends[k]);
    }
    OrbitEnd end_of(const Vec3& p) const {
        const bool from_zero = shape.magnet > 0 && !shape.julia;
        const Complex at{p.x, p.y};
        const Complex c = shape.julia ? shape.seed : at;
        OrbitEnd end;
        end.z = from_zero ? Complex{} : at;
        end.smallest = from_zero ? 10000.0 : std::norm(end.z);
        CycleWatch watch;
        Complex from = end.z;
        for (; end.steps < shape.iterations; ++end.steps) {
            const int k = end.steps;
            end.z = next(end.z, c);
            end.smallest = std::min(end.smallest, std::norm(end.z));
            if (escaped(end.z)) return end;
            if (!watch.is_due(k)) continue;
            if (end.z == from) {
                for (int left = (shape.iterations - 1 - k) % watch.distance(k); left > 0; --left)
                    end.z = next(end.z, c);
                end.steps = shape.iterations;
                return end;
            }
            if (watch.moves_on(k)) from = end.z;
        }
        return end;
    }
    double value(const OrbitEnd& end) const {
        return end.steps < shape.iterations ? outside(end.z, end.steps) : inside(end.z, end.smallest);
    }
    Complex next(const Complex& z, const Complex& c) const {
        if (shape.magnet == 0) return power(z, shape.exponent) + c;
        Complex ratio;
        if (shape.magnet == 1) {
            ratio = quotient(z * z + c - 1.0, 2.0 * z + c - 2.0);
        } else {
            const Complex product = (c - 1.0) * (c - 2.0);
            ratio = quotient(z * z * z + 3.0 * (c - 1.0) * z + product,
                             3.0 * z * z + 3.0 * (c - 2.0) * z + product + 1.0);
        }
        return ratio * ratio;
    }
    bool escaped(const Complex& z) const {
        if (shape.magnet == 0) return std::norm(z) > 4.0;
        return std::norm(z) > 10000.0 || std::norm(z - 1.0) < 1.0 / 10000.0;
    }
    double outside(const Complex& z, int k) const {
        const double f = shape.exterior_factor;
        switch (shape.exterior) {
            case 0:
                return f;
            case 2:
                return z.real() * f;
            case 3:
                return z.imag() * f;
            case 4:
                return z.real() * z.real() * f;
            case 5:
                return z.imag() * z.imag() * f;
            case 6:
                return std::abs(z) * f;
            case 7:
                return k % std::max(1, static_cast<int>(f)) / f;
            case 8:
                return k % std::max(1, static_cast<int>(1.0 + f)) / f;
            default:
                return static_cast<double>(k) / shape.iterations;
        }
    }
    double inside(const Complex& z, double smallest) const {
        const double f = shape.interior_factor;
        switch (shape.interior) {
            case 1:
                return std::sqrt(smallest) * f;
            case 2:
                return z.real() * f;
            case 3:
                return z.imag() * f;
            case 4:
                return z.real() * z.real() * f;
            case 5:
                return z.imag() * z.imag() * f;
            case 6:
                return z.real() * z.real() + z.imag() * z.imag() * f;
            default:
                return f;
        }
    }
};

FractalShape read_seed(BlockReader& in, bool julia, int magnet) {
    FractalShape shape;
    shape.magnet = magnet;
    shape.julia = julia;
    if (julia) {
        const Vec2 seed = in.vec2();
        shape.seed = {seed.x, seed.y};
    }
    shape.iterations = std::max(1, in.integer());
    return shape;
}

PatternPtr read_mandel(BlockReader& in) { return std::make_shared<Fractal>(read_seed(in, false, 0)); }
PatternPtr read_julia(BlockReader& in) { return std::make_shared<Fractal>(read_seed(in, true, 0)); }
PatternPtr read_magnet(BlockReader& in) {
    const SourceRange at = in.where();
    const int kind = in.integer();
    const bool julia = in.take_word("julia");
    if (!julia && !in.take_word("mandel"))
        in.fail(fmt::format("Expected 'mandel', {} found instead", in.found()));
    if (kind != 1 && kind != 2) {
        in.fail_at(at, fmt::format("Invalid magnet-{} pattern type found. Valid types are 1 and 2.",
                                   julia ? "julia" : "mandel"));
    }
    return std::make_shared<Fractal>(read_seed(in, julia, kind));
}

PatternPtr read_parameter(BlockReader& in, const PatternPtr& so_far) {
    FractalShape shape = static_cast<const Fractal&>(*so_far).shape;
    const SourceRange at = in.where();
    if (shape.magnet == 0 && in.take_word("exponent")) {
        shape.exponent = in.integer();
        if (shape.exponent < 2 || shape.exponent > 33) {
            in.diagnostics().warning(at, "Invalid exponent (range is 2 to 33). Using 2.");
            shape.exponent = 2;
        }
    } else if (in.take_word("exterior")) {
        shape.exterior = in.integer();
        shape.exterior_factor = in.number();
        if (shape.exterior < 0 || shape.exterior > 8) in.fail_at(at, "Invalid fractal exterior type.");
    } else if (in.take_word("interior")) {
        shape.interior = in.integer();
        shape.interior_factor = in.number();
        if (shape.interior < 0 || shape.interior > 6) in.fail_at(at, "Invalid fractal interior type.");
    } else {
        return nullptr;
    }
    return std::make_shared<Fractal>(shape);
}

ColorMap mandel_map() {
    constexpr Color black{0, 0, 0, 0, 0};
    constexpr Color cyan{0, 1, 1, 0, 0};
    return {
        {0.001f, black}, {0.001f, cyan}, {0.012f, {1, 1, 0, 0, 0}}, {0.015f, {1, 0, 1, 0, 0}}, {0.1f, cyan}};
}

}  // namespace

namespace patterns {
extern const PatternKind mandel;
const PatternKind mandel{.keyword = "mandel",
                         .read = read_mandel,
                         .read_parameter = read_parameter,
                         .default_map = mandel_map,
                         .example = "mandel 25"};
extern const PatternKind julia;
const PatternKind julia{.keyword = "julia",
                        .read = read_julia,
                        .read_parameter = read_parameter,
                        .example = "julia <0.353, 0.288>, 30"};
extern const PatternKind magnet;
const PatternKind magnet{.keyword = "magnet",
                         .read = read_magnet,
                         .read_parameter = read_parameter,
                         .example = "magnet 1 mandel 20"};
}  // namespace patterns

}  // namespace rb
