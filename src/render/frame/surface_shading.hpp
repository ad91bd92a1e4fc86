#pragma once

#include "src/gl/program.hpp"
#include "src/render/drawing/batch_view.hpp"
#include "src/render/frame/coarse_mask.hpp"
#include "src/render/frame/light_table.hpp"
#include "src/render/frame/visibility_lookup.hpp"
#include "src/render/shadow_map/shadow_map.hpp"
#include "src/scene/gpu_environment.hpp"
#include "src/scene/gpu_primitive_map.hpp"
#include "src/shadow/lights/light.hpp"

#include <limits>
#include <optional>
#include <span>

namespace edgeshade {

/// Full shading: the linear light that materials reflect (glTF 2.0, appendix B), as the display
/// shows it.
struct FullShading {
    /// Plain surfaces take surface.frag's short way: the light is white, and no brighter than the
    /// display can show.
    bool plainIsShort = false;
    const GpuEnvironment* environment = nullptr; ///< null if everything is plain and takes the
                                                 ///< short way
    bool softTerminator = false; ///< applies to smooth normals, if the GL has derivatives
    bool linear = false;         ///< linear light is written, to be tone-mapped later
    float ambientSlope = 0.0f;   ///< change of `ambient` from facing sideways to facing up
    float exposure = 1.0f;       ///< a factor
    glm::vec3 lightColor{0.0f};  ///< light that a white Lambert surface facing the light reflects
    glm::vec4 eye{0.0f, 0.0f, 0.0f, 1.0f}; ///< relative to the camera's position, world axes,
                                           ///< homogeneous
};

/// How surfaces are shaded: base colour times ambient light, times one light, or both; or
/// `maskValue` for the lit mask.
struct SurfaceShading {
    std::optional<FullShading> full; ///< null: Shading::base
    std::optional<Light> light;      ///< null: ambient light
    bool withAmbient = false;        ///< one light and ambient light, with ambient light's share in
                                     ///< alpha
    float ambient = 0.0f;
    float diffuse = 0.0f;       ///< factor of the light's Lambert term
    double lights = 0.0;        ///< sum of the weights of the picture's lights
    double weight = 1.0;        ///< weight of this light
    glm::vec3 background{0.0f}; ///< sRGB, shown by a ground that catches shadow
    bool mask = false;
    bool selfShadowed = false; ///< masks: the stencil doesn't cover all casters that face away from
                               ///< the light
    float maskValue = 0.0f;
    float farthest = std::numeric_limits<float>::infinity(); ///< deeper surfaces are not drawn
    /// The light's shadow map, primitive map or mask of lower resolution; all null: lit everywhere.
    const ShadowMapLookup* map = nullptr;
    const GpuPrimitiveMap* primitives = nullptr;
    std::span<const Light> places{}; ///< points of the light, at most placesAtOnce; `primitives` is
                                     ///< then a map of the whole light, and `maskValue` is written
                                     ///< once for each visible point
    glm::dvec4 eye{0.0};             ///< origin of lines of sight, in the world
    bool tintPrimitives = false;     ///< show the contents of the map's texels
    const CoarseMaskLookup* coarse = nullptr;
    const VisibilityLookup* visibility = nullptr; ///< visible share of its extent
    const LightTableLookup* listed = nullptr;     ///< all lights of the tiles' lists, instead of
                                                  ///< one light
    const PlaneSpace* planes = nullptr;           ///< not null: planes are drawn, without shading
    const PlaneSpace* nearness = nullptr;         ///< not null: nearness is drawn, without shading

    /// Whether only light is drawn, to be added to the picture.
    bool addsLight() const { return (light && !withAmbient) || listed; }

    /// Whether geometry is drawn instead of its appearance.
    const PlaneSpace* geometryAlone() const { return planes ? planes : nearness; }

    /// Whether materials decide what is drawn: no mask, geometry or tint of a map's texels.
    bool showsMaterials() const { return !mask && !geometryAlone() && !tintPrimitives; }
};

/// Number of texture units that the lookups of light.glsl and surface.frag's texture take; the
/// environment and a material's textures follow.
int unitsOfLookups(const SurfaceShading& shading);

/// Sets the uniforms of the view, of shading and of its light.
void setShading(const gl::Program& program, const SurfaceShading& shading, const BatchView& view);

/// Sets the uniforms and textures of lookups: the light's shadow, lists of lights, planes.
/// `casts`: whether the surface casts. `lightSide`: see SidedChunk; 0: each vertex has its own.
void setLookups(const gl::Program& program, const SurfaceShading& shading, const BatchView& view,
                bool casts, float lightSide);

} // namespace edgeshade
