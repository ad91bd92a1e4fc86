#pragma once

#include "preprocess/base/warnings.hpp"
#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/scene/animation.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace edgeshade {

/// An animation of the file that moves something which is drawn or casts, or a camera or a light.
struct AnimationTitle {
    std::size_t index = 0; ///< in the file
    std::string name;      ///< the file's, or "animation 3" if it has none
};

/// All of them, in the file's order.
std::vector<AnimationTitle> animationTitles(const GltfDocument& document);

/// That of `titles` with the name, or else with the index; null if there is none.
const AnimationTitle* findAnimation(const std::vector<AnimationTitle>& titles,
                                    const std::string& nameOrIndex);

/// Those of them of which anything can be played; what of the others can't gets its warnings.
std::vector<AnimationTitle> playedAnimations(const GltfDocument& document, Warnings& warnings);

/// Reads the animation with that index in the file, or the first of animationTitles() that can be
/// played (glTF 2.0, 3.11): nodes and morph weights. Null if there is none. Channels of extensions,
/// and of weights that no mesh has, are left aside; a broken channel is left out, and one that is
/// mended is played, with a warning that names the field and its value. Safe on untrusted input.
std::optional<Animation> readAnimation(const GltfDocument& document, Warnings& warnings,
                                       std::optional<std::size_t> index = {});

/// How many morph targets a mesh of the document has: weights of its nodes.
std::size_t morphTargetCount(const GltfDocument& document, int mesh);

/// The nodes whose morph weights an animation moves.
std::set<int> morphingNodes(const GltfDocument& document);

} // namespace edgeshade
