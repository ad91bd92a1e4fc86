#include "src/render/volumes/published/caps_pass.hpp"

#include "shaders_es2/record_layout.glsl"
#include "src/render/drawing/attributes.hpp"
#include "src/render/drawing/cap_holes.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// Adjoining groups of opaque casters, which one draw can take.
std::vector<CasterGroup> mergedOpaque(const std::vector<CasterGroup>& groups,
                                      const std::vector<Material>& materials) {
    std::vector<CasterGroup> merged;
    for (const CasterGroup& group : groups) {
        const auto isOpaque = [&](const CasterGroup& g) {
            return materials[g.material].alphaMode == AlphaMode::opaque;
        };
        if (!merged.empty() && isOpaque(merged.back()) && isOpaque(group))
            merged.back().capCount += group.capCount;
        else
            merged.push_back(group);
    }
    return merged;
}

} // namespace

CapsPass::CapsPass(MultiplicityMethod method, SidesLayout layout,
                   std::optional<gl::Instancing> instancing, std::vector<std::string> defines)
    : method_(method), layout_(layout), instancing_(instancing), defines_(std::move(defines)) {
    std::vector<glm::vec2> corners;
    for (int vertex = 0; vertex < VERTICES_PER_CAP_PAIR; ++vertex)
        corners.emplace_back(static_cast<float>(vertex), 0.0f);
    corners_ = gl::vertexBuffer<glm::vec2>(corners);
}

gl::Program& CapsPass::program(const CapsVariant& variant) {
    auto found = programs_.find(variant);
    if (found == programs_.end())
        found =
            programs_.emplace(variant, makeCapsProgram(method_, layout_, variant, defines_)).first;
    return found->second;
}

void CapsPass::draw(const ShadowBuffers& shadow, const std::vector<Material>& materials,
                    const Textures& textures, const glm::vec4& light,
                    const glm::mat4& clipFromObject, bool nearDiscard) {
    for (const CasterGroup& group : mergedOpaque(shadow.groups, materials)) {
        const Material& material = materials[group.material];
        const bool alphaTest = material.alphaMode != AlphaMode::opaque;
        gl::Program& variant = program({nearDiscard, alphaTest});
        variant.use();
        variant.set("u_light", light);
        variant.set("u_clipFromObject", clipFromObject);
        if (!alphaTest) {
            drawGroup(shadow, group, false);
            continue;
        }
        setCapHoles(variant, material, textures);
        for (const float atInfinity : {1.0f, 0.0f}) {
            variant.set("u_frontCapAtInfinity", atInfinity);
            drawGroup(shadow, group, true);
        }
    }
}

void CapsPass::drawGroup(const ShadowBuffers& shadow, const CasterGroup& group, bool holes) {
    const bool copied = layout_ == SidesLayout::notInstanced;
    const std::size_t copies = copied ? VERTICES_PER_CAP_PAIR : 1;
    const std::size_t recordBytes = CapsData::vectorsPerRecord * sizeof(glm::vec4) * copies;
    const std::size_t holeBytes = 3 * sizeof(glm::vec4) * copies;
    for (const RecordChunk& chunk : shadow.caps) {
        const std::size_t first = std::max<std::size_t>(chunk.firstRecord, group.firstCap);
        const std::size_t end = std::min<std::size_t>(chunk.firstRecord + chunk.recordCount,
                                                      group.firstCap + group.capCount);
        if (first >= end) continue;
        AttributeBinding binding(copied ? nullptr : &*instancing_);
        if (!copied) binding.add(corners_, 2, GL_FLOAT, false, sizeof(glm::vec2), 0, false);
        binding.addRecords(chunk.buffer, CapsData::vectorsPerRecord,
                           (first - chunk.firstRecord) * recordBytes, !copied);
        if (holes) binding.addRecords(shadow.capHoles, 3, first * holeBytes, !copied);
        const auto count = static_cast<int>(end - first);
        if (copied)
            glDrawArrays(GL_TRIANGLES, 0, count * VERTICES_PER_CAP_PAIR);
        else
            instancing_->drawTriangles(VERTICES_PER_CAP_PAIR, count);
    }
}

} // namespace edgeshade
