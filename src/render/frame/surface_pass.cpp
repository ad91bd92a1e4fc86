#include "src/render/frame/surface_pass.hpp"

#include "shaders_es2.hpp"
#include "src/render/drawing/attributes.hpp"
#include "src/render/drawing/cull_scope.hpp"
#include "src/render/frame/cone_window.hpp"
#include "src/scene/srgb.hpp"
#include "src/settings/build_parts.hpp"
#include "src/shadow/geometry/box_plane.hpp"
#include "src/shadow/geometry/vectors.hpp"
#include "src/shadow/lights/light_cone.hpp"
#include "src/shadow/lights/light_range.hpp"
#include "src/shadow/view/near_rectangle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace edgeshade {
namespace {

void setShading(gl::Program& program, const SurfaceShading& shading, const glm::dvec3& eye) {
    program.set("u_maskValue", shading.maskValue);
    program.set("u_farthest", shading.farthest);
    program.set("u_ambient", shading.ambient);
    program.set("u_diffuse", shading.diffuse);
    if (!shading.light) return;
    const glm::dvec4& light = shading.light->position;
    if (light.w == 0.0) {
        program.set("u_towardsLight", glm::vec3(unitOf(glm::dvec3(light))));
    } else {
        program.set("u_light", glm::vec3(glm::dvec3(light) / light.w - eye));
        program.set("u_inverseRange", static_cast<float>(1.0 / shading.light->range));
    }
}

void setCone(gl::Program& program, const Cone& cone, const BatchView& view) {
    const ConeWindow window(cone);
    program.set("u_inverseOuter", window.inverseOuter);
    program.set("u_coneScale", window.scale);
    program.set("u_coneFromObject", view.coneFromObject);
}

void setFullShading(gl::Program& program, const FullShading& full) {
    program.set("u_ambientSlope", full.ambientSlope);
    program.set("u_exposure", full.exposure);
    program.set("u_lightColor", full.lightColor);
    program.set("u_eye", full.eye);
}

/// Number of texture units that the lookups of light.glsl take; the environment and the material's
/// textures follow.
constexpr int unitsOfLookups(const SurfaceShading& shading) {
    if (shading.map) return 1 + shading.map->units();
    if (shading.primitives) return shading.primitives->cutouts ? 5 : 4;
    if (shading.visibility || shading.listed) return 2;
    return shading.coarse ? 3 : 1;
}

void setPcss(gl::Program& program, const PcssLight& light) {
    program.set("u_lightRadius", light.radius);
    program.set("u_lightAcross", light.across);
    program.set("u_lightUp", light.up);
    program.set("u_lightFacing", light.facing);
    program.set("u_leastSpread", light.leastSpread);
    program.set("u_nearestCaster", light.nearestCaster);
}

void setMap(gl::Program& program, const ShadowMapLookup& map, const BatchView& view, bool casts) {
    const GLenum target = map.faces > 0 ? GL_TEXTURE_2D : GL_TEXTURE_CUBE_MAP;
    constexpr const char* faces[] = {"u_face0", "u_face1", "u_face2",
                                     "u_face3", "u_face4", "u_face5"};
    for (int face = 0; face < std::max(map.faces, 1); ++face) {
        glActiveTexture(GL_TEXTURE1 + static_cast<GLenum>(face));
        glBindTexture(target, map.textures[static_cast<std::size_t>(face)]);
        program.setSampler(map.faces > 0 ? faces[face] : "u_map", 1 + face);
    }
    program.set("u_mapFromObject", view.mapFromObject);
    program.set("u_mapFromWorld", glm::mat3(map.mapFromWorld));
    program.set("u_mapStep", map.step);
    program.set("u_mapTexel", map.texel);
    program.set("u_mapBias", map.biasTexels);
    program.set("u_mapShare", map.share);
    program.set("u_mapScale", map.mapScale);
    if (map.cascadeCount > 0) {
        program.set("u_cascades[0]",
                    std::span<const glm::vec4>(map.cascades).first(map.cascadeCount));
        program.set("u_cascadeMargin", map.cascadeMargin);
    }
    if (map.further) map.further->set(program, 1 + std::max(map.faces, 1));
    program.set("u_casts", casts ? 1.0f : 0.0f);
    if (map.pcss) setPcss(program, *map.pcss);
}

void setPrimitiveMap(gl::Program& program, const GpuPrimitiveMap& map, const BatchView& view,
                     float lightSide) {
    const auto bind = [&](int unit, const gl::FloatTable& table, const char* sampler,
                          const char* size) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D, table.texture());
        program.setSampler(sampler, unit);
        program.set(size, table.size());
    };
    bind(1, map.header, "u_primitiveHeader", "u_primitiveHeaderSize");
    bind(2, map.entries, "u_primitiveEntries", "u_primitiveEntriesSize");
    bind(3, map.records, "u_primitiveRecords", "u_primitiveRecordsSize");
    program.set("u_primitiveSize", map.size);
    program.set("u_mapHand", glm::determinant(glm::dmat3(map.mapFromWorld)) < 0.0 ? -1.0f : 1.0f);
    if (map.cutouts) {
        glActiveTexture(GL_TEXTURE4);
        glBindTexture(GL_TEXTURE_2D, map.cutouts->texture.name());
        program.setSampler("u_primitiveAlpha", 4);
        program.set("u_primitiveAlphaTexel", 1.0f / map.cutouts->size);
    }
    program.set("u_lightSide", lightSide);
    program.set("u_mapFromObject", view.mapFromObject);
    program.set("u_mapOrigin", view.mapOrigin);
    program.set("u_mapOriginRest", view.mapOriginRest);
}

