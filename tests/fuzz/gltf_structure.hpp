#pragma once

#include "preprocess/file_io.hpp"
#include "tests/support/gltf_builder.hpp"

#include <set>
#include <string>

namespace edgeshade::test {

/// What in glTF's JSON breaks the rules of structure that Khronos' validator holds for errors: an
/// index of nothing, a range past its end, a field that must be there, an array that is empty. Each
/// as "where: what", without the values, so that two files can be compared. Knows nothing of how
/// `preprocess` reads; takes JSON of any shape.
std::set<std::string> structuralFaults(const Json& json);

/// The same of a GLB that must stand alone: its container, and no `uri` in it, too.
std::set<std::string> structuralFaults(const Bytes& glb);

} // namespace edgeshade::test
