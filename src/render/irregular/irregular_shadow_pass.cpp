#include "src/render/irregular/irregular_shadow_pass.hpp"

#include "preprocess/mesh/topology.hpp"
#include "shaders_es2.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {
IrregularShadowPass::IrregularShadowPass(const gl::Capabilities& capabilities)
    : numbers_(capabilities), picture_(shaders::marked_frag) {}

void IrregularShadowPass::mark(const GpuScene& scene, const FrameView& view,
                               const DepthSlice& slice, const Light& light,
                               const PixelRectangle& reach, const PixelRectangle& area,
                               bool animatedAlone) {
    if (!known_) {
        numbers_.find(scene, view, slice, area, seen_);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDepthMask(GL_FALSE);
        glEnable(GL_STENCIL_TEST);
        known_ = true;
    }
    IrregularZBuffer buffer(seen_, view, light, reach);
    buffer.cast(castersOf(scene, animatedAlone));
    upload(buffer.shadowed());
    glDisable(GL_DEPTH_TEST);
    glStencilFunc(GL_ALWAYS, 1, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    const gl::Program& used = picture_.use();
    used.setTexture("u_marked", 0, texture_.name());
    const glm::vec2 texel = 1.0f / glm::vec2(size_);
    used.set("u_texelFromPixel", glm::vec4(texel, -texel * glm::vec2(seen_.area.x, seen_.area.y)));
    picture_.draw();
    glBindTexture(GL_TEXTURE_2D, 0);
    glEnable(GL_DEPTH_TEST);
}

std::vector<PlacedRuns> IrregularShadowPass::castersOf(const GpuScene& scene, bool animatedAlone) {
    for (auto& [geometry, kept] : kept_)
        kept.used = false;
    std::vector<PlacedRuns> placed;
    for (const GpuBatch& batch : scene.batches) {
        const Geometry& geometry = *batch.geometry;
        auto found = kept_.find(&geometry);
        const bool casts = !batch.hidden && (batch.animated || !animatedAlone);
        if (casts && (found == kept_.end() || found->second.scene != scene.identity)) {
            CasterRuns runs(
                geometry.positions,
                edgeshade::castersOf(geometry, scene.materials, scene.castMasked).indices);
            found = kept_
                        .insert_or_assign(&geometry,
                                          Kept{batch.geometry, scene.identity, std::move(runs)})
                        .first;
        }
        if (found == kept_.end()) continue;
        found->second.used = true;
        if (casts) placed.push_back({&found->second.casters, batch.worldFromBatch});
    }
    std::erase_if(kept_, [](const auto& entry) { return !entry.second.used; });
    return placed;
}

void IrregularShadowPass::upload(const std::vector<std::uint8_t>& marked) {
    const glm::ivec2 size(seen_.area.width, seen_.area.height);
    glActiveTexture(GL_TEXTURE0);
    if (texture_.name() == 0) texture_ = gl::nearestTexture();
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (size_ == size)
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_ALPHA, GL_UNSIGNED_BYTE,
                        marked.data());
    else
        glTexImage2D(GL_TEXTURE_2D, 0, GL_ALPHA, size.x, size.y, 0, GL_ALPHA, GL_UNSIGNED_BYTE,
                     marked.data());
    size_ = size;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

} // namespace edgeshade
