#pragma once

#include "preprocess/base/file_io.hpp"
#include "tests/support/gltf_builder.hpp"

#include <set>
#include <string>

namespace edgeshade::test {

/// Violations in glTF's JSON of the structural rules that Khronos' validator treats as errors: an
/// index of nothing, a range past its end, a missing required field, an empty array. Each is
/// "where: what", without values, so that two files can be compared. Independent of the code in
/// `preprocess`; takes JSON of any shape.
std::set<std::string> structuralFaults(const Json& json);

/// The same for a GLB that contains all its buffers, and for its container.
std::set<std::string> structuralFaults(const Bytes& glb);

} // namespace edgeshade::test
