#include "src/render/frame/surface_pass.hpp"

#include "shaders_es2.hpp"
#include "src/render/drawing/attributes.hpp"
#include "src/scene/srgb.hpp"
#include "src/shadow/geometry/box_plane.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace edgeshade {
namespace {

/// Of length 1; scaled first, so that no double under- or overflows.
glm::vec3 directionOf(const glm::dvec4& light) {
    const glm::dvec3 scaled =
        glm::dvec3(light) / std::max({std::abs(light.x), std::abs(light.y), std::abs(light.z)});
    return glm::vec3(glm::normalize(scaled));
}

void setShading(gl::Program& program, const SurfaceShading& shading, const glm::dvec3& eye) {
    program.set("u_maskValue", shading.maskValue);
    program.set("u_farthest", shading.farthest);
    program.set("u_ambient", shading.ambient);
    if (!shading.light) return;
    const glm::dvec4& light = shading.light->position;
    if (light.w == 0.0) {
        program.set("u_towardsLight", directionOf(light));
    } else {
        program.set("u_light", glm::vec3(glm::dvec3(light) / light.w - eye));
        program.set("u_inverseRange", static_cast<float>(1.0 / shading.light->range));
    }
    program.set("u_diffuse", shading.diffuse);
}

/// See shaders_es2/light_window.glsl. Where the angles are the same the edge is a thousandth wide,
/// of a narrow cone as of a wide one.
void setCone(gl::Program& program, const Cone& cone, const BatchView& view) {
    const auto fromOne = [](double angle) { // 1 - cos(angle), which rounding leaves its digits
        const double half = std::sin(0.5 * angle);
        return 2.0 * half * half;
    };
    const double outer = fromOne(cone.outer), inner = fromOne(cone.inner);
    program.set("u_inverseOuter", static_cast<float>(1.0 / outer));
    program.set("u_coneScale", static_cast<float>(outer / std::max(outer - inner, 1e-3 * outer)));
    program.set("u_coneFromObject", view.coneFromObject);
}

void setMap(gl::Program& program, const ShadowMapLookup& map, const BatchView& view, bool casts) {
    const bool apart = map.kind == ShadowMapKind::pointApart;
    const GLenum target = map.kind == ShadowMapKind::point ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    constexpr const char* faces[] = {"u_face0", "u_face1", "u_face2",
                                     "u_face3", "u_face4", "u_face5"};
    for (int face = 0; face < (apart ? 6 : 1); ++face) {
        glActiveTexture(GL_TEXTURE1 + static_cast<GLenum>(face));
        glBindTexture(target, map.textures[static_cast<std::size_t>(face)]);
        program.setSampler(apart ? faces[face] : "u_map", 1 + face);
    }
    program.set("u_mapFromObject", view.mapFromObject);
    program.set("u_mapFromWorld", glm::mat3(map.mapFromWorld));
    program.set("u_mapStep", map.step);
    program.set("u_mapTexel", map.texel);
    program.set("u_mapBias", map.biasTexels);
    program.set("u_casts", casts ? 1.0f : 0.0f);
}

void setPrimitiveMap(gl::Program& program, const GpuPrimitiveMap& map, const BatchView& view) {
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
    program.set("u_mapFromObject", view.mapFromObject);
}

void addPrimitiveMapDefines(GpuPrimitiveMap::Kind kind, int splits, int longestList,
                            std::vector<std::string>& defines) {
    defines.push_back("PRIMITIVE_MAP");
    if (kind == GpuPrimitiveMap::Kind::directional) defines.push_back("PRIMITIVE_MAP_DIRECTIONAL");
    if (kind == GpuPrimitiveMap::Kind::sixTiles) defines.push_back("PRIMITIVE_MAP_TILES");
    defines.push_back("PRIMITIVE_MAP_SPLITS " + std::to_string(splits));
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

/// What an unlit material draws: all of its colour with ambient light, and black for what adds
/// light, which of surfaces that coincide is drawn for the first as well.
SurfaceShading unlitShading(SurfaceShading shading) {
    const bool addsLight = shading.light && !shading.withAmbient;
    shading.ambient = addsLight ? 0.0f : 1.0f;
    shading.light.reset();
    shading.withAmbient = false;
    shading.map = nullptr;
    shading.primitives = nullptr;
    shading.coarse = nullptr;
    return shading;
}

/// Which side the light is on is decided once a triangle, on the CPU.
void drawByFacing(const FacingIndices& indices, gl::Program& program) {
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.indices.name());
    const auto draw = [&](float lightSide, int first, int count) {
        if (count == 0) return;
        program.set("u_lightSide", lightSide);
        glDrawElements(
            GL_TRIANGLES, count, GL_UNSIGNED_SHORT,
            reinterpret_cast<const void*>(static_cast<std::size_t>(first) * sizeof(std::uint16_t)));
    };
    draw(-1.0f, 0, indices.before);
    draw(1.0f, indices.before, indices.facing);
    draw(-1.0f, indices.before + indices.facing, indices.after);
}

bool mayBeSeen(const SurfaceChunk& chunk, const BatchView& view) {
    return std::none_of(view.planes.begin(), view.planes.end(),
                        [&](const glm::dvec4& plane) { return isOutside(chunk.bounds, plane); });
}

} // namespace

