#pragma once

#include "src/policy/shadow_method.hpp"

#include <compare>

// The things that settings choose among.

namespace edgeshade {

/// The layouts of records that shadow volumes are drawn from.
enum class VolumeLayout {
    planePairs,       ///< records that hold what the scene requires:
                      ///< preprocess/volumes/plane_pair_data.hpp
    oppositeVertices, ///< one global multiplicity, every edge, opposite vertices: the baseline
    triangles,        ///< casting triangles alone, each with a volume of its own: brute force
};

/// How a triangle's sign is found (docs/method.md, The closed chain).
enum class MultiplicityMethod {
    plane,         ///< its plane, stored once (docs/method.md, C1): plane-pair records hold these
    referenceEdge, ///< Milet 2020: one edge decides for the triangle
    threeEdge,     ///< Peciva 2013: three edges must agree
    singleEdge,    ///< Kim 2008: every edge for itself; not robust, the failing baseline
    triangle,      ///< Sambeek 2007: every triangle for itself, without edges: brute force
};

/// The records that have what the method needs: planes are in adapted ones, opposite vertices in
/// published ones; brute force needs triangles alone.
constexpr VolumeLayout volumeLayoutOf(MultiplicityMethod method) {
    if (method == MultiplicityMethod::plane) return VolumeLayout::planePairs;
    return method == MultiplicityMethod::triangle ? VolumeLayout::triangles
                                                  : VolumeLayout::oppositeVertices;
}

/// The part of brute-force volumes that is counted.
enum class BruteForceCount {
    zFail, ///< behind surfaces
    zPass, ///< before them, and casters before the near plane (ZP+)
};

/// The plane-pair records that reach the vertex shader, which decides their multiplicity.
enum class SilhouetteChoice {
    all,
    proposed, ///< those that may be silhouettes, see PotentialSilhouettes
};

/// How records reach the vertex shader; SidesLayout says what each means.
enum class InstancingChoice { automatic, on, off, multiDraw };

/// Shadows that maps give lights with an extent.
enum class SoftShadows {
    none, ///< hard shadows of their points, each with a map, averaged
    pcf,  ///< the map of their centre, filtered as wide as any
    pcss, ///< percentage-closer soft shadows (Fernando 2005) of the map of their centre
};

/// Kinds of shadow maps. Some are for suns alone, or for lamps alone; other lights get the first.
enum class MapKind {
    cube,       ///< six faces around a lamp; one map of all casters for a sun
    cascades,   ///< several for a sun, for parts of the view from near to far
    paraboloid, ///< two for a lamp, for directions up and down
    warped,     ///< one for a sun, with most texels where most is visible
};

/// Grids that distribute the texels of MapKind::warped.
enum class WarpGrid {
    rectilinear,   ///< columns and rows have their own widths and heights (Rosen 2012)
    nonOrthogonal, ///< so do the cells of each row and column (Milet et al. 2015)
};

/// Filters of a map's texels around a place.
enum class MapFilter {
    compare,     ///< pcf x pcf texels are compared: percentage-closer filtering, or a single one
    poisson,     ///< sixteen are, in a disc pcf texels wide that is turned in every pixel
    variance,    ///< a variance map (Donnelly and Lauritzen 2006), filtered pcf texels wide
    exponential, ///< an exponential map (Annen et al. 2008), likewise
    moments,     ///< a map of four moments (Peters and Klein 2015), likewise
};

inline constexpr int mostCascades = 4;

/// Settings of shadow maps that the sides of a view may differ in.
struct MapChoices {
    int size = 2048; ///< texels along an edge, of each face of a cube; at least 16
    MapKind kind = MapKind::cube;
    int cascades = mostCascades; ///< 1..mostCascades
    MapFilter filter = MapFilter::compare;
    int pcf = 1;                           ///< width of the filter in texels; odd, 1: a single one
    WarpGrid warp = WarpGrid::rectilinear; ///< of MapKind::warped

    auto operator<=>(const MapChoices&) const = default;

    /// Whether they are drawn without Rivals::maps().
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
