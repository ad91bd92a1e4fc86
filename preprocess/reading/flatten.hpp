#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/scene/instance_choice.hpp"
#include "preprocess/scene/looks.hpp"
#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// Walks the default scene's nodes and gathers their triangles into batches: node transforms in
/// double, rounded to float once, relative to the batch's local origin. Mirrored nodes keep their
/// outside outside. Skins and morphs that no animation moves are taken at rest; others deform.
///
/// A mesh that stands at several places is kept as `instances` says.
///
/// `weldTolerance` (scene units, >= 0) moves vertices closer than that onto each other; 0 changes
/// nothing. A variant that there is not is warned of and means the file's own materials. The
/// document's warnings are the scene's first. Safe on untrusted input. Throws InputError, also for
/// what passes the limits that the document was read with.
Scene flattenScene(const GltfDocument& document, double weldTolerance, const Looks& looks = {},
                   InstanceChoice instances = InstanceChoice::automatic);

} // namespace edgeshade
