#pragma once
#include "block/reader.h"

namespace rb {

/// Leaves out the next item of a block that is not drawn yet. A file that it names (`png "wood.png"`) is
/// looked up all the same; a missing one is an error, as in the reference.
void skip_item(BlockReader& in);

}  // namespace rb
