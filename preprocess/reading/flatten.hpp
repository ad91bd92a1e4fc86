#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/scene/instance_choice.hpp"
#include "preprocess/scene/looks.hpp"
#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// Gathers the triangles of the default scene's nodes into batches: node transforms in double
/// precision, positions rounded to float once, relative to the batch's local origin. Mirrored nodes
/// keep their outside outside. Skins and morphs that no animation moves are taken at rest; others
/// deform.
///
/// `instances` decides how a mesh at several places is kept.
///
/// `weldTolerance` (scene units, >= 0) moves vertices closer than that onto each other; 0 changes
/// nothing. An unknown variant gets a warning, and the file's own materials. The document's
/// warnings come first in the scene's. Safe on untrusted input. Throws InputError, also beyond the
/// limits that the document was read with.
Scene flattenScene(const GltfDocument& document, double weldTolerance, const Looks& looks = {},
                   InstanceChoice instances = InstanceChoice::automatic);

} // namespace edgeshade
