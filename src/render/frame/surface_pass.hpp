#pragma once

#include "src/gl/program.hpp"
#include "src/render/drawing/batch_view.hpp"
#include "src/render/frame/coarse_mask.hpp"
#include "src/render/shadow_map/shadow_map.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/geometry/light.hpp"

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

namespace edgeshade {

/// What the surfaces write: base colour times ambient light or times that of one light or both, or,
/// for the lit mask, `maskValue`.
struct SurfaceShading {
    std::optional<Light> light; ///< nothing: ambient light
    bool withAmbient = false;   ///< light and ambient light, whose share of both is in alpha
    float ambient = 0.0f;
    float diffuse = 0.0f; ///< of the light, times its Lambert term
    bool mask = false;
    float maskValue = 0.0f;
    float farthest = std::numeric_limits<float>::infinity(); ///< what is deeper is not drawn
    /// The light's shadow map, primitive map or mask of lower resolution; none: lit everywhere.
    const ShadowMapLookup* map = nullptr;
    const GpuPrimitiveMap* primitives = nullptr;
    bool tintPrimitives = false; ///< show what its texels hold
    const CoarseMaskLookup* coarse = nullptr;
    const PlaneSpace* planes = nullptr; ///< not null: planes are drawn, and nothing is shaded
};

/// Draws visible surfaces from both sides; depth, stencil and blending are the caller's state.
/// Those of unlit materials have their own colour whatever the light; masks show where it falls on
/// them.
class SurfacePass {
  public:
    /// `pcf`: how many texels of a shadow map are compared, along each axis; odd.
    explicit SurfacePass(int pcf = 1) : pcf_(pcf) {}

    /// Draws the batch's surfaces of the given kind, in the order of its chunks. Returns vertex
    /// runs.
    std::size_t draw(const GpuScene& scene, const GpuBatch& batch, const BatchView& view,
                     const glm::dvec3& eye, const SurfaceShading& shading, AlphaMode kind);

    /// Draws one chunk unless it certainly isn't in view. Returns vertex runs.
    std::size_t drawChunk(const GpuScene& scene, const SurfaceChunk& chunk, const BatchView& view,
                          const glm::dvec3& eye, const SurfaceShading& shading);

  private:
    struct PrimitiveMapVariant {
        GpuPrimitiveMap::Kind kind;
        int splits, longestList;
        bool tint;

        auto operator<=>(const PrimitiveMapVariant&) const = default;
    };
    struct Variant {
        AlphaMode alphaMode;
        std::optional<ShadowMapKind> map;
        std::optional<PrimitiveMapVariant> primitives;
        bool textured;
        bool colored; ///< has colours at its vertices
        bool lit;
        bool withAmbient;  ///< with ambient light, too
        bool directional;  ///< lit by a light of one direction
        bool ranged;       ///< lit by a light that doesn't reach everywhere
        bool spot;         ///< lit by a light with a cone
        bool mask;         ///< draws the lit mask
        bool sliced;       ///< has a farthest depth
        bool coarse;       ///< looks up a mask of lower resolution
        bool planes;       ///< draws what such a mask stores of surfaces
        bool orthographic; ///< looks it up or draws it for such a picture

        auto key() const {
            return std::tie(alphaMode, map, primitives, textured, colored, lit, withAmbient,
                            directional, ranged, spot, mask, sliced, coarse, planes, orthographic);
        }
        bool operator<(const Variant& other) const { return key() < other.key(); }
    };
    /// Of SurfaceVertex, as the variants that need it read it.
    struct Attribute {
        const char* name;
        int components;
        unsigned type; ///< GL enum; bytes are normalised
        std::size_t offset;
        bool Variant::*needed; ///< null: by all

        bool isOf(const Variant& variant) const { return !needed || variant.*needed; }
    };
    static const std::array<Attribute, 4> attributes_; ///< in the order of their locations

    std::size_t drawSeen(const GpuScene& scene, const SurfaceChunk& chunk, const BatchView& view,
                         const glm::dvec3& eye, const SurfaceShading& shading);
    static Variant variantOf(const GpuScene& scene, const SurfaceChunk& chunk,
                             const SurfaceShading& shading);
    gl::Program& program(const Variant& variant);

    int pcf_;
    std::map<Variant, gl::Program> programs_;
};

} // namespace edgeshade
