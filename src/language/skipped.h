#pragma once
#include "block/reader.h"

namespace rb {

/// Leaves out the next item of a block that is not drawn yet. A file that it names (`png "wood.png"`) is
/// looked up all the same, so that a missing one is said.
void skip_item(BlockReader& in);

}  // namespace rb
