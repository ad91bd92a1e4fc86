#include "src/rivals/published/sides_pass.hpp"

#include "shaders_es2/record_layout.glsl"
#include "src/render/drawing/attributes.hpp"

namespace edgeshade {

SidesPass::SidesPass(MultiplicityMethod method, SidesLayout layout,
                     std::optional<gl::Instancing> instancing, std::vector<std::string> defines)
    : method_(method), layout_(layout), instancing_(instancing), defines_(std::move(defines)) {
    std::vector<glm::vec2> corners;
    for (int side = 0; side < LARGEST_RECORD_MULTIPLICITY; ++side)
        for (int vertex = 0; vertex < VERTICES_PER_SIDE; ++vertex)
            corners.emplace_back(static_cast<float>(vertex), static_cast<float>(side));
    corners_ = gl::vertexBuffer<glm::vec2>(corners);
}

void SidesPass::prepare(int maxMultiplicity) {
    if (!programs_.contains(maxMultiplicity))
        programs_.emplace(maxMultiplicity,
                          makeSidesProgram(method_, maxMultiplicity, layout_, defines_));
}

const gl::Program& SidesPass::use(int maxMultiplicity) const {
    const gl::Program& program = programs_.at(maxMultiplicity);
    program.use();
    return program;
}

void SidesPass::draw(const ShadowBuffers& shadow) const {
    for (const RecordChunk& chunk : shadow.sides)
        drawRecords(shadow, chunk);
}

void SidesPass::drawRecords(const ShadowBuffers& shadow, const RecordChunk& chunk) const {
    const auto vectors = static_cast<std::size_t>(2 + shadow.maxMultiplicity);
    const auto records = static_cast<int>(chunk.recordCount);
    const int vertices = shadow.maxMultiplicity * VERTICES_PER_SIDE;
    if (layout_ == SidesLayout::notInstanced) {
        AttributeBinding binding(nullptr);
        binding.addRecords(chunk.buffer, vectors, 0, false);
        glDrawArrays(GL_TRIANGLES, 0, records * vertices);
        return;
    }
    AttributeBinding binding(&*instancing_);
    binding.add(corners_, 2, GL_FLOAT, false, sizeof(glm::vec2), 0, false);
    binding.addRecords(chunk.buffer, vectors, 0, true);
    if (layout_ == SidesLayout::instanced) {
        instancing_->drawTriangles(vertices, records);
        return;
    }
    for (int side = 0; side < shadow.maxMultiplicity; ++side) {
        programs_.at(shadow.maxMultiplicity).set("u_side", static_cast<float>(side));
        instancing_->drawTriangles(VERTICES_PER_SIDE, records);
    }
}

} // namespace edgeshade