/// Sets the light's points, see shaders_es2/primitive_map_points.glsl.
void setPlaces(gl::Program& program, const GpuPrimitiveMap& map, const SurfaceShading& shading) {
    std::array<std::array<glm::vec4, placesAtOnce / 4>, 4> places{}; // x, y, z, counted
    for (std::size_t i = 0; i < shading.places.size(); ++i) {
        const glm::dvec4 place = map.mapFromWorld * shading.places[i].position;
        const auto four = static_cast<glm::length_t>(i % 4);
        for (glm::length_t axis = 0; axis < 3; ++axis)
            places[static_cast<std::size_t>(axis)][i / 4][four] = static_cast<float>(place[axis]);
        places[3][i / 4][four] = 1.0f;
    }
    program.set("u_placesX[0]", std::span<const glm::vec4>(places[0]));
    program.set("u_placesY[0]", std::span<const glm::vec4>(places[1]));
    program.set("u_placesZ[0]", std::span<const glm::vec4>(places[2]));
    program.set("u_placesCounted[0]", std::span<const glm::vec4>(places[3]));
    program.set("u_placesW", static_cast<float>(shading.places.front().position.w));
    program.set("u_mapEye", glm::vec4(map.mapFromWorld * shading.eye));
}

void addPrimitiveMapDefines(GpuPrimitiveMap::Kind kind, int longestList,
                            std::vector<std::string>& defines) {
    defines.push_back("PRIMITIVE_MAP");
    if (kind == GpuPrimitiveMap::Kind::directional) defines.push_back("PRIMITIVE_MAP_DIRECTIONAL");
    if (kind == GpuPrimitiveMap::Kind::sixTiles) defines.push_back("PRIMITIVE_MAP_TILES");
    defines.push_back("PRIMITIVE_MAP_LONGEST " + std::to_string(longestList));
}

void setPlaneSpace(gl::Program& program, const PlaneSpace& space) {
    program.set("u_tangents", space.tangents);
    program.set("u_middle", space.middle);
    program.set("u_focal", space.focal);
    if (space.depthRange)
        program.set("u_depthRange", *space.depthRange);
    else
        program.set("u_near", space.near);
}

void setCoarseMask(gl::Program& program, const CoarseMaskLookup& mask, bool casts) {
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, mask.surface);
    program.setSampler("u_coarseSurface", 1);
    glActiveTexture(GL_TEXTURE2);
    glBindTexture(GL_TEXTURE_2D, mask.lit);
    program.setSampler("u_coarseLit", 2);
    setPlaneSpace(program, mask.space);
    program.set("u_coarseSize", mask.size);
    program.set("u_coarseTexel", mask.texel);
    program.set("u_coarseSlack", mask.slack);
    program.set("u_coarseLight", mask.light);
    program.set("u_casts", casts ? 1.0f : 0.0f);
}

void setVisibility(gl::Program& program, const VisibilityLookup& visibility) {
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, visibility.texture);
    program.setSampler("u_visibility", 1);
    program.set("u_visibilityTexel", 1.0f / visibility.size);
}

