#pragma once

#include "src/render/frame/material_features.hpp"
#include "src/render/frame/surface_shading.hpp"

#include <compare>
#include <optional>
#include <string>
#include <vector>

namespace edgeshade {

/// Properties of the GL that shaders of surfaces depend on.
struct SurfaceDevice {
    int textureUnits = 8;
    bool derivatives = false;
};

/// Properties of the surface.
struct SurfaceLook {
    /// Base colour from a texture of surface.frag, or alpha from an AlphaLookup.
    enum class Texture { none, baseColor, alphaLookup };

    AlphaMode alphaMode = AlphaMode::opaque;
    std::optional<MaterialFeatures> material; ///< of material.frag; null: surface.frag
    Texture texture = Texture::none;
    bool colored = false; ///< has vertex colours
    bool plain = false;   ///< full shading that needs no material.frag
    bool catcher = false; ///< shows the background, darker in shadow
    bool linear = false;  ///< writes linear light, not display colours

    /// Whether any texture uses this set of coordinates.
    bool takes(int channel) const {
        return (channel == 0 && texture != Texture::none) || (material && material->takes(channel));
    }

    std::strong_ordering operator<=>(const SurfaceLook&) const = default;
};

/// How light arrives at it.
struct LightArrival {
    enum class From {
        nowhere,
        direction, ///< a directional light
        point,
        spot,  ///< a point light with a cone
        lists, ///< all lights of the tiles' lists
    };

    From from = From::nowhere;
    int longestList = 0;         ///< lists: none is longer than this
    bool withAmbient = false;    ///< and from ambient light
    bool ranged = false;         ///< the light has a range
    bool falloff = false;        ///< the light falls off with the square of the distance
    bool softTerminator = false; ///< dims light that grazes facets

    bool isOne() const { return from != From::nowhere && from != From::lists; }
    std::strong_ordering operator<=>(const LightArrival&) const = default;
};

/// Where the light's shadow comes from.
struct ShadowSource {
    /// How the map is filtered; all but `hard` are for lights with an extent.
    enum class Softness { hard, filtered, pcss };
    struct Primitives {
        GpuPrimitiveMap::Kind kind;
        int longestList;
        bool cutouts, points, tint;

        std::strong_ordering operator<=>(const Primitives&) const = default;
    };

    const std::vector<std::string>* map = nullptr; ///< ShadowMapLookup::defines; null: no map
    Softness softness = Softness::hard;
    LightExtent::Shape pcssShape = LightExtent::Shape::sphere;
    std::optional<Primitives> primitives;
    bool sided = false;        ///< vertices know which side faces the light
    bool selfShadowed = false; ///< dark where the normal faces away from the light
    bool coarse = false;       ///< a mask of lower resolution
    bool visibility = false;   ///< the light's visible share

    std::strong_ordering operator<=>(const ShadowSource&) const = default;
};

/// A program that draws surfaces, by all that its #defines say.
struct SurfaceVariant {
    /// Colours, or instead of them geometry: see coarse_surface.frag.
    enum class Picture { colors, planes, nearness };

    SurfaceLook look;
    LightArrival light;
    ShadowSource shadow;
    Picture picture = Picture::colors;
    bool mask = false;         ///< draws the lit mask
    bool sliced = false;       ///< has a farthest depth
    bool orthographic = false; ///< samples a coarse mask or draws geometry in an orthographic view

    std::strong_ordering operator<=>(const SurfaceVariant&) const = default;
};

/// `sided`: the chunk's triangles for the primitive map's light; null: not needed.
SurfaceVariant variantOf(const GpuScene& scene, const SurfaceChunk& chunk, const BatchView& view,
                         const SidedChunk* sided, const SurfaceShading& shading,
                         const SurfaceDevice& device);

/// The variant of plain surfaces in lit masks of a light; null: without a light.
SurfaceVariant maskVariantOf(const std::optional<Light>& light);
/// The variant of plain surfaces in pictures of nearness (Renderer::drawNearness()).
SurfaceVariant nearnessVariant(bool orthographic);

/// The #defines of the variant's program.
std::vector<std::string> definesOf(const SurfaceVariant& variant, const SurfaceDevice& device);

} // namespace edgeshade
