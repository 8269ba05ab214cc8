// Constants, float and vector functions.
#include "language/builtins.h"

#include "language/float_functions.h"
#include "language/read.h"
#include "patterns/noise.h"

#include <chrono>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace rb {

namespace {

int32_t bits(double value) { return static_cast<int32_t>(whole_part(value)); }

void want(std::span<const Operand> arguments, size_t least, size_t most, SourceRange where) {
    if (arguments.size() < least) {
        throw SceneError({where.file, where.end - 1, where.end},
                         "Expected 'numeric expression', ) found instead");
    }
    if (arguments.size() > most) {
        throw SceneError(arguments[most].where, "Expected ')', numeric expression found instead");
    }
}

Value real(double value) { return Terms{{value}, 1}; }
Value vector(const Vec3& v) { return Terms{{v.x, v.y, v.z}, 3}; }

const ObjectPtr& to_object(const Operand& operand) {
    if (const auto* thing = std::get_if<Thing>(&operand.value)) {
        if (const auto* object = std::get_if<ObjectPtr>(thing)) return *object;
    }
    throw SceneError(operand.where, "Object identifier expected.");
}

GeometryOracle& oracle(const Session& session, std::string_view name, SourceRange where) {
    if (!session.options.oracle) {
        session.fail(where,
                     fmt::format("'{}' needs the geometry of the scene, which is not available here.", name));
    }
    return *session.options.oracle;
}

double now_days() {
    using namespace std::chrono;
    constexpr double seconds_to_2000 = 946684800.0;
    const auto since = duration_cast<microseconds>(system_clock::now().time_since_epoch()).count();
    return (static_cast<double>(since) * 1e-6 - seconds_to_2000) / 86400.0;
}

double call_real1(Session& session, Keyword word, double a, SourceRange where) {
    switch (word) {
        case Keyword::acos:
        case Keyword::asin:
            if (std::abs(a) > 1) {
                session.warn(where, fmt::format("Domain error in {}.", keyword_spellings[word_of(word)]));
                a = a > 0 ? 1 : -1;
            }
            break;
        case Keyword::ln:
        case Keyword::log:
            if (a <= 0) {
                session.fail(where,
                             fmt::format("{} of negative number {:f}", keyword_spellings[word_of(word)], a));
            }
            break;
        case Keyword::sqrt:
            if (a < 0) session.fail(where, fmt::format("sqrt of negative number {:f}", a));
            break;
        case Keyword::seed:
            return static_cast<double>(session.random.open(a));
        case Keyword::rand:
            if (!session.random.known(a)) {
                throw SceneError(where, "Illegal random number generator.",
                                 "rand() takes what seed() gave: #declare R = seed(1); ... rand(R)");
            }
            return session.random.next(static_cast<size_t>(a));
        default:
            break;
    }
    const auto value = float_function(word, a);
    if (!value) session.fail(where, "Unknown function");
    return *value;
}

double call_real2(Session& session, Keyword word, double a, double b, SourceRange where) {
    if (word == Keyword::atan2 && std::abs(a) <= 1e-10 && std::abs(b) <= 1e-10) {
        session.fail(where, "Domain error in atan2!");
    }
    if (word == Keyword::pow && a == 0 && b == 0)
        throw SceneError(where, "Domain error.", "0 to the power of 0 is not defined");
    return float_function(word, a, b).value_or(0);
}

double call_list(Keyword word, std::span<const Operand> arguments) {
    double value = to_float(arguments[0]);
    for (size_t i = 1; i < arguments.size(); ++i) {
        const double next = to_float(arguments[i]);
        switch (word) {
            case Keyword::min:
                value = std::min(value, next);
                break;
            case Keyword::max:
                value = std::max(value, next);
                break;
            case Keyword::bitwise_and:
                value = bits(value) & bits(next);
                break;
            case Keyword::bitwise_or:
                value = bits(value) | bits(next);
                break;
            default:
                value = bits(value) ^ bits(next);
                break;
        }
    }
    if (arguments.size() == 1 && word != Keyword::min && word != Keyword::max) value = bits(value);
    return value;
}

Vec3 rotate_about_axis(const Vec3& a, const Vec3& axis, double degrees) {
    const Vec3 n = glm::normalize(axis);
    const double angle = degrees * pi / 180;
    return a * std::cos(angle) + glm::cross(n, a) * std::sin(angle) +
           n * glm::dot(n, a) * (1 - std::cos(angle));
}

Value call_trace(Session& session, std::span<const Operand> arguments, SourceRange where) {
    want(arguments, 3, 4, where);
    const ObjectPtr& object = to_object(arguments[0]);
    const auto hit =
        oracle(session, "trace", where).trace(object, to_vec3(arguments[1]), to_vec3(arguments[2]));
    if (arguments.size() == 4) {
        const Place& place = arguments[3].place;
        if (!place.known()) session.fail(arguments[3].where, "Expected 'vector identifier'");
        place.value() = vector(hit ? hit->normal : Vec3{0.0});
    }
    return vector(hit ? hit->point : Vec3{0.0});
}

Value call_extent(Session& session, Keyword word, const Operand& operand, SourceRange where) {
    if (const auto* thing = std::get_if<Thing>(&operand.value)) {
        if (std::holds_alternative<PigmentPtr>(*thing)) {
            session.fail(where, "The size of an image_map pigment is not available yet.");
        }
    }
    const ObjectPtr& object = to_object(operand);
    const Bounds bounds =
        oracle(session, word == Keyword::max_extent ? "max_extent" : "min_extent", where).extent(object);
    Vec3 corner = word == Keyword::max_extent ? bounds.hi : bounds.lo;
    for (double* v : {&corner.x, &corner.y, &corner.z}) {
        // Adding 0 turns -0 into 0.
        *v = static_cast<double>(static_cast<float>(std::clamp(*v, -1e10, 1e10))) + 0.0;
    }
    return vector(corner);
}

Value call_vector(Session& session, Keyword word, std::span<const Operand> a, SourceRange where) {
    switch (word) {
        case Keyword::vdot:
            want(a, 2, 2, where);
            return real(glm::dot(to_vec3(a[0]), to_vec3(a[1])));
        case Keyword::vlength:
            return real(glm::length(to_vec3(a[0])));
        case Keyword::vcross:
            want(a, 2, 2, where);
            return vector(glm::cross(to_vec3(a[0]), to_vec3(a[1])));
        case Keyword::vnormalize: {
            const Vec3 v = to_vec3(a[0]);
            if (glm::dot(v, v) == 0) {
                session.warn(where, "Normalizing zero-length vector.");
                return vector(v);
            }
            return vector(v / glm::length(v));
        }
        case Keyword::vrotate:
            want(a, 2, 2, where);
            return vector(Transform::rotation_deg(to_vec3(a[1])).point(to_vec3(a[0])));
        case Keyword::vaxis_rotate:
            want(a, 3, 3, where);
            return vector(rotate_about_axis(to_vec3(a[0]), to_vec3(a[1]), to_float(a[2])));
        default: {
            want(a, 4, 4, where);
            const int octaves = static_cast<int>(std::clamp(whole_part(to_float(a[2])), 1.0, 10.0));
            TurbulenceWarp shape;
            shape.octaves = octaves;
            shape.lambda = static_cast<float>(to_float(a[0]));
            shape.omega = static_cast<float>(to_float(a[1]));
            return vector(vector_turbulence(to_vec3(a[3]), shape));
        }
    }
}

Value call_select(std::span<const Operand> a, SourceRange where) {
    want(a, 3, 4, where);
    const double test = to_float(a[0]);
    if (test < 0) return a[1].value;
    if (a.size() == 3) return a[2].value;
    return test == 0 ? a[2].value : a[3].value;
}

Value call_dimensions(Keyword word, std::span<const Operand> a, SourceRange where) {
    if (a.empty() || !std::holds_alternative<ArrayPtr>(a[0].value)) {
        throw SceneError(a.empty() ? where : a[0].where,
                         fmt::format("Expected 'array identifier', {} found instead",
                                     a.empty() ? ")" : kind_name(a[0].value)));
    }
    const Array& array = *std::get<ArrayPtr>(a[0].value);
    if (word == Keyword::dimensions) return real(static_cast<double>(array.sizes.size()));
    want(a, 2, 2, where);
    const double index = std::floor(to_float(a[1])) - 1;
    if (!(index >= 0 && index < static_cast<double>(array.sizes.size()))) return real(0);
    return real(static_cast<double>(array.sizes[static_cast<size_t>(index)]));
}

}  // namespace