/// Sets alpha in place of the material's own.
void setAlphaLookup(gl::Program& program, const AlphaLookup& alpha) {
    program.set("u_baseColor", glm::vec4(1.0f, 1.0f, 1.0f, alpha.factor));
    program.set("u_alphaCutoff", alpha.cutoff);
    program.set("u_alphaChannel", alpha.channel);
    program.set("u_texcoordTransform", alpha.texcoordTransform);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, alpha.texture);
    program.setSampler("u_texture", 0);
}

/// Shading of an unlit material: its whole colour with ambient light, and black in passes that add
/// light. There it is drawn too, since only the first of coinciding surfaces is lit.
SurfaceShading unlitShading(SurfaceShading shading) {
    shading.ambient = shading.addsLight() ? 0.0f : 1.0f;
    shading.light.reset();
    shading.listed = nullptr;
    shading.withAmbient = false;
    shading.map = nullptr;
    shading.primitives = nullptr;
    shading.coarse = nullptr;
    shading.visibility = nullptr;
    return shading;
}

/// Shading of a ground that catches shadow: all lights together show the whole background, whatever
/// their colours and intensities.
SurfaceShading catcherShading(SurfaceShading shading) {
    if (shading.full) {
        shading.ambient += shading.full->ambientSlope; // of a surface that faces up
        shading.full->ambientSlope = 0.0f;
        shading.full->exposure = 1.0f;
    }
    shading.ambient = std::min(shading.ambient, 1.0f);
    shading.diffuse =
        (1.0f - shading.ambient) * static_cast<float>(shading.weight / shading.lights);
    return shading;
}

/// A casting chunk's triangles with their sides for a primitive map's light; null: not needed, or
/// an animation moves them.
const SidedChunk* sidedOf(const SurfaceChunk& chunk, const BatchView& view,
                          const SurfaceShading& shading) {
    return shading.primitives && !view.sided->empty() ? &(*view.sided)[chunk.place] : nullptr;
}

bool mayBeSeen(const SurfaceChunk& chunk, const BatchView& view) {
    if (isBeyond(chunk.bounds, view.light, view.range)) return false;
    return std::none_of(view.planes.begin(), view.planes.end(),
                        [&](const glm::dvec4& plane) { return isOutside(chunk.bounds, plane); });
}

/// Whether the scene culls the backs of surfaces with this material.
bool showsFrontAlone(const Material& material, const BatchView& view) {
    return view.culls && !material.doubleSided;
}

} // namespace

bool isOutOfView(const GpuBatch& batch, const ViewPlanes& planes) {
    return std::any_of(planes.begin(), planes.end(), [&](const glm::dvec4& plane) {
        const glm::dvec4 ofBatch = glm::transpose(batch.worldFromBatch) * plane;
        return std::all_of(
            batch.surfaces->begin(), batch.surfaces->end(),
            [&](const SurfaceChunk& chunk) { return isOutside(chunk.bounds, ofBatch); });
    });
}

BatchView surfaceViewOf(const GpuScene& scene, const GpuBatch& batch, const FrameView& view,
                        const DepthSlice& slice, const SurfaceShading& shading) {
    BatchView result = batchViewOf(batch, view, slice);
    const auto number = static_cast<std::size_t>(&batch - scene.batches.data());
    if (shading.light && shading.light->isSpot())
        result.coneFromObject = glm::mat4(coneFromWorld(*shading.light) * batch.worldFromBatch);
    if (shading.light && shading.light->hasRange() && shading.addsLight()) {
        result.light = glm::dvec3(glm::inverse(batch.worldFromBatch) * shading.light->position);
        result.range = rangeInObject(*shading.light, batch.worldFromBatch);
    }
    if (shading.map)
        result.mapFromObject = glm::mat4(shading.map->mapFromWorld * batch.worldFromBatch);
    if (shading.primitives) {
        const glm::dmat4 mapFromObject = shading.primitives->mapFromWorld * batch.worldFromBatch;
        const glm::dvec3 origin(glm::inverse(mapFromObject)[3]);
        result.mapFromObject = glm::mat4(mapFromObject);
        result.mapOrigin = glm::vec3(origin);
        result.mapOriginRest = glm::vec3(origin - glm::dvec3(result.mapOrigin));
        result.sided = &shading.primitives->sided[number];
    }
    return result;
}

/// First texture unit for material textures. Binds the environment to the unit before it if the
/// pass samples it.
int SurfacePass::firstUnit(const SurfaceShading& shading, const gl::Program& program) {
    const int unit = unitsOfLookups(shading);
    if (shading.addsLight()) return unit;
    shading.full->environment->bind(program, unit);
    return unit + 1;
}

