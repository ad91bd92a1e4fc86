#include "src/render/drawing/caster_chunk.hpp"

#include "src/render/drawing/attributes.hpp"
#include "src/render/drawing/cap_alpha_test.hpp"

#include <cstddef>

namespace edgeshade {

std::size_t drawCasterChunk(const GpuScene& scene, const SurfaceChunk& chunk,
                            const gl::Program& program) {
    const Material& material = scene.materials[chunk.material];
    AttributeBinding binding(nullptr);
    constexpr std::size_t stride = sizeof(SurfaceVertex);
    binding.add(chunk.vertices, 3, GL_FLOAT, false, stride, offsetof(SurfaceVertex, position),
                false);
    if (material.alphaMode == AlphaMode::mask) {
        setAlphaLookup(program, alphaLookupOf(material, scene.textures));
        binding.add(chunk.vertices, 2, GL_FLOAT, false, stride, offsetof(SurfaceVertex, texcoord),
                    false);
        binding.add(chunk.vertices, 4, GL_UNSIGNED_BYTE, true, stride,
                    offsetof(SurfaceVertex, color), false);
    }
    return drawIndexed(chunk.indices, chunk.indexCount);
}

} // namespace edgeshade
