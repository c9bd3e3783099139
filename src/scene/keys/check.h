#pragma once
// The checks of values by the key table, for files and for descriptions made in memory.

#include "glint/keys.h"

#include <optional>
#include <string>

namespace glint::scene {

/// What is wrong with a value, and what is expected instead (may be empty).
struct KeyFault {
    std::string message;
    std::string hint;
};

/// Is one of the value's numbers infinite, NaN or out of range?
std::optional<KeyFault> number_fault(const KeySpec& key, double x);

/// Is the value wrong as a whole, though each number in it is allowed?
std::optional<KeyFault> value_fault(const KeySpec& key, const KeyValue& value);

/// Both.
std::optional<KeyFault> fault_of(const KeySpec& key, const KeyValue& value);

// ── Checks of several values together ──────────────────────────────────────────────────────────────────────

/// What is said of a material that the scene does not have, with the cure where no other name is near.
KeyFault unknown_material(const std::string& name);

std::optional<KeyFault> view_fault(const CameraDescription& camera);
/// With energy = "balanced".
std::optional<KeyFault> balance_fault(const Material& material);

} // namespace glint::scene