const std::array<SurfacePass::Attribute, 8> SurfacePass::attributes_ = {{
    {"a_position", 3, GL_FLOAT, offsetof(SurfaceVertex, position), Buffer::vertices,
     [](const Variant&) { return true; }},
    {"a_texcoord", 2, GL_FLOAT, offsetof(SurfaceVertex, texcoord), Buffer::vertices,
     [](const Variant& of) { return of.textured || (of.material && of.material->takes(0)); }},
    {"a_color", 4, GL_UNSIGNED_BYTE, offsetof(SurfaceVertex, color), Buffer::vertices,
     [](const Variant& of) { return of.colored; }},
    {"a_normal", 3, GL_FLOAT, offsetof(SurfaceVertex, normal), Buffer::vertices,
     [](const Variant& of) { return of.lit || of.plain || of.material || of.lightList > 0; }},
    {"a_tangent", 4, GL_FLOAT, offsetof(SurfaceDetail, tangent), Buffer::details,
     [](const Variant& of) { return of.material && of.material->tangents; }},
    {"a_texcoord1", 2, GL_FLOAT, offsetof(SurfaceDetail, texcoords), Buffer::details,
     [](const Variant& of) { return of.material && of.material->takes(1); }},
    {"a_texcoord23", 4, GL_FLOAT, offsetof(SurfaceDetail, texcoords) + sizeof(glm::vec2),
     Buffer::details,
     [](const Variant& of) {
         return of.material && (of.material->takes(2) || of.material->takes(3));
     }},
    {"a_lightSide", 1, GL_FLOAT, offsetof(SidedVertex, lightSide), Buffer::vertices,
     [](const Variant& of) { return of.sided; }},
}};

/// Adds to the variant how full shading draws the chunk, if shading is full.
void SurfacePass::addMaterial(const GpuScene& scene, const SurfaceChunk& chunk,
                              const SurfaceShading& shading, Variant& variant) const {
    const Material& material = scene.materials[chunk.material];
    if (!shading.full || shading.mask || shading.geometryAlone() || shading.tintPrimitives) return;
    variant.linear = shading.full->linear;
    if (variant.catcher) {
        variant.plain =
            shading.lights == 1.0 && shading.weight == 1.0; // otherwise several lights add up
        return;
    }
    if (material.unlit) return;
    variant.softTerminator = (variant.lit || variant.lightList > 0) &&
                             shading.full->softTerminator && chunk.smooth && derivatives_;
    const bool simple = material.isPlain() && material.alphaMode != AlphaMode::blend;
    if (simple && shading.full->plainIsShort) {
        variant.plain = true;
        return;
    }
    const bool ambient = !shading.addsLight();
    variant.material = featuresOf(scene, chunk, ambient, derivatives_,
                                  textureUnits_ - unitsOfLookups(shading) - (ambient ? 1 : 0));
    variant.textured = false;
    variant.falloff = variant.lit && shading.light->photometric && shading.light->position.w != 0.0;
}

SurfacePass::Variant SurfacePass::variantOf(const GpuScene& scene, const SurfaceChunk& chunk,
                                            const SurfaceShading& shading) const {
    const Material& material = scene.materials[chunk.material];
    Variant variant{};
    variant.alphaMode = material.alphaMode;
    if (shading.map) variant.map = shading.map->defines;
    variant.softMap = shading.map && shading.map->soft;
    variant.pcss = variant.softMap && shading.map->pcss;
    variant.rectangle = variant.pcss && shading.map->pcss->rectangle;
    if (shading.primitives)
        variant.primitives = {shading.primitives->kind, shading.primitives->longestList,
                              shading.primitives->cutouts != nullptr, !shading.places.empty(),
                              shading.tintPrimitives};
    variant.textured = scene.textures.has(material.baseColor());
    variant.catcher = material.ground == GroundMaterial::catcher && !shading.mask &&
                      !shading.geometryAlone() && !shading.tintPrimitives;
    variant.colored = chunk.colored && (variant.catcher || material.ground == GroundMaterial::none);
    variant.lit = shading.light.has_value();
    variant.lightList = shading.listed ? shading.listed->longest : 0;
    variant.withAmbient = variant.lit && shading.withAmbient;
    variant.directional = variant.lit && shading.light->position.w == 0.0;
    variant.ranged = variant.lit && shading.light->hasRange();
    variant.spot = variant.lit && shading.light->isSpot();
    variant.mask = shading.mask;
    variant.sliced = std::isfinite(shading.farthest);
    variant.coarse = shading.coarse != nullptr;
    variant.visibility = shading.visibility != nullptr;
    variant.planes = shading.planes != nullptr;
    variant.nearness = shading.nearness != nullptr;
    const PlaneSpace* space = shading.coarse ? &shading.coarse->space : shading.geometryAlone();
    variant.orthographic = space && space->depthRange;
    addMaterial(scene, chunk, shading, variant);
    return variant;
}

