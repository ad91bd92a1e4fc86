#include "src/render/volumes/published/caps_pass.hpp"

#include "shaders_es2/record_layout.glsl"
#include "src/render/drawing/attributes.hpp"

#include <algorithm>

namespace edgeshade {
CapsPass::CapsPass(MultiplicityMethod method, SidesLayout layout,
                   std::optional<gl::Instancing> instancing, std::vector<std::string> defines)
    : method_(method), layout_(layout), instancing_(instancing), defines_(std::move(defines)) {
    std::vector<glm::vec2> corners;
    for (int vertex = 0; vertex < VERTICES_PER_CAP_PAIR; ++vertex)
        corners.emplace_back(static_cast<float>(vertex), 0.0f);
    corners_ = gl::vertexBuffer<glm::vec2>(corners);
}

void CapsPass::prepare(const CapsVariant& variant) {
    if (!programs_.contains(variant))
        programs_.emplace(variant, makeCapsProgram(method_, layout_, variant, defines_));
}

const gl::Program& CapsPass::use(const CapsVariant& variant) const {
    const gl::Program& program = programs_.at(variant);
    program.use();
    return program;
}

void CapsPass::draw(const ShadowBuffers& shadow, const RecordRange& caps, bool alphaTested) const {
    const bool copied = layout_ == SidesLayout::notInstanced;
    const std::size_t copies = copied ? VERTICES_PER_CAP_PAIR : 1;
    const std::size_t recordBytes = CapsData::vectorsPerRecord * sizeof(glm::vec4) * copies;
    const std::size_t cornerBytes = 3 * sizeof(glm::vec4) * copies;
    for (const RecordChunk& chunk : shadow.caps) {
        const std::size_t first = std::max<std::size_t>(chunk.firstRecord, caps.first);
        const std::size_t end =
            std::min<std::size_t>(chunk.firstRecord + chunk.recordCount, caps.end());
        if (first >= end) continue;
        AttributeBinding binding(copied ? nullptr : &*instancing_);
        if (!copied) binding.add(corners_, 2, GL_FLOAT, false, sizeof(glm::vec2), 0, false);
        binding.addRecords(chunk.buffer, CapsData::vectorsPerRecord,
                           (first - chunk.firstRecord) * recordBytes, !copied);
        if (alphaTested) binding.addRecords(shadow.alphaCorners, 3, first * cornerBytes, !copied);
        const auto count = static_cast<int>(end - first);
        if (copied)
            glDrawArrays(GL_TRIANGLES, 0, count * VERTICES_PER_CAP_PAIR);
        else
            instancing_->drawTriangles(VERTICES_PER_CAP_PAIR, count);
    }
}

} // namespace edgeshade