const std::array<SurfacePass::Attribute, 4> SurfacePass::attributes_ = {{
    {"a_position", 3, GL_FLOAT, offsetof(SurfaceVertex, position), nullptr},
    {"a_texcoord", 2, GL_FLOAT, offsetof(SurfaceVertex, texcoord), &Variant::textured},
    {"a_color", 4, GL_UNSIGNED_BYTE, offsetof(SurfaceVertex, color), &Variant::colored},
    {"a_normal", 3, GL_FLOAT, offsetof(SurfaceVertex, normal), &Variant::lit},
}};

SurfacePass::Variant SurfacePass::variantOf(const GpuScene& scene, const SurfaceChunk& chunk,
                                            const SurfaceShading& shading) {
    const Material& material = scene.materials[chunk.material];
    Variant variant{};
    variant.alphaMode = material.alphaMode;
    if (shading.map) variant.map = shading.map->kind;
    if (shading.primitives)
        variant.primitives = {shading.primitives->kind, shading.primitives->splits,
                              shading.primitives->longestList, shading.tintPrimitives};
    variant.textured = scene.textures.has(material);
    variant.colored = chunk.colored;
    variant.lit = shading.light.has_value();
    variant.withAmbient = variant.lit && shading.withAmbient;
    variant.directional = variant.lit && shading.light->position.w == 0.0;
    variant.ranged = variant.lit && shading.light->hasRange();
    variant.spot = variant.lit && shading.light->isSpot();
    variant.mask = shading.mask;
    variant.sliced = std::isfinite(shading.farthest);
    variant.coarse = shading.coarse != nullptr;
    variant.planes = shading.planes != nullptr;
    const PlaneSpace* space = shading.planes   ? shading.planes
                              : shading.coarse ? &shading.coarse->space
                                               : nullptr;
    variant.orthographic = space && space->depthRange;
    return variant;
}

gl::Program& SurfacePass::program(const Variant& variant) {
    auto found = programs_.find(variant);
    if (found != programs_.end()) return found->second;
    std::vector<std::string> defines;
    if (variant.alphaMode == AlphaMode::mask) defines.push_back("ALPHA_TEST");
    if (variant.alphaMode == AlphaMode::blend) defines.push_back("BLENDED");
    if (variant.textured) defines.push_back("TEXTURED");
    if (variant.colored) defines.push_back("COLORED");
    if (variant.lit) defines.push_back("LIT");
    if (variant.withAmbient) defines.push_back("WITH_AMBIENT");
    if (variant.directional) defines.push_back("DIRECTIONAL");
    if (variant.ranged) defines.push_back("RANGED");
    if (variant.spot) defines.push_back("SPOT");
    if (variant.mask) defines.push_back("MASK");
    if (variant.sliced) defines.push_back("SLICED");
    if (variant.map) {
        defines.push_back("MAP");
        defines.push_back("PCF " + std::to_string(pcf_));
        if (*variant.map == ShadowMapKind::directional) defines.push_back("MAP_DIRECTIONAL");
        if (*variant.map == ShadowMapKind::pointApart) defines.push_back("MAP_APART");
    }
    if (variant.primitives)
        addPrimitiveMapDefines(variant.primitives->kind, variant.primitives->splits,
                               variant.primitives->longestList, defines);
    if (variant.primitives && variant.primitives->tint) defines.push_back("PRIMITIVE_MAP_TINT");
    if (variant.coarse) defines.push_back("COARSE_MASK");
    if (variant.coarse || variant.planes) defines.push_back("PLANE");
    if (variant.orthographic) defines.push_back("ORTHOGRAPHIC");
    std::vector<std::string> names;
    for (const Attribute& attribute : attributes_)
        if (attribute.isOf(variant)) names.push_back(attribute.name);
    return programs_
        .emplace(variant,
                 gl::Program(shaders::surface_vert,
                             variant.planes ? shaders::coarse_surface_frag : shaders::surface_frag,
                             defines, names))
        .first->second;
}

