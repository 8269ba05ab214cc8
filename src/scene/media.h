#pragma once
#include "scene/texture.h"

namespace rb {

/// How much of a medium there is, per channel, over space: a pigment whose red, green and blue are factors
/// (manual 3.4.8.3). World space, as far as transformations followed it.
struct Density : Pigment {};
using DensityPtr = std::shared_ptr<const Density>;

/// `density_map`
struct DensityMap {
    BlendMap<PigmentPtr> entries;
};
using DensityMapPtr = std::shared_ptr<const DensityMap>;

struct Scattering {
    int type = 1;  ///< 1 isotropic, 2 and 3 Mie, 4 Rayleigh, 5 Henyey-Greenstein
    Rgb color{0.0f};
    double eccentricity = 0;
    float extinction = 1;
};

/// Something that glows, absorbs or scatters along a ray's way (manual 3.4.8.2). Colours are per unit of the
/// world, whatever the container's size; densities multiply.
struct Media {
    SourceRange where;
    int method = 3;
    int intervals = 1;
    int min_samples = 10;
    int max_samples = 10;
    double confidence = 0.9;
    double variance = 1.0 / 128.0;
    double ratio = 0.9;
    double aa_threshold = 0.1;
    int aa_level = 3;
    double jitter = 0;
    Rgb absorption{0.0f};
    Rgb emission{0.0f};
    Scattering scattering;
    bool collect = true;  ///< photons
    std::vector<DensityPtr> densities;
};
using MediaPtr = std::shared_ptr<const Media>;

/// The same with its densities moved.
MediaPtr transformed(const MediaPtr& media, const Transform& map);
std::vector<MediaPtr> transformed(std::vector<MediaPtr> media, const Transform& map);

}  // namespace rb
