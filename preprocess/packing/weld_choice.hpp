#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/volumes/shadow_data.hpp"

#include <optional>

namespace edgeshade {

/// The most by which a chosen weld tolerance moves a vertex, as a share of the scene's diagonal.
inline constexpr double largestWeldShare = 1e-4;

/// Counts of a scene's casters with some weld tolerance; a mesh counts once for each of its places.
struct BorderCounts {
    std::size_t borders = 0;     ///< edges with one triangle
    std::size_t nonManifold = 0; ///< edges with more than two
    std::size_t degenerate = 0;  ///< triangles without three distinct vertices
    std::size_t quads = 0;       ///< silhouette quads of all edges in the worst light: closed
                                 ///< components count half
};

/// A weld tolerance chosen for a scene.
struct WeldChoice {
    double tolerance = 0.0; ///< scene units; 0 if none is worthwhile
    BorderCounts before;    ///< welded at equal positions alone
    BorderCounts after;

    /// Borders removed, minus three for each triangle that degenerates, whose own borders go with
    /// it.
    static std::size_t closed(const BorderCounts& before, const BorderCounts& after);
    /// Degenerate triangles and non-manifold edges that welding adds.
    static std::size_t harm(const BorderCounts& before, const BorderCounts& after);
};

/// Tries tolerances of largestWeldShare of the scene's diagonal, a quarter of that, and so on, down
/// to the spacing of floats. Rejects those that add more degenerate triangles and non-manifold
/// edges than they close borders. Of the others it takes the smallest whose gain (borders closed
/// minus harm) is at least 19/20 of the best.
///
/// `settings`: all other caster settings; simplification comes later and has no effect here. Takes
/// as long as reading the scene for each tolerance. Throws InputError.
WeldChoice chooseWeldTolerance(const GltfDocument& document, const CasterSettings& settings);

/// The settings, with the weld tolerance chosen if they ask for that; `choice` then gets the
/// report.
CasterSettings settingsFor(const GltfDocument& document, CasterSettings settings,
                           std::optional<WeldChoice>* choice = nullptr);

} // namespace edgeshade
