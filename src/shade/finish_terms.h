#pragma once
#include "shade/texture_program.h"

namespace rb {

/// A lit place, as the formulas of a finish see it. All vectors unit, world space.
struct LitPlace {
    Vec3 normal{0.0};     ///< perturbed, turned towards the viewer
    Vec3 direction{0.0};  ///< of the arriving ray
    Rgb pigment{0.0f};
    float opacity = 1;
    double irid_thickness = 0;  ///< after turbulence
};

/// How a light meets a surface.
struct LightMeeting {
    Vec3 direction{0.0};  ///< unit, towards the light
    double cosine = 0;    ///< between it and the normal of the place
    Rgb color{0.0f};      ///< after attenuation and shadow
    double crand = 0;     ///< what crand takes off the diffuse intensity
    bool backside = false;
    bool highlights = true;  ///< false for shadowless lights
};

/// Highlights alone.
Rgb highlights(const FinishProgram& finish, const LitPlace& place, const LightMeeting& light);

/// Diffuse light and highlights (manual 3.4.6.3.3-5; Phong 1975, Blinn 1977), before iridescence.
inline Rgb reflected_light(const FinishProgram& f, const LitPlace& place, const LightMeeting& light) {
    Rgb sum(0.0f);
    const float diffuse = light.backside ? f.finish.diffuse_back : f.finish.diffuse;
    if (diffuse > 0.0f) {
        const double intensity =
            f.brilliance.of(std::abs(light.cosine)) * diffuse * place.opacity - light.crand;
        sum = static_cast<float>(intensity) * place.pigment * light.color;
    }
    if (!f.has_highlights || !light.highlights || light.backside) return sum;
    return sum + highlights(f, place, light);
}

/// Factor of a thin film for the sum of the two cosines (manual 3.4.6.3.8).
Rgb iridescence(const FinishProgram& finish, const Rgb& wavelength, double thickness, double cosines);

/// Film thickness at a point.
double film_thickness(const FinishProgram& finish, const Vec3& point, int noise_generator);

/// Share of unpolarized light that a boundary reflects, for the cosine between way and normal; 1 under total
/// reflection.
double fresnel_share(double cosine, double relative_ior);

/// Light that a mirror returns, as a factor, and how much the mirrored ray matters.
struct Reflectivity {
    Rgb amount{0.0f};
    float importance = 0;
};

/// `cosine`: between the normal and the direction to the viewer; `relative_ior` is used with fresnel only.
Reflectivity reflectivity(const FinishProgram& finish, double cosine, double relative_ior,
                          const Rgb& pigment);

/// `d` mirrored about `n`, kept on the outer side of the real surface.
Vec3 mirrored(const Vec3& d, const Vec3& n, const Vec3& raw_normal);

}  // namespace rb
