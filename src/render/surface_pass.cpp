#include "src/render/surface_pass.hpp"

#include "shaders_es2.hpp"
#include "src/render/attributes.hpp"
#include "src/scene/srgb.hpp"

#include <cstddef>

namespace edgeshade {
namespace {

gl::Program makeProgram(const std::vector<std::string>& defines) {
    return {shaders::surface_vert,
            shaders::surface_frag,
            defines,
            {"a_position", "a_normal", "a_texcoord", "a_color"}};
}

void setShading(gl::Program& program, const SurfaceShading& shading, const glm::dvec3& eye) {
    const glm::dvec4& light = shading.light.position;
    program.set("u_light", glm::vec4(glm::dvec3(light) - eye * light.w, light.w));
    program.set("u_ambient", shading.ambient);
    program.set("u_diffuse", shading.diffuse);
    program.set("u_mask", shading.mask ? 1.0f : 0.0f);
    program.set("u_maskValue", shading.maskValue);
}

} // namespace

SurfacePass::SurfacePass() {
    programs_.emplace(AlphaMode::opaque, makeProgram({}));
    programs_.emplace(AlphaMode::mask, makeProgram({"ALPHA_TEST"}));
    programs_.emplace(AlphaMode::blend, makeProgram({"BLENDED"}));
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
    gl::Program& program = programs_.at(material.alphaMode);
    program.use();
    setShading(program, shading, eye);
    program.set("u_clipFromObject", view.clipFromObject);
    program.set("u_eyeOffsetFromObject", view.eyeOffsetFromObject);
    program.set("u_normalFromObject", view.normalFromObject);
    program.set("u_mirrored", view.mirrored ? -1.0f : 1.0f);
    program.set("u_baseColor", srgbFromLinear(material.baseColorFactor));
    program.set("u_alphaCutoff", material.alphaCutoff);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, scene.textures.of(material));
    program.setSampler("u_texture", 0);

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
