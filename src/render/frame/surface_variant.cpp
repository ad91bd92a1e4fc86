#include "src/render/frame/surface_variant.hpp"

#include "src/gl/program_variants.hpp"

#include <cmath>

namespace edgeshade {
namespace {

LightArrival arrivalOf(const SurfaceShading& shading) {
    using From = LightArrival::From;
    if (shading.listed) return {.from = From::lists, .longestList = shading.listed->longest};
    if (!shading.light) return {};
    const Light& light = *shading.light;
    return {.from = light.position.w == 0.0 ? From::direction
                    : light.isSpot()        ? From::spot
                                            : From::point,
            .withAmbient = shading.withAmbient,
            .ranged = light.hasRange()};
}

ShadowSource::Softness softnessOf(const ShadowMapLookup& map) {
    using Softness = ShadowSource::Softness;
    if (!map.soft) return Softness::hard;
    return map.pcss ? Softness::pcss : Softness::filtered;
}

ShadowSource shadowSourceOf(const SurfaceShading& shading, const SidedChunk* sided) {
    ShadowSource source;
    if (shading.map) {
        source.map = shading.map->defines;
        source.softness = softnessOf(*shading.map);
        if (shading.map->pcss) source.pcssShape = shading.map->pcss->shape;
    }
    if (shading.primitives)
        source.primitives = {shading.primitives->kind, shading.primitives->longestList,
                             shading.primitives->cutouts != nullptr, !shading.places.empty(),
                             shading.tintPrimitives};
    source.sided = sided && sided->lightSide == 0.0f;
    source.coarse = shading.coarse != nullptr;
    source.visibility = shading.visibility != nullptr;
    return source;
}

/// Adds to the variant how full shading draws the chunk, if shading is full.
void addMaterial(const GpuScene& scene, const SurfaceChunk& chunk, const SurfaceShading& shading,
                 const SurfaceDevice& device, SurfaceVariant& variant) {
    if (!shading.full || !shading.showsMaterials()) return;
    const Material& material = scene.materials[chunk.material];
    SurfaceLook& look = variant.look;
    LightArrival& light = variant.light;
    look.linear = shading.full->linear;
    if (look.catcher) {
        look.plain =
            shading.lights == 1.0 && shading.weight == 1.0; // otherwise several lights add up
        return;
    }
    if (material.unlit) return;
    light.softTerminator = light.from != LightArrival::From::nowhere &&
                           shading.full->softTerminator && chunk.smooth && device.derivatives;
    const bool simple = material.isPlain() && material.alphaMode != AlphaMode::blend;
    if (simple && shading.full->plainIsShort) {
        look.plain = true;
        return;
    }
    const bool ambient = !shading.addsLight();
    look.material = featuresOf(scene, chunk, ambient, device.derivatives,
                               device.textureUnits - unitsOfLookups(shading) - (ambient ? 1 : 0));
    look.texture = SurfaceLook::Texture::none;
    light.falloff =
        light.isOne() && light.from != LightArrival::From::direction && shading.light->photometric;
}

void addDefines(const SurfaceLook& look, std::vector<std::string>& defines) {
    using Texture = SurfaceLook::Texture;
    if (look.material) addDefines(*look.material, defines);
    const int sets =
        look.takes(0) | look.takes(1) << 1 | (look.takes(2) || look.takes(3) ? 1 : 0) << 2;
    defines.push_back("TEXCOORDS " + std::to_string(sets));
    gl::addDefines(defines, {{"ALPHA_TEST", look.alphaMode == AlphaMode::mask},
                             {"BLENDED", look.alphaMode == AlphaMode::blend},
                             {"PLAIN", look.plain},
                             {"CATCHER", look.catcher},
                             {"LINEAR", look.linear},
                             {"TEXTURED", look.texture != Texture::none},
                             {"ALPHA_LOOKUP", look.texture == Texture::alphaLookup},
                             {"COLORED", look.colored}});
}

void addDefines(const LightArrival& light, std::vector<std::string>& defines) {
    using From = LightArrival::From;
    if (light.from == From::lists)
        defines.push_back("LIGHT_LIST " + std::to_string(light.longestList));
    gl::addDefines(defines, {{"LIT", light.isOne()},
                             {"DIRECTIONAL", light.from == From::direction},
                             {"SPOT", light.from == From::spot},
                             {"WITH_AMBIENT", light.withAmbient},
                             {"RANGED", light.ranged},
                             {"FALLOFF", light.falloff},
                             {"SOFT_TERMINATOR", light.softTerminator}});
}

void addDefines(const ShadowSource& shadow, std::vector<std::string>& defines) {
    using Kind = GpuPrimitiveMap::Kind;
    using Softness = ShadowSource::Softness;
    if (shadow.map) defines.insert(defines.end(), shadow.map->begin(), shadow.map->end());
    if (const auto& of = shadow.primitives) {
        defines.push_back("PRIMITIVE_MAP_LONGEST " + std::to_string(of->longestList));
        gl::addDefines(defines, {{"PRIMITIVE_MAP", true},
                                 {"PRIMITIVE_MAP_DIRECTIONAL", of->kind == Kind::directional},
                                 {"PRIMITIVE_MAP_TILES", of->kind == Kind::sixTiles},
                                 {"PRIMITIVE_MAP_CUTOUTS", of->cutouts},
                                 {"PRIMITIVE_MAP_POINTS", of->points},
                                 {"PRIMITIVE_MAP_TINT", of->tint}});
    }
    if (shadow.softness == Softness::pcss)
        defines.push_back("PCSS " + std::to_string(static_cast<int>(shadow.pcssShape)));
    gl::addDefines(defines, {{"MAP", shadow.map != nullptr},
                             {"SOFT_MAP", shadow.softness != Softness::hard},
                             {"SIDED", shadow.sided},
                             {"SELF_SHADOWED", shadow.selfShadowed},
                             {"COARSE_MASK", shadow.coarse},
                             {"VISIBILITY", shadow.visibility}});
}

} // namespace

SurfaceVariant variantOf(const GpuScene& scene, const SurfaceChunk& chunk, const BatchView& view,
                         const SidedChunk* sided, const SurfaceShading& shading,
                         const SurfaceDevice& device) {
    using Texture = SurfaceLook::Texture;
    using Picture = SurfaceVariant::Picture;
    const Material& material = scene.materials[chunk.material];
    SurfaceVariant variant;
    SurfaceLook& look = variant.look;
    look.alphaMode = material.alphaMode;
    if (scene.textures.has(material.baseColor())) look.texture = Texture::baseColor;
    look.catcher = material.ground == GroundMaterial::catcher && shading.showsMaterials();
    look.colored = chunk.colored && (look.catcher || material.ground == GroundMaterial::none);
    variant.light = arrivalOf(shading);
    variant.shadow = shadowSourceOf(shading, sided);
    variant.shadow.selfShadowed = shading.selfShadowed && scene.castsInMaps(material);
    variant.mask = shading.mask;
    variant.sliced = std::isfinite(shading.farthest);
    if (shading.geometryAlone())
        variant.picture = shading.planes ? Picture::planes : Picture::nearness;
    const PlaneSpace* space = shading.coarse ? &shading.coarse->space : shading.geometryAlone();
    variant.orthographic = space && space->depthRange;
    addMaterial(scene, chunk, shading, device, variant);
    if (view.alpha) look.texture = Texture::alphaLookup;
    return variant;
}

SurfaceVariant maskVariantOf(const std::optional<Light>& light) {
    SurfaceShading shading;
    shading.light = light;
    SurfaceVariant variant;
    variant.light = arrivalOf(shading);
    variant.mask = true;
    return variant;
}

SurfaceVariant nearnessVariant(bool orthographic) {
    SurfaceVariant variant;
    variant.picture = SurfaceVariant::Picture::nearness;
    variant.orthographic = orthographic;
    return variant;
}

std::vector<std::string> definesOf(const SurfaceVariant& variant, const SurfaceDevice& device) {
    using Picture = SurfaceVariant::Picture;
    std::vector<std::string> defines;
    addDefines(variant.look, defines);
    addDefines(variant.light, defines);
    addDefines(variant.shadow, defines);
    gl::addDefines(defines, {{"PLANE", variant.shadow.coarse || variant.picture != Picture::colors},
                             {"NEARNESS_ALONE", variant.picture == Picture::nearness},
                             {"MASK", variant.mask},
                             {"SLICED", variant.sliced},
                             {"ORTHOGRAPHIC", variant.orthographic},
                             {"DERIVATIVES", device.derivatives}});
    return defines;
}

} // namespace edgeshade
