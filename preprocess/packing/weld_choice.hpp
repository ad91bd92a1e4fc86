#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/volumes/shadow_data.hpp"

#include <optional>

namespace edgeshade {

/// The share of the scene's diagonal that no vertex is moved farther than by a weld tolerance that
/// is chosen for it.
inline constexpr double largestWeldShare = 1e-4;

/// What a scene's casters are with some weld tolerance: each mesh as often as it stands somewhere.
struct BorderCounts {
    std::size_t borders = 0;     ///< edges of one triangle
    std::size_t nonManifold = 0; ///< edges of more than two
    std::size_t degenerate = 0;  ///< triangles without three distinct vertices
    std::size_t quads = 0;       ///< of all edges in the worst light: closed components count half
};

/// A weld tolerance chosen for a scene.
struct WeldChoice {
    double tolerance = 0.0; ///< scene units; 0 where none is worth it
    BorderCounts before;    ///< of equal positions alone
    BorderCounts after;

    /// Borders that are gone, less three for each triangle that degenerates and takes its own
    /// along.
    static std::size_t closed(const BorderCounts& before, const BorderCounts& after);
    /// Degenerate triangles and non-manifold edges that welding makes.
    static std::size_t harm(const BorderCounts& before, const BorderCounts& after);
};

/// Tries tolerances of largestWeldShare of the scene's diagonal, a fourth of that, and so on, down
/// to the steps of floats. Those that make more triangles degenerate and more edges non-manifold
/// than they close borders are out of the question. Of the others the least one is taken that
/// closes nearly (19 of 20) as many borders, less what it harms, as the one that closes most.
///
/// `settings`: how the casters are found otherwise; simplifying them comes later and changes
/// nothing here. Takes as long as reading the scene for each tolerance. Throws InputError.
WeldChoice chooseWeldTolerance(const GltfDocument& document, const CasterSettings& settings);

/// The settings with the tolerance chosen, where they ask for that; told of in `choice` then.
CasterSettings settingsFor(const GltfDocument& document, CasterSettings settings,
                           std::optional<WeldChoice>* choice = nullptr);

} // namespace edgeshade
