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

/// Full shading: what materials send back of linear light (glTF 2.0, appendix B), as the display
/// shows it.
struct FullShading {
    /// Plain surfaces take surface.frag's short way: the light is white, and no brighter than what
    /// the display shows of it.
    bool plainIsShort = false;
    const GpuEnvironment* environment = nullptr; ///< null where all is plain and short
    bool softTerminator = false; ///< where normals are smooth and the GL has derivatives
    bool linear = false;         ///< light itself is written, to be mapped later
    float ambientSlope = 0.0f;   ///< of `ambient` from the side to above
    float exposure = 1.0f;       ///< a factor
    glm::vec3 lightColor{0.0f};  ///< what a white Lambert surface sends back of it, straight on
    glm::vec4 eye{0.0f, 0.0f, 0.0f, 1.0f}; ///< from the camera's position, world axes, homogeneous
};

/// What the surfaces write: base colour times ambient light or times that of one light or both, or,
/// for the lit mask, `maskValue`.
struct SurfaceShading {
    std::optional<FullShading> full; ///< nothing: Shading::base
    std::optional<Light> light;      ///< nothing: ambient light
    bool withAmbient = false;        ///< light and ambient light, whose share of both is in alpha
    float ambient = 0.0f;
    float diffuse = 0.0f;       ///< of the light, times its Lambert term
    double lights = 0.0;        ///< of the picture, by their weights
    double weight = 1.0;        ///< of this light among them
    glm::vec3 background{0.0f}; ///< sRGB, which a ground that catches shadow shows
    bool mask = false;
    bool selfShadowed = false; ///< of the mask: the stencil doesn't know all casters turned away
    float maskValue = 0.0f;
    float farthest = std::numeric_limits<float>::infinity(); ///< what is deeper is not drawn
    /// The light's shadow map, primitive map or mask of lower resolution; none: lit everywhere.
    const ShadowMapLookup* map = nullptr;
    const GpuPrimitiveMap* primitives = nullptr;
    std::span<const Light>
        places{};                ///< of the light, at most placesAtOnce: `primitives` is of all
                                 ///< of it, and as many times `maskValue` are written as are seen
    glm::dvec4 eye{0.0};         ///< where lines of sight come from, in the world
    bool tintPrimitives = false; ///< show what its texels hold
    const CoarseMaskLookup* coarse = nullptr;
    const VisibilityLookup* visibility = nullptr; ///< how much of its extent is seen
    const LightTableLookup* listed = nullptr;     ///< all lights of lists by tile, in place of one
    const PlaneSpace* planes = nullptr;   ///< not null: planes are drawn, and nothing is shaded
    const PlaneSpace* nearness = nullptr; ///< likewise, nearness alone

    /// Light alone is drawn, to be added to what is there.
    bool addsLight() const { return (light && !withAmbient) || listed; }

    /// Surfaces themselves are drawn, not what they look like.
    const PlaneSpace* geometryAlone() const { return planes ? planes : nearness; }
};

/// Whether all surfaces of a batch are certainly outside one of the planes, viewPlanes() of the
/// world.
bool isOutOfView(const GpuBatch& batch, const ViewPlanes& planes);

/// Where the view's camera sees a batch from, and where its light's map has it.
BatchView surfaceViewOf(const GpuScene& scene, const GpuBatch& batch, const FrameView& view,
                        const DepthSlice& slice, const SurfaceShading& shading);

/// Draws visible surfaces, from both sides but where the scene culls single-sided ones; depth,
/// stencil and blending are the caller's state. Those of unlit materials have their own colour
/// whatever the light; masks show where it falls on them.
class SurfacePass {
  public:
    explicit SurfacePass(const gl::Capabilities& capabilities)
        : textureUnits_(capabilities.textureUnits),
          derivatives_(capabilities.has("GL_OES_standard_derivatives")) {}

    /// Draws the batch's surfaces of the given kind, in the order of its chunks. Returns vertex
    /// runs.
    std::size_t draw(const GpuScene& scene, const GpuBatch& batch, const BatchView& view,
                     const glm::dvec3& eye, const SurfaceShading& shading, AlphaMode kind);

    /// Draws one chunk, of the sides that the caller doesn't cull, unless it certainly isn't in
    /// view. Returns vertex runs.
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
        std::optional<MaterialFeatures> material; ///< of material.frag
        const std::vector<std::string>* map;      ///< ShadowMapLookup::defines; null: looks up none
        std::optional<PrimitiveMapVariant> primitives;
        bool softMap;        ///< the map is that of a light with an extent
        bool pcss;           ///< which gets percentage-closer soft shadows
        bool rectangle;      ///< and is a rectangle
        bool plain;          ///< full shading of what needs no material.frag
        bool linear;         ///< light itself is written, not the display's colours
        bool softTerminator; ///< dims the light where it grazes facets
        bool catcher;        ///< shows the background, darker in shadow
        bool textured;
        bool colored; ///< has colours at its vertices
        bool lit;
        int lightList;     ///< lit by lists by tile, none longer; 0: not
        bool falloff;      ///< lit by a light that falls off with the square of the distance
        bool withAmbient;  ///< with ambient light, too
        bool directional;  ///< lit by a light of one direction
        bool ranged;       ///< lit by a light that doesn't reach everywhere
        bool spot;         ///< lit by a light with a cone
        bool mask;         ///< draws the lit mask
        bool sliced;       ///< has a farthest depth
        bool coarse;       ///< looks up a mask of lower resolution
        bool visibility;   ///< looks up how much of the light is seen
        bool planes;       ///< draws what such a mask stores of surfaces
        bool nearness;     ///< draws how near they are
        bool orthographic; ///< looks it up or draws it for such a picture
        bool alphaLookup;  ///< finds its alpha by an AlphaLookup
        bool sided;        ///< its vertices know which side the light is on
        bool selfShadowed; ///< is dark where its normal says so

        auto key() const {
            return std::tie(alphaMode, material, map, primitives, softMap, pcss, rectangle, plain,
                            linear, softTerminator, catcher, textured, colored, lit, lightList,
                            falloff, withAmbient, directional, ranged, spot, mask, sliced, coarse,
                            visibility, planes, nearness, orthographic, alphaLookup, sided,
                            selfShadowed);
        }
        bool operator<(const Variant& other) const { return key() < other.key(); }
    };
    /// Of SurfaceVertex or SidedVertex, or of SurfaceDetail, as the variants that need it read it.
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
