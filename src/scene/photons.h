#pragma once
#include "base/source.h"

#include <cstdint>
#include <string>

namespace rb {

/// Whether photons take a way: what is not said is left to the other side (light or object).
enum class PhotonSwitch : uint8_t { unsaid, on, off };

struct PhotonWays {
    PhotonSwitch refraction = PhotonSwitch::unsaid;
    PhotonSwitch reflection = PhotonSwitch::unsaid;

    friend bool operator==(const PhotonWays&, const PhotonWays&) = default;
};

/// Photons of a light take a way at an object if one of them asks for it and none forbids it.
inline bool photons_pass(PhotonSwitch light, PhotonSwitch object) {
    if (light == PhotonSwitch::off || object == PhotonSwitch::off) return false;
    return light == PhotonSwitch::on || object == PhotonSwitch::on;
}

/// `photons` of a light_source.
struct LightPhotons {
    PhotonWays ways;
    bool from_area = false;  ///< from every sample of an area_light
};

/// `photons` of an object.
struct ObjectPhotons {
    float target = 0;  ///< photons are shot at it, this many times the usual spacing apart; 0: they are not
    PhotonWays ways;
    bool collect = true;        ///< it shows photons
    bool pass_through = false;  ///< on their way to a target photons go straight through it

    friend bool operator==(const ObjectPhotons&, const ObjectPhotons&) = default;
};

/// How far photons are gathered from.
struct PhotonRadius {
    double radius = -1;  ///< world units; not above 0: found out from the density of the photons
    double multiplier = 1;
};

/// `photons` of global_settings.
struct PhotonSettings {
    SourceRange where;
    double spacing = 1;  ///< between photons on a target, world units
    double count = 0;    ///< above 0: the spacing follows from it
    int gather_min = 20;
    int gather_max = 100;
    PhotonRadius surface_radius;
    PhotonRadius media_radius;
    double jitter = 0.4;    ///< of a photon's place, in spacings
    double autostop = 0.5;  ///< share of the greatest angle
    double expand_increase = 0.2;
    double expand_count = 35;
    int media_steps = 0;
    double media_factor = 1;   ///< of the spacing of photons along their way through media
    int max_trace_level = -1;  ///< below 0: the scene's
    double adc_bailout = -1;   ///< below 0: the scene's
    std::string save_file;
    std::string load_file;
};

}  // namespace rb