int component_index(Keyword word) {
    switch (word) {
        case Keyword::x:
        case Keyword::u:
        case Keyword::red:
            return 0;
        case Keyword::y:
        case Keyword::v:
        case Keyword::green:
            return 1;
        case Keyword::z:
        case Keyword::blue:
            return 2;
        case Keyword::t:
        case Keyword::filter:
        case Keyword::alpha:
            return 3;
        case Keyword::transmit:
            return 4;
        default:
            return -1;
    }
}

Terms constant_value(const Session& session, Keyword word) {
    switch (word) {
        case Keyword::pi_:
            return {{pi}, 1};
        case Keyword::true_:
        case Keyword::yes:
        case Keyword::on:
            return {{1}, 1};
        case Keyword::x:
            return {{1, 0, 0}, 3};
        case Keyword::y:
            return {{0, 1, 0}, 3};
        case Keyword::z:
            return {{0, 0, 1}, 3};
        case Keyword::t:
            return {{0, 0, 0, 1}, 4};
        case Keyword::u:
            return {{1, 0}, 2};
        case Keyword::v:
            return {{0, 1}, 2};
        case Keyword::clock:
            return {{static_cast<double>(static_cast<float>(session.options.clock))}, 1};
        case Keyword::clock_on:
            return {{session.options.clock_on ? 1.0 : 0.0}, 1};
        case Keyword::version:
            return {{session.language_version / 100.0}, 1};
        case Keyword::now:
            return {{now_days()}, 1};
        default:
            return {{0}, 1};
    }
}

