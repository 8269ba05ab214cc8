#pragma once
#include "photons/photon.h"

#include <string>
#include <vector>

namespace rb {

/// Photons on surfaces and in media, as `save_file` and `load_file` have them.
struct StoredPhotons {
    std::vector<Photon> on_surfaces;
    std::vector<Photon> in_media;

    size_t size() const { return on_surfaces.size() + in_media.size(); }
};

/// Files of POV-Ray 3.7's format (measured): for either kind the number of photons, then 20 bytes for each:
/// place, colour as three bytes with a common exponent, the axis that it splits in a kd-tree, and its
/// direction as two angles in steps of pi/127. All of that is rounded by the format. Empty text if it went
/// well, else what went wrong.
std::string write_photons(const std::string& path, const StoredPhotons& photons);
std::string read_photons(const std::string& path, StoredPhotons& photons);

}  // namespace rb
