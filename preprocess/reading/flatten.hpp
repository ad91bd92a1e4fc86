#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// Walks the default scene's nodes and gathers their triangles into batches: node transforms in
/// double, rounded to float once, relative to the batch's local origin. Mirrored nodes keep their
/// outside outside. Skins and morphs are taken at rest.
///
/// `weldTolerance` (scene units, >= 0) moves vertices closer than that onto each other; 0 changes
/// nothing. `variant` names one of KHR_materials_variants' sets of materials; an empty one, and one
/// that there is not, which is warned of, mean the file's own. The document's warnings are the
/// scene's first. Safe on untrusted input. Throws InputError, also for what passes the limits that
/// the document was read with.
Scene flattenScene(const GltfDocument& document, double weldTolerance,
                   const std::string& variant = {});

} // namespace edgeshade