gl::Program& SurfacePass::program(const Variant& variant) {
    auto found = programs_.find(variant);
    if (found != programs_.end()) return found->second;
    std::vector<std::string> defines;
    if (variant.alphaMode == AlphaMode::mask) defines.push_back("ALPHA_TEST");
    if (variant.alphaMode == AlphaMode::blend) defines.push_back("BLENDED");
    if (variant.material) addDefines(*variant.material, defines);
    if (variant.falloff) defines.push_back("FALLOFF");
    if (variant.plain) defines.push_back("PLAIN");
    if (variant.catcher) defines.push_back("CATCHER");
    if (variant.softTerminator) defines.push_back("SOFT_TERMINATOR");
    if (variant.linear) defines.push_back("LINEAR");
    if (variant.textured) defines.push_back("TEXTURED");
    if (variant.alphaLookup) defines.push_back("ALPHA_LOOKUP");
    if (variant.colored) defines.push_back("COLORED");
    if (variant.lit) defines.push_back("LIT");
    if (variant.lightList > 0) defines.push_back("LIGHT_LIST " + std::to_string(variant.lightList));
    if (derivatives_) defines.push_back("DERIVATIVES");
    if (variant.withAmbient) defines.push_back("WITH_AMBIENT");
    if (variant.directional) defines.push_back("DIRECTIONAL");
    if (variant.ranged) defines.push_back("RANGED");
    if (variant.spot) defines.push_back("SPOT");
    if (variant.mask) defines.push_back("MASK");
    if (variant.sliced) defines.push_back("SLICED");
    if (variant.map) {
        defines.push_back("MAP");
        defines.insert(defines.end(), variant.map->begin(), variant.map->end());
        if (variant.softMap) defines.push_back("SOFT_MAP");
        if (variant.pcss) defines.push_back("PCSS");
        if (variant.rectangle) defines.push_back("PCSS_RECTANGLE");
    }
    if (variant.primitives)
        addPrimitiveMapDefines(variant.primitives->kind, variant.primitives->longestList, defines);
    if (variant.primitives && variant.primitives->cutouts)
        defines.push_back("PRIMITIVE_MAP_CUTOUTS");
    if (variant.primitives && variant.primitives->points) defines.push_back("PRIMITIVE_MAP_POINTS");
    if (variant.sided) defines.push_back("SIDED");
    if (variant.selfShadowed) defines.push_back("SELF_SHADOWED");
    if (variant.primitives && variant.primitives->tint) defines.push_back("PRIMITIVE_MAP_TINT");
    if (variant.coarse) defines.push_back("COARSE_MASK");
    if (variant.visibility) defines.push_back("VISIBILITY");
    if (variant.coarse || variant.planes || variant.nearness) defines.push_back("PLANE");
    if (variant.nearness) defines.push_back("NEARNESS_ALONE");
    if (variant.orthographic) defines.push_back("ORTHOGRAPHIC");
    std::vector<std::string> names;
    for (const Attribute& attribute : attributes_)
        if (attribute.isOf(variant)) names.push_back(attribute.name);
    return programs_
        .emplace(variant,
                 gl::Program(shaders::surface_vert,
                             variant.planes || variant.nearness ? shaders::coarse_surface_frag
                             : variant.material                 ? shaders::material_frag
                                                                : shaders::surface_frag,
                             defines, names))
        .first->second;
}

std::size_t SurfacePass::draw(const GpuScene& scene, const GpuBatch& batch, const BatchView& view,
                              const glm::dvec3& eye, const SurfaceShading& shading,
                              AlphaMode kind) {
    std::size_t runs = 0;
    for (const SurfaceChunk& chunk : *batch.surfaces) {
        const Material& material = scene.materials[chunk.material];
        if (material.alphaMode != kind) continue;
        std::optional<CullScope> frontAlone;
        if (showsFrontAlone(material, view)) frontAlone.emplace(view.mirrored ? GL_FRONT : GL_BACK);
        runs += drawChunk(scene, chunk, view, eye, shading);
    }
    return runs;
}