Value call_builtin(Session& session, Keyword word, std::span<const Operand> a, SourceRange where) {
    switch (word) {
        case Keyword::atan2:
        case Keyword::div:
        case Keyword::mod:
        case Keyword::pow:
            want(a, 2, 2, where);
            return real(call_real2(session, word, to_float(a[0]), to_float(a[1]), where));
        case Keyword::min:
        case Keyword::max:
        case Keyword::bitwise_and:
        case Keyword::bitwise_or:
        case Keyword::bitwise_xor:
            return real(call_list(word, a));
        case Keyword::select:
            return call_select(a, where);
        case Keyword::vdot:
        case Keyword::vlength:
        case Keyword::vcross:
        case Keyword::vnormalize:
        case Keyword::vrotate:
        case Keyword::vaxis_rotate:
        case Keyword::vturbulence:
            return call_vector(session, word, a, where);
        case Keyword::dimensions:
        case Keyword::dimension_size:
            return call_dimensions(word, a, where);
        case Keyword::inside: {
            want(a, 2, 2, where);
            const ObjectPtr& object = to_object(a[0]);
            if (!oracle(session, "inside", where).has_inside(object)) {
                session.fail(a[0].where, "Solid object identifier expected.");
            }
            return real(oracle(session, "inside", where).inside(object, to_vec3(a[1])) ? 1 : 0);
        }
        case Keyword::trace:
            return call_trace(session, a, where);
        case Keyword::min_extent:
        case Keyword::max_extent:
            return call_extent(session, word, a[0], where);
        case Keyword::asc:
        case Keyword::val:
        case Keyword::strlen:
        case Keyword::strcmp:
        case Keyword::file_exists:
        case Keyword::chr:
        case Keyword::concat:
        case Keyword::str:
        case Keyword::vstr:
        case Keyword::substr:
        case Keyword::strupr:
        case Keyword::strlwr:
        case Keyword::datetime:
            return call_text(session, word, a, where);
        default:
            return real(call_real1(session, word, to_float(a[0]), where));
    }
}

void check_argument_count(const Function& function, size_t count, SourceRange where) {
    const auto wanted = static_cast<size_t>(function.parameter_count());
    if (count < wanted) throw SceneError(where, "Expected 'numeric expression', ) found instead");
    if (count > wanted) throw SceneError(where, "Expected ')', numeric expression found instead");
}

Value call_value(const Operand& callee, std::span<const Operand> arguments, Keyword spline_type,
                 SourceRange where) {
    if (const auto* spline = std::get_if<SplinePtr>(&callee.value)) {
        want(arguments, 1, 1, where);
        SplineKind kind = (*spline)->kind;
        if (spline_type == Keyword::linear_spline) kind = SplineKind::linear;
        if (spline_type == Keyword::quadratic_spline) kind = SplineKind::quadratic;
        if (spline_type == Keyword::cubic_spline) kind = SplineKind::cubic;
        if (spline_type == Keyword::natural_spline) kind = SplineKind::natural;
        const Spline::Point point = (*spline)->at(to_float(arguments[0]), kind);
        Terms out;
        out.v = point;
        out.count = (*spline)->result_count();
        return out;
    }
    const FunctionPtr& function = std::get<FunctionPtr>(std::get<Thing>(callee.value));
    check_argument_count(*function, arguments.size(), where);
    std::vector<double> values;
    for (const Operand& argument : arguments) values.push_back(to_float(argument));
    Terms out;
    out.count = function->result_count();
    try {
        function->evaluate(values, {out.v.data(), static_cast<size_t>(out.count)});
    } catch (const SceneError& error) {
        Diagnostic diagnostic = error.diagnostic();
        if (diagnostic.where.known()) {
            diagnostic.notes.push_back({Severity::note, diagnostic.where, "in the function, here", {}});
        }
        diagnostic.where = where;
        throw SceneError(std::move(diagnostic));
    }
    return out;
}

void decode_srgb(Session& session, WrittenColor& color, SourceRange where) {
    const auto& gamma = session.scene.settings.assumed_gamma;
    if (!gamma) session.fail(where, "Cannot parse sRGB colors before assumed_gamma has been set.");
    const auto* power = std::get_if<double>(&*gamma);
    if (!power) return;
    if (color.base.count == 1) {
        const double value = color.base.v[0];
        color.base = {{value, value, value, value, value}, color.word_terms};
    }
    // Single precision, as the reference.
    const float exponent = 1 / static_cast<float>(*power);
    for (size_t i = 0; i < 3; ++i) {
        double& v = color.base.v[i];
        v = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        if (exponent != 1)
            v = std::pow(static_cast<double>(static_cast<float>(v)), static_cast<double>(exponent));
    }
}

}  // namespace rb
