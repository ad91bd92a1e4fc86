#include "src/render/surface_pass.hpp"

#include "shaders_es2.hpp"
#include "src/render/attributes.hpp"
#include "src/scene/srgb.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace edgeshade {
namespace {

void setShading(gl::Program& program, const SurfaceShading& shading, const glm::dvec3& eye) {
    const glm::dvec4& light = shading.light.position;
    glm::dvec3 fromEye = glm::dvec3(light) - eye * light.w;
    // Only a sun's direction counts: scaled so that no double leaves the range of floats.
    if (light.w == 0.0)
        fromEye /= std::max({std::abs(fromEye.x), std::abs(fromEye.y), std::abs(fromEye.z)});
    program.set("u_light", glm::vec4(fromEye, light.w));
    program.set("u_inverseRange",
                shading.light.hasRange() ? static_cast<float>(1.0 / shading.light.range) : 0.0f);
    program.set("u_ambient", shading.ambient);
    program.set("u_diffuse", shading.diffuse);
    program.set("u_mask", shading.mask ? 1.0f : 0.0f);
    program.set("u_maskValue", shading.maskValue);
    program.set("u_farthest", shading.farthest);
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

void setPlaneSpace(gl::Program& program, const PlaneSpace& space) {
    program.set("u_tangents", space.tangents);
    program.set("u_focal", space.focal);
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

} // namespace

gl::Program& SurfacePass::program(const Variant& variant) {
    auto found = programs_.find(variant);
    if (found != programs_.end()) return found->second;
    std::vector<std::string> defines;
    if (variant.alphaMode == AlphaMode::mask) defines.push_back("ALPHA_TEST");
    if (variant.alphaMode == AlphaMode::blend) defines.push_back("BLENDED");
    if (variant.sliced) defines.push_back("SLICED");
    if (variant.map) {
        defines.push_back("MAP");
        defines.push_back("PCF " + std::to_string(pcf_));
        if (*variant.map == ShadowMapKind::sun) defines.push_back("MAP_SUN");
        if (*variant.map == ShadowMapKind::pointApart) defines.push_back("MAP_APART");
    }
    if (variant.coarse) defines.push_back("COARSE_MASK");
    if (variant.coarse || variant.planes) defines.push_back("PLANE");
    return programs_
        .emplace(variant,
                 gl::Program(shaders::surface_vert,
                             variant.planes ? shaders::coarse_surface_frag : shaders::surface_frag,
                             defines, {"a_position", "a_normal", "a_texcoord", "a_color"}))
        .first->second;
}

void SurfacePass::draw(const GpuScene& scene, const GpuBatch& batch, const BatchView& view,
                       const glm::dvec3& eye, const SurfaceShading& shading, AlphaMode kind) {
    for (const SurfaceChunk& chunk : batch.surfaces)
        if (scene.materials[chunk.material].alphaMode == kind)
            drawChunk(scene, chunk, view, eye, shading);
}

void SurfacePass::drawChunk(const GpuScene& scene, const SurfaceChunk& chunk, const BatchView& view,
                            const glm::dvec3& eye, const SurfaceShading& shading) {
    const Material& material = scene.materials[chunk.material];
    const bool casts = material.alphaMode == AlphaMode::opaque || scene.castMasked;
    gl::Program& variant = program(
        {material.alphaMode, shading.map ? std::optional(shading.map->kind) : std::nullopt,
         std::isfinite(shading.farthest), shading.coarse != nullptr, shading.planes != nullptr});
    variant.use();
    setShading(variant, shading, eye);
    if (shading.map) setMap(variant, *shading.map, view, casts);
    if (shading.coarse) setCoarseMask(variant, *shading.coarse, casts);
    if (shading.planes) setPlaneSpace(variant, *shading.planes);
    variant.set("u_clipFromObject", view.clipFromObject);
    variant.set("u_eyeOffsetFromObject", view.eyeOffsetFromObject);
    variant.set("u_normalFromObject", view.normalFromObject);
    variant.set("u_mirrored", view.mirrored ? -1.0f : 1.0f);
    variant.set("u_baseColor", srgbFromLinear(material.baseColorFactor));
    variant.set("u_alphaCutoff", material.alphaCutoff);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, scene.textures.of(material));
    variant.setSampler("u_texture", 0);

    AttributeBinding binding(nullptr);
    constexpr std::size_t stride = sizeof(SurfaceVertex);
    binding.add(chunk.vertices, 3, GL_FLOAT, false, stride, offsetof(SurfaceVertex, position),
                false);
    binding.add(chunk.vertices, 3, GL_FLOAT, false, stride, offsetof(SurfaceVertex, normal), false);
    binding.add(chunk.vertices, 2, GL_FLOAT, false, stride, offsetof(SurfaceVertex, texcoord),
                false);
    binding.add(chunk.vertices, 4, GL_UNSIGNED_BYTE, true, stride, offsetof(SurfaceVertex, color),
                false);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, chunk.indices.name());
    glDrawElements(GL_TRIANGLES, chunk.indexCount, GL_UNSIGNED_SHORT, nullptr);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

} // namespace edgeshade
