#include "src/rivals/published/caps_pass.hpp"

#include "shaders_es2/record_layout.glsl"
#include "src/rivals/published/cap_records.hpp"

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
    const gl::Instancing* instancing =
        layout_ == SidesLayout::notInstanced ? nullptr : &*instancing_;
    drawCapRecords(shadow, caps, {instancing, corners_, VERTICES_PER_CAP_PAIR}, alphaTested);
}

} // namespace edgeshade
