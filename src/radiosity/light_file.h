#pragma once
#include "radiosity/gather_quality.h"
#include "radiosity/irradiance_cache.h"
#include "radiosity/outlook.h"
#include "radiosity/surfel_grid.h"

#include <string>

namespace rb {

/// What CachedLight knows, as files hold it.
struct StoredLight {
    uint64_t made_for = 0;                               ///< scene and settings: see CachedLight
    std::vector<std::vector<IrradianceRecord>> records;  ///< by depth
    std::vector<std::vector<SurfelGrid::Cell>> surfels;  ///< likewise; empty if they are not used
    std::vector<Outlook> outlooks;
};

/// Files of a format of our own: "RBLIGHT", its version, the number of bytes that follow, their hash, and
/// the fields of StoredLight in order, lists with their lengths before them. Little-endian, nothing is
/// rounded. Both throw IoError; nothing half-written is left behind.
void write_light(const std::string& path, StoredLight light);
StoredLight read_light(const std::string& path);

}  // namespace rb