std::size_t SurfacePass::draw(const GpuScene& scene, const GpuBatch& batch, const BatchView& view,
                              const glm::dvec3& eye, const SurfaceShading& shading,
                              AlphaMode kind) {
    std::size_t runs = 0;
    for (const SurfaceChunk& chunk : batch.surfaces)
        if (scene.materials[chunk.material].alphaMode == kind)
            runs += drawChunk(scene, chunk, view, eye, shading);
    return runs;
}

std::size_t SurfacePass::drawChunk(const GpuScene& scene, const SurfaceChunk& chunk,
                                   const BatchView& view, const glm::dvec3& eye,
                                   const SurfaceShading& shading) {
    if (!mayBeSeen(chunk, view)) return 0;
    const bool shaded = !shading.mask && !shading.planes;
    if (shaded && scene.materials[chunk.material].unlit)
        return drawSeen(scene, chunk, view, eye, unlitShading(shading));
    return drawSeen(scene, chunk, view, eye, shading);
}

std::size_t SurfacePass::drawSeen(const GpuScene& scene, const SurfaceChunk& chunk,
                                  const BatchView& view, const glm::dvec3& eye,
                                  const SurfaceShading& shading) {
    const Material& material = scene.materials[chunk.material];
    const bool casts = material.alphaMode == AlphaMode::opaque || scene.castMasked;
    const Variant variant = variantOf(scene, chunk, shading);
    gl::Program& used = program(variant);
    used.use();
    setShading(used, shading, eye);
    if (variant.spot) setCone(used, *shading.light->cone, view);
    if (shading.map) setMap(used, *shading.map, view, casts);
    if (shading.primitives) setPrimitiveMap(used, *shading.primitives, view);
    if (shading.coarse) setCoarseMask(used, *shading.coarse, casts);
    if (shading.planes) setPlaneSpace(used, *shading.planes);
    used.set("u_clipFromObject", view.clipFromObject);
    used.set("u_eyeOffsetFromObject", view.eyeOffsetFromObject);
    used.set("u_normalFromObject", view.normalFromObject);
    used.set("u_mirrored", view.mirrored ? -1.0f : 1.0f);
    used.set("u_baseColor", srgbFromLinear(material.baseColorFactor));
    used.set("u_alphaCutoff", material.alphaCutoff);
    if (variant.textured) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, scene.textures.of(material));
        used.setSampler("u_texture", 0);
    }

    AttributeBinding binding(nullptr);
    for (const Attribute& attribute : attributes_)
        if (attribute.isOf(variant))
            binding.add(chunk.vertices, attribute.components, attribute.type,
                        attribute.type == GL_UNSIGNED_BYTE, sizeof(SurfaceVertex), attribute.offset,
                        false);
    if (shading.primitives && casts && !view.facings->empty()) {
        drawByFacing((*view.facings)[chunk.place], used);
    } else {
        used.set("u_lightSide", 0.0f);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, chunk.indices.name());
        glDrawElements(GL_TRIANGLES, chunk.indexCount, GL_UNSIGNED_SHORT, nullptr);
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    return static_cast<std::size_t>(chunk.indexCount);
}

} // namespace edgeshade
