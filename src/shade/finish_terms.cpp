#include "shade/finish_terms.h"

#include "patterns/noise.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// How far metallic tints a highlight: Fresnel curve over the angle, 0 = head on, 1 = grazing.
Rgb metallic_tint(float metallic, double cosine, const Rgb& pigment) {
    const double x = std::acos(std::clamp(cosine, -1.0, 1.0)) / (0.5 * pi);
    const double f = 0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903;
    const auto k = metallic * static_cast<float>(1.0 - std::clamp(f, 0.0, 1.0));
    return Rgb(1.0f) + k * (pigment - Rgb(1.0f));
}

double phong_term(const FinishProgram& f, const LitPlace& place, const Vec3& l) {
    const Vec3 mirror = place.direction - 2.0 * glm::dot(place.direction, place.normal) * place.normal;
    const double c = glm::dot(mirror, l);
    if (c <= f.phong_threshold) return 0.0;
    return f.finish.phong * f.phong_size.of(c);
}

double specular_term(const FinishProgram& f, const LitPlace& place, const Vec3& l) {
    const Vec3 half = l - place.direction;
    const double along = glm::dot(half, place.normal);
    const double square = glm::dot(half, half);
    const double least = f.specular_threshold;
    if (along <= 0.0 || along * along <= least * least * square) return 0.0;
    return f.finish.specular * f.roughness.of(along / std::sqrt(square));
}

}  // namespace

Rgb highlights(const FinishProgram& f, const LitPlace& place, const LightMeeting& light) {
    const Finish& finish = f.finish;
    double highlight = 0;
    if (finish.phong > 0.0f) highlight += phong_term(f, place, light.direction);
    if (finish.specular > 0.0f) highlight += specular_term(f, place, light.direction);
    if (highlight == 0.0) return Rgb(0.0f);
    const Rgb shine = static_cast<float>(highlight) * light.color;
    if (finish.metallic > 0.0f) return shine * metallic_tint(finish.metallic, light.cosine, place.pigment);
    return shine;
}

Rgb iridescence(const FinishProgram& f, const Rgb& wavelength, double thickness, double cosines) {
    const double q = 2.0 * pi * thickness * cosines;
    Rgb factor(1.0f);
    for (int i = 0; i < 3; ++i) {
        factor[i] +=
            f.finish.irid_amount * static_cast<float>(std::cos(q / static_cast<double>(wavelength[i])));
    }
    return factor;
}

double film_thickness(const FinishProgram& f, const Vec3& point, int noise_generator) {
    const double thickness = f.finish.irid_thickness;
    if (f.finish.irid_turbulence == 0.0f) return thickness;
    TurbulenceWarp shape;
    shape.octaves = 5;
    return thickness *
           (1.0 + f.finish.irid_turbulence * (2.0 * turbulence(point, shape, noise_generator) - 1.0));
}

double fresnel_share(double cosine, double relative_ior) {
    const double s = relative_ior * relative_ior + cosine * cosine - 1.0;
    if (!(s > 0.0)) return 1.0;
    const double g = std::sqrt(s);
    const double a = (g - cosine) / (g + cosine);
    const double b = (cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0);
    return std::clamp(0.5 * a * a * (1.0 + b * b), 0.0, 1.0);
}

Reflectivity reflectivity(const FinishProgram& f, double cosine, double relative_ior, const Rgb& pigment) {
    const Reflection& r = f.finish.reflection;
    Reflectivity result;
    if (r.fresnel) {
        const auto k = static_cast<float>(fresnel_share(cosine, relative_ior));
        result.amount = k * r.max + (1.0f - k) * r.min;
        result.importance = std::max({result.amount.x, result.amount.y, result.amount.z});
    } else {
        double x = 1.0 - cosine;
        if (r.falloff != 1.0f) x = std::pow(x, static_cast<double>(r.falloff));
        const auto k = static_cast<float>(x);
        result.amount = k * r.max + (1.0f - k) * r.min;
        result.importance = f.reflection_importance;
    }
    if (r.metallic != 0.0f) result.amount *= metallic_tint(r.metallic, cosine, pigment);
    return result;
}

Vec3 mirrored(const Vec3& d, const Vec3& n, const Vec3& raw_normal) {
    Vec3 v = d - 2.0 * glm::dot(d, n) * n;
    if (glm::dot(v, raw_normal) < 0.0) {
        v = glm::dot(v, n) < 0.0 ? d - 2.0 * glm::dot(d, raw_normal) * raw_normal
                                 : v - 2.0 * glm::dot(v, raw_normal) * raw_normal;
    }
    return glm::normalize(v);
}

}  // namespace rb
