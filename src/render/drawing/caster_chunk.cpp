#include "src/render/drawing/caster_chunk.hpp"

#include "src/render/drawing/attributes.hpp"

#include <cstddef>

namespace edgeshade {

void setCasterCutout(const GpuScene& scene, const Material& material, const gl::Program& program) {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, scene.textures.of(material.baseColor()));
    program.setSampler("u_texture", 0);
    program.set("u_alphaScale", material.baseColorFactor.a);
    program.set("u_alphaCutoff", material.alphaCutoff);
}

std::size_t drawCasterChunk(const GpuScene& scene, const SurfaceChunk& chunk,
                            const gl::Program& program) {
    const Material& material = scene.materials[chunk.material];
    AttributeBinding binding(nullptr);
    constexpr std::size_t stride = sizeof(SurfaceVertex);
    binding.add(chunk.vertices, 3, GL_FLOAT, false, stride, offsetof(SurfaceVertex, position),
                false);
    if (material.alphaMode == AlphaMode::mask) {
        setCasterCutout(scene, material, program);
        binding.add(chunk.vertices, 2, GL_FLOAT, false, stride, offsetof(SurfaceVertex, texcoord),
                    false);
        binding.add(chunk.vertices, 4, GL_UNSIGNED_BYTE, true, stride,
                    offsetof(SurfaceVertex, color), false);
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, chunk.indices.name());
    glDrawElements(GL_TRIANGLES, chunk.indexCount, GL_UNSIGNED_SHORT, nullptr);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    return static_cast<std::size_t>(chunk.indexCount);
}

} // namespace edgeshade
