#pragma once
#include "compile/solids.h"
#include "compile/world.h"

#include <span>

namespace rb {

// Of coincident surfaces the one whose leaf has the lower index is seen.

/// Orders the leaves of one solid (ascending by shape node) so that the one comes first whose hits the
/// reference produces last: a compound that refuses hits turns the list of each child round (spec: geometry
/// 5.3).
void put_seen_first(const SolidForest& solids, uint32_t root, std::span<Leaf> leaves);

/// Moves the leaves of the marked top objects, and their boxes, before all others. `ends`: behind the last
/// leaf of each top object.
void put_first(const std::vector<bool>& marked, std::span<const uint32_t> ends, std::vector<Leaf>& leaves,
               std::vector<Bounds>& boxes);

}  // namespace rb
