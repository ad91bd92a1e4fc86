#pragma once

#include "src/gl/program.hpp"
#include "src/render/drawing/batch_view.hpp"
#include "src/render/frame/coarse_mask.hpp"
#include "src/render/frame/light_table.hpp"
#include "src/render/frame/material_features.hpp"
#include "src/render/frame/visibility_lookup.hpp"
#include "src/render/shadow_map/shadow_map.hpp"
#include "src/scene/gpu_environment.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/lights/light.hpp"

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <tuple>

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
};

/// Whether all surfaces of a batch are certainly outside one of the planes, viewPlanes() of the
/// world.
bool isOutOfView(const GpuBatch& batch, const ViewPlanes& planes);

/// The camera's view of a batch, and its placement in the light's map.
BatchView surfaceViewOf(const GpuScene& scene, const GpuBatch& batch, const FrameView& view,
                        const DepthSlice& slice, const SurfaceShading& shading);

/// Draws visible surfaces, from both sides unless the scene culls single-sided ones. Depth, stencil
/// and blending are the caller's state. Surfaces with unlit materials have their own colour in any
/// light; in masks they show shadows like others.
class SurfacePass {
  public:
    explicit SurfacePass(const gl::Capabilities& capabilities)
        : textureUnits_(capabilities.textureUnits),
          derivatives_(capabilities.has("GL_OES_standard_derivatives")) {}

    /// Draws the batch's surfaces of the given kind, in the order of its chunks. Returns vertex
    /// runs.
    std::size_t draw(const GpuScene& scene, const GpuBatch& batch, const BatchView& view,
                     const glm::dvec3& eye, const SurfaceShading& shading, AlphaMode kind);

    /// Draws one chunk, limited to the sides that the caller doesn't cull, unless it is certainly
    /// outside the view. Returns vertex runs.
    std::size_t drawChunk(const GpuScene& scene, const SurfaceChunk& chunk, const BatchView& view,
                          const glm::dvec3& eye, const SurfaceShading& shading);

  private:
    struct PrimitiveMapVariant {
        GpuPrimitiveMap::Kind kind;
        int longestList;
        bool cutouts, points, tint;

        auto operator<=>(const PrimitiveMapVariant&) const = default;
    };
    struct Variant {
        AlphaMode alphaMode;
        std::optional<MaterialFeatures> material; ///< of material.frag; null: surface.frag
        const std::vector<std::string>* map;      ///< ShadowMapLookup::defines; null: no map
        std::optional<PrimitiveMapVariant> primitives;
        bool softMap;        ///< the map belongs to a light with an extent
        bool pcss;           ///< the map is filtered by percentage-closer soft shadows
        bool rectangle;      ///< the light is a rectangle
        bool plain;          ///< full shading that needs no material.frag
        bool linear;         ///< writes linear light, not display colours
        bool softTerminator; ///< dims light that grazes facets
        bool catcher;        ///< shows the background, darker in shadow
        bool textured;
        bool colored; ///< has vertex colours
        bool lit;
        int lightList;     ///< lit by the tiles' lists, none longer than this; 0: not
        bool falloff;      ///< the light falls off with the square of the distance
        bool withAmbient;  ///< and lit by ambient light
        bool directional;  ///< lit by a directional light
        bool ranged;       ///< lit by a light with a range
        bool spot;         ///< lit by a light with a cone
        bool mask;         ///< draws the lit mask
        bool sliced;       ///< has a farthest depth
        bool coarse;       ///< samples a mask of lower resolution
        bool visibility;   ///< samples the light's visible share
        bool planes;       ///< draws the surfaces' planes for such a mask
        bool nearness;     ///< draws the surfaces' nearness
        bool orthographic; ///< samples or draws any of these in an orthographic view
        bool alphaLookup;  ///< takes its alpha from an AlphaLookup
        bool sided;        ///< its vertices know which side faces the light
        bool selfShadowed; ///< is dark where its normal faces away from the light

        auto key() const {
            return std::tie(alphaMode, material, map, primitives, softMap, pcss, rectangle, plain,
                            linear, softTerminator, catcher, textured, colored, lit, lightList,
                            falloff, withAmbient, directional, ranged, spot, mask, sliced, coarse,
                            visibility, planes, nearness, orthographic, alphaLookup, sided,
                            selfShadowed);
        }
        bool operator<(const Variant& other) const { return key() < other.key(); }
    };
    /// The buffer that holds an attribute: SurfaceVertex or SidedVertex, or SurfaceDetail.
    enum class Buffer { vertices, details };
    struct Attribute {
        const char* name;
        int components;
        unsigned type; ///< GL enum; bytes are normalised
        std::size_t offset;
        Buffer buffer;
        bool (*isOf)(const Variant&);
    };
    static const std::array<Attribute, 8> attributes_; ///< in the order of their locations

    std::size_t drawSeen(const GpuScene& scene, const SurfaceChunk& chunk, const BatchView& view,
                         const glm::dvec3& eye, const SurfaceShading& shading);
    Variant variantOf(const GpuScene& scene, const SurfaceChunk& chunk,
                      const SurfaceShading& shading) const;
    void addMaterial(const GpuScene& scene, const SurfaceChunk& chunk,
                     const SurfaceShading& shading, Variant& variant) const;
    gl::Program& program(const Variant& variant);
    static int firstUnit(const SurfaceShading& shading, const gl::Program& program);

    int textureUnits_;
    bool derivatives_;
    std::map<Variant, gl::Program> programs_;
};

} // namespace edgeshade
