// mandel, julia, magnet (manual 3.4.7.1.16): escape time fractals in the xy plane.
#include "patterns/formula.h"

#include <algorithm>
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

class Fractal final : public PointPattern<Fractal> {
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

    double value(const Vec3& p) const {
        const bool from_zero = shape.magnet > 0 && !shape.julia;
        const Complex at{p.x, p.y};
        const Complex c = shape.julia ? shape.seed : at;
        Complex z = from_zero ? Complex{} : at;
        double smallest = from_zero ? 10000.0 : std::norm(z);
        for (int k = 0; k < shape.iterations; ++k) {
            z = next(z, c);
            smallest = std::min(smallest, std::norm(z));
            if (escaped(z)) return outside(z, k);
        }
        return inside(z, smallest);
    }

    const FractalShape shape;

private:
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
