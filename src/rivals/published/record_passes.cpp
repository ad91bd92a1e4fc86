#include "src/rivals/published/record_passes.hpp"

#include "shaders_es2/record_layout.glsl"
#include "src/render/drawing/attributes.hpp"
#include "src/rivals/published/cap_records.hpp"

namespace edgeshade {

static_assert(VERTICES_PER_CAP_PAIR <= VERTICES_PER_SIDE);

RecordPasses::RecordPasses(MultiplicityMethod method, SidesLayout layout,
                           std::optional<gl::Instancing> instancing,
                           std::vector<std::string> defines)
    : method_(method), layout_(layout), instancing_(instancing), defines_(std::move(defines)) {
    std::vector<glm::vec2> corners;
    for (int side = 0; side < LARGEST_RECORD_MULTIPLICITY; ++side)
        for (int vertex = 0; vertex < VERTICES_PER_SIDE; ++vertex)
            corners.emplace_back(static_cast<float>(vertex), static_cast<float>(side));
    corners_ = gl::vertexBuffer<glm::vec2>(corners);
}

void RecordPasses::prepareSides(int maxMultiplicity) {
    sides_.get(maxMultiplicity,
               [&] { return makeSidesProgram(method_, maxMultiplicity, layout_, defines_); });
}

void RecordPasses::prepareCaps(const CapsVariant& variant) {
    caps_.get(variant, [&] { return makeCapsProgram(method_, layout_, variant, defines_); });
}

void RecordPasses::drawSides(const ShadowBuffers& shadow) const {
    for (const RecordChunk& chunk : shadow.sides)
        drawChunk(shadow, chunk);
}

void RecordPasses::drawChunk(const ShadowBuffers& shadow, const RecordChunk& chunk) const {
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
    const gl::Program& program = useSides(shadow.maxMultiplicity);
    for (int side = 0; side < shadow.maxMultiplicity; ++side) {
        program.set("u_side", static_cast<float>(side));
        instancing_->drawTriangles(VERTICES_PER_SIDE, records);
    }
}

void RecordPasses::drawCaps(const ShadowBuffers& shadow, const RecordRange& caps,
                            bool alphaTested) const {
    const gl::Instancing* instancing =
        layout_ == SidesLayout::notInstanced ? nullptr : &*instancing_;
    drawCapRecords(shadow, caps, {instancing, corners_, VERTICES_PER_CAP_PAIR}, alphaTested);
}

} // namespace edgeshade