std::size_t SurfacePass::drawChunk(const GpuScene& scene, const SurfaceChunk& chunk,
                                   const BatchView& view, const glm::dvec3& eye,
                                   const SurfaceShading& shading) {
    if (!mayBeSeen(chunk, view)) return 0;
    const bool shaded = !shading.mask && !shading.geometryAlone();
    if (shaded && scene.materials[chunk.material].unlit)
        return drawSeen(scene, chunk, view, eye, unlitShading(shading));
    if (shaded && scene.materials[chunk.material].ground == GroundMaterial::catcher)
        return drawSeen(scene, chunk, view, eye, catcherShading(shading));
    return drawSeen(scene, chunk, view, eye, shading);
}

std::size_t SurfacePass::drawSeen(const GpuScene& scene, const SurfaceChunk& chunk,
                                  const BatchView& view, const glm::dvec3& eye,
                                  const SurfaceShading& shading) {
    const Material& material = scene.materials[chunk.material];
    const bool casts = shading.map || shading.primitives ? scene.castsInMaps(material)
                                                         : material.casts(scene.castMasked);
    const SidedChunk* sided = casts ? sidedOf(chunk, view, shading) : nullptr;
    Variant variant = variantOf(scene, chunk, shading);
    variant.sided = sided && sided->lightSide == 0.0f;
    variant.selfShadowed = shading.selfShadowed && scene.castsInMaps(material);
    variant.alphaLookup = view.alpha != nullptr;
    variant.textured = variant.textured || variant.alphaLookup;
    gl::Program& used = program(variant);
    used.use();
    setShading(used, shading, eye);
    if (variant.spot) setCone(used, *shading.light->cone, view);
    if (shading.map) setMap(used, *shading.map, view, casts);
    if (shading.primitives)
        setPrimitiveMap(used, *shading.primitives, view, sided ? sided->lightSide : 0.0f);
    if (!shading.places.empty()) setPlaces(used, *shading.primitives, shading);
    if (shading.coarse) setCoarseMask(used, *shading.coarse, casts);
    if (shading.visibility) setVisibility(used, *shading.visibility);
    if constexpr (listsLights)
        if (shading.listed) setLightTable(used, *shading.listed, 1);
    if (shading.geometryAlone()) setPlaneSpace(used, *shading.geometryAlone());
    used.set("u_clipFromObject", view.clipFromObject);
    used.set("u_eyeOffsetFromObject", view.eyeOffsetFromObject);
    used.set("u_normalFromObject", view.normalFromObject);
    used.set("u_mirrored", view.mirrored ? -1.0f : 1.0f);
    used.set("u_baseColor", variant.catcher ? glm::vec4(shading.background, 1.0f)
                                            : srgbFromLinear(material.baseColorFactor));
    used.set("u_alphaCutoff", material.alphaCutoff);
    if (shading.full) setFullShading(used, *shading.full);
    if (variant.material)
        setMaterial(used, *variant.material, material, scene.textures, firstUnit(shading, used));
    if (variant.alphaLookup) {
        setAlphaLookup(used, *view.alpha);
    } else if (variant.textured) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, scene.textures.of(material.baseColor()));
        used.setSampler("u_texture", 0);
    }

    AttributeBinding binding(nullptr);
    const gl::Buffer& vertices = variant.sided ? sided->vertices : chunk.vertices;
    const gl::Buffer& details = variant.sided ? sided->details : chunk.details;
    const std::size_t stride = variant.sided ? sizeof(SidedVertex) : sizeof(SurfaceVertex);
    for (const Attribute& attribute : attributes_)
        if (attribute.isOf(variant)) {
            const bool detail = attribute.buffer == Buffer::details;
            binding.add(detail ? details : vertices, attribute.components, attribute.type,
                        attribute.type == GL_UNSIGNED_BYTE, detail ? sizeof(SurfaceDetail) : stride,
                        attribute.offset, false);
        }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, (variant.sided ? sided->indices : chunk.indices).name());
    if (variant.sided)
        glDrawElements(GL_TRIANGLES, chunk.indexCount, GL_UNSIGNED_SHORT, nullptr);
    else
        glDrawElements(GL_TRIANGLES, chunk.indexCount, GL_UNSIGNED_SHORT, nullptr);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    return static_cast<std::size_t>(chunk.indexCount);
}

} // namespace edgeshade
