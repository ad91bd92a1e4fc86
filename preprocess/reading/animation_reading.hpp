#pragma once

#include "preprocess/base/warnings.hpp"
#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/scene/animation.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace edgeshade {

/// An animation of the file that moves a drawn or casting object, a camera or a light.
struct AnimationTitle {
    std::size_t index = 0; ///< in the file
    std::string name;      ///< from the file, or "animation 3" if it has none
};

/// All such animations, in the file's order.
std::vector<AnimationTitle> animationTitles(const GltfDocument& document);

/// The one of `titles` with that name, or else with that index; null if there is none.
const AnimationTitle* findAnimation(const std::vector<AnimationTitle>& titles,
                                    const std::string& nameOrIndex);

/// The titles of animations with a playable channel; unplayable parts of the others get their
/// warnings.
std::vector<AnimationTitle> playedAnimations(const GltfDocument& document, Warnings& warnings);

/// Reads the animation with that index in the file, or the first playable one of animationTitles()
/// (glTF 2.0, 3.11): nodes and morph weights. Null if there is none. Ignores channels of
/// extensions, and of weights that no mesh has. A broken channel is left out, and a repaired one is
/// played, each with a warning that names the field and its value. Safe on untrusted input.
std::optional<Animation> readAnimation(const GltfDocument& document, Warnings& warnings,
                                       std::optional<std::size_t> index = {});

/// Morph targets of a mesh of the document, and so weights of its nodes.
std::size_t morphTargetCount(const GltfDocument& document, int mesh);

/// Nodes whose morph weights an animation moves.
std::set<int> morphingNodes(const GltfDocument& document);

} // namespace edgeshade
