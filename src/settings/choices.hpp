#pragma once

#include "src/policy/shadow_method.hpp"

#include <compare>

// Types of the settings' values.

namespace edgeshade {

/// The layouts of records that shadow volumes are drawn from.
enum class VolumeLayout {
    planePairs,       ///< records that hold what the scene requires:
                      ///< preprocess/volumes/plane_pair_data.hpp
    oppositeVertices, ///< one global multiplicity, every edge, opposite vertices: the baseline
    triangles,        ///< only casting triangles, each with its own volume: brute force
};

/// How a triangle's sign is found (docs/method.md, The closed chain).
enum class MultiplicityMethod {
    plane,         ///< from its plane, stored once (docs/method.md, C1), in plane-pair records
    referenceEdge, ///< Milet 2020: one edge decides for the triangle
    threeEdge,     ///< Peciva 2013: three edges must agree
    singleEdge,    ///< Kim 2008: every edge for itself; not robust, the failing baseline
    triangle,      ///< Sambeek 2007: every triangle for itself, without edges: brute force
};

/// The records with the data that the method needs: adapted records have planes, published ones
/// opposite vertices; brute force needs only triangles.
constexpr VolumeLayout volumeLayoutOf(MultiplicityMethod method) {
    if (method == MultiplicityMethod::plane) return VolumeLayout::planePairs;
    return method == MultiplicityMethod::triangle ? VolumeLayout::triangles
                                                  : VolumeLayout::oppositeVertices;
}

/// The part of brute-force volumes that is counted.
enum class BruteForceCount {
    zFail, ///< the part behind surfaces
    zPass, ///< the part before surfaces, with near caps for casters before the near plane (ZP+)
};

/// The plane-pair records that the vertex shader receives; it decides their multiplicity.
enum class SilhouetteChoice {
    all,
    proposed, ///< those that may be silhouettes, see PotentialSilhouettes
};

/// How records reach the vertex shader; SidesLayout explains each way.
enum class InstancingChoice { automatic, on, off, multiDraw };

/// How shadow maps serve lights with an extent.
enum class SoftShadows {
    none, ///< hard shadows of their points, one map each, added up
    pcf,  ///< one map of their centre, with the usual filter
    pcss, ///< percentage-closer soft shadows (Fernando 2005) from one map of their centre
};

/// Kinds of shadow maps. Some are only for suns or only for lamps; other lights get cube.
enum class MapKind {
    cube,       ///< lamps: six faces around the light; suns: one map of all casters
    cascades,   ///< suns: several maps, of the visible geometry near the eye and farther away
    paraboloid, ///< lamps: two maps, of all directions up and down
    warped,     ///< suns: one map, with more texels where more is visible
};

/// Grids that place the texels of MapKind::warped.
enum class WarpGrid {
    rectilinear,   ///< columns and rows have their own widths and heights (Rosen 2012)
    nonOrthogonal, ///< columns differ from row to row, and rows alike (Milet et al. 2015)
};

/// How a map's texels around a position are combined.
enum class MapFilter {
    compare,     ///< pcf x pcf texels are each compared: percentage-closer filtering, or one texel
    poisson,     ///< sixteen are, in a disc pcf texels wide that is rotated in every pixel
    variance,    ///< a variance map (Donnelly and Lauritzen 2006), filtered pcf texels wide
    exponential, ///< an exponential map (Annen et al. 2008), filtered likewise
    moments,     ///< a map of four moments (Peters and Klein 2015), filtered likewise
};

inline constexpr int mostCascades = 4;

/// Settings of shadow maps that the sides of a view may differ in.
struct MapChoices {
    int size = 2048; ///< texels along an edge of each face; at least 16
    MapKind kind = MapKind::cube;
    int cascades = mostCascades; ///< 1..mostCascades
    MapFilter filter = MapFilter::compare;
    int pcf = 1;                           ///< width of the filter in texels; odd, 1: one texel
    WarpGrid warp = WarpGrid::rectilinear; ///< for MapKind::warped

    auto operator<=>(const MapChoices&) const = default;

    /// Whether the library's own maps suffice, without those of Rivals::maps().
    bool isPlain() const {
        return (kind == MapKind::cube || kind == MapKind::cascades) && filter == MapFilter::compare;
    }
};

/// A filter as the command line names it.
struct FilterChoice {
    enum class Width {
        one,     ///< a single texel
        several, ///< as many as MapChoices::pcf
        pcss,    ///< as SoftShadows::pcss finds
    };
    MapFilter filter = MapFilter::compare;
    Width width = Width::several;

    bool operator==(const FilterChoice&) const = default;
};

/// Settings that the two sides of a split view may differ in. RenderSettings has the same members.
struct SideSettings {
    ShadowMethod shadows = ShadowMethod::automatic;
    MultiplicityMethod multiplicity = MultiplicityMethod::plane;
    int maskScale = 1; ///< 1, 2 or 4; see RenderSettings
    MapChoices map{};

    auto operator<=>(const SideSettings&) const = default;
};

} // namespace edgeshade
