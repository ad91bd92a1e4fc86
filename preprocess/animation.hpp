#pragma once

#include "preprocess/gltf_document.hpp"
#include "preprocess/scene.hpp"

namespace edgeshade {

/// The first animation of a document, ready to be evaluated: what moves the batches whose `node` is
/// animated (glTF 2.0, section 3.11; translation, rotation, scale; STEP, LINEAR, CUBICSPLINE).
struct Animation;

/// Reads it. Null where nothing is animated. Safe on untrusted input. Throws InputError.
std::shared_ptr<const Animation> readAnimation(const GltfDocument& document);

/// Its length in seconds.
double durationOf(const Animation& animation);

/// worldFromBatch of each of the scene's batches at a time, which is clamped to the animation.
std::vector<glm::dmat4> poseAt(const Animation& animation, const Scene& scene, double seconds);

} // namespace edgeshade
