#pragma once
// The rows of the key table that say how a scene moves.

#include "formats/key_table.h"

namespace glint {

/// [animation]
TableSpec animation_table();
/// [[animate]]
TableSpec animate_table();

} // namespace glint
