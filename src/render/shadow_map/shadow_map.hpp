#pragma once

#include "src/gl/objects.hpp"
#include "src/gl/program.hpp"
#include "src/render/shadow_map/pcss_light.hpp"

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace edgeshade {

/// What lights with an extent get of their shadow maps.
enum class SoftShadows {
    none, ///< hard shadows of their points, each with a map, added up
    pcf,  ///< the map of their centre, filtered as wide as any
    pcss, ///< percentage-closer soft shadows (Fernando 2005) of the map of their centre
};

/// Which maps lights get: some of them are of suns alone, or of lamps alone; the others get the
/// first.
enum class MapKind {
    cube,       ///< six faces around a lamp; of a sun one map of all casters
    cascades,   ///< of a sun several, of what is visible near the eye and farther off
    paraboloid, ///< of a lamp two, of all directions up and down
    warped,     ///< of a sun one, whose texels are where most is visible
};

/// How the texels of MapKind::warped get there.
enum class WarpGrid {
    rectilinear,   ///< columns and rows of their own widths and heights (Rosen 2012)
    nonOrthogonal, ///< each row's columns are its own, and so on (Milet et al. 2015)
};

/// What is made of a map's texels around a place.
enum class MapFilter {
    compare,     ///< each of pcf x pcf is compared: percentage-closer filtering, or one alone
    poisson,     ///< so are sixteen in a disc pcf texels wide, turned in every pixel
    variance,    ///< a variance map (Donnelly and Lauritzen 2006), filtered pcf texels wide
    exponential, ///< an exponential map (Annen et al. 2008), likewise
    moments,     ///< a map of four moments (Peters and Klein 2015), likewise
};

inline constexpr int mostCascades = 4;

/// How shadow maps are made and read.
struct ShadowMapSettings {
    int size = 2048;         ///< texels along an edge, of each face of a cube; at least 16
    float biasTexels = 1.5f; ///< in texels as large as they are on the receiver
    int pcf = 1;             ///< how many texels wide the filter is; odd, 1: a single one
    SoftShadows soft = SoftShadows::none; ///< pcss: of MapKind::cube and MapFilter::compare
    bool facesApart = false; ///< a cube's faces apart even where the GL holds them in one texture
    MapKind kind = MapKind::cube;
    int cascades = mostCascades; ///< 1..mostCascades
    MapFilter filter = MapFilter::compare;
    WarpGrid warp = WarpGrid::rectilinear; ///< of MapKind::warped
    /// What of light in half shadow is taken for light that bleeds through several casters, 0..1;
    /// nothing: as much as usual, 0.2 of variance maps, 0.02 of moments.
    std::optional<float> bleeding{};

    /// Whether they need nothing of what Rivals::maps() adds.
    bool isPlain() const {
        return (kind == MapKind::cube || kind == MapKind::cascades) && filter == MapFilter::compare;
    }
};

/// The textures of a light's map.
struct MapForm {
    bool parallel = false; ///< the light is a sun
    bool cube = false;     ///< all faces are in one cube map; else each is a flat texture
    int faces = 1;         ///< six of a cube, one of a single map, or cascades

    bool operator==(const MapForm&) const = default;
};

/// Sets what receivers' shaders read of a map beyond what all maps have.
class MapUniforms {
  public:
    virtual ~MapUniforms() = default;
    /// `unit`: the first texture unit that they may take.
    virtual void set(gl::Program& program, int unit) const = 0;
    virtual int units() const = 0; ///< how many they take
};

/// A light's finished map, with what a receiver needs to look itself up in it.
struct ShadowMapLookup {
    std::array<gl::Name, 6> textures{}; ///< of a cube map one
    int faces = 0;                      ///< how many textures; of a cube map 0
    /// #defines of the receivers' shaders; they live as long as what drew the map.
    const std::vector<std::string>* defines = nullptr;
    glm::dmat4 mapFromWorld{1.0}; ///< see ShadowMapView
    float step = 0.0f;  ///< from texel to texel in the map; of a point light's at distance 1
    float texel = 0.0f; ///< the same as a length in the world
    float biasTexels = 0.0f;
    bool soft = false; ///< of a light with an extent, instead of maps of its points
    std::optional<PcssLight> pcss{};
    float share = 1.0f;       ///< see ShadowMapView
    glm::vec3 mapScale{1.0f}; ///< map space per length in the world, along each axis
    /// See ShadowMapView: one for each texture of cascades; else none.
    std::array<glm::vec4, mostCascades> cascades{};
    std::size_t cascadeCount = 0;
    float cascadeMargin = 0.0f;           ///< see ShadowMapView
    const MapUniforms* further = nullptr; ///< null: all maps' are enough

    /// How many texture units they take.
    int units() const { return std::max(faces, 1) + (further ? further->units() : 0); }
};

} // namespace edgeshade
