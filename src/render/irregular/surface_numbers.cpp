#include "src/render/irregular/surface_numbers.hpp"

#include "preprocess/base/error.hpp"
#include "shaders_es2.hpp"
#include "src/gl/framebuffer_keeper.hpp"
#include "src/gl/scissor.hpp"
#include "src/render/drawing/attributes.hpp"
#include "src/render/drawing/batch_view.hpp"
#include "src/render/drawing/cap_alpha_test.hpp"
#include "src/render/drawing/cull_scope.hpp"

#include <cmath>
#include <cstddef>
#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

struct NumberedVertex {
    glm::vec3 position;
    float number; ///< number of its triangle in the geometry
    glm::vec2 texcoord;
    float alpha;
};

std::vector<NumberedVertex> numbered(const Geometry& geometry) {
    std::vector<NumberedVertex> vertices;
    vertices.reserve(geometry.indices.size());
    for (std::size_t i = 0; i < geometry.indices.size(); ++i) {
        const std::uint32_t v = geometry.indices[i];
        vertices.push_back({geometry.positions[v], static_cast<float>(i / 3),
                            geometry.texcoords.empty() ? glm::vec2(0.0f) : geometry.texcoords[v],
                            geometry.colors.empty() ? 1.0f : geometry.colors[v].a});
    }
    return vertices;
}

std::vector<std::uint8_t> castersAmong(const GpuScene& scene, const Geometry& geometry) {
    std::vector<std::uint8_t> casts(geometry.indices.size() / 3, 0);
    for (const SurfaceGroup& group : geometry.groups)
        if (scene.materials[group.material].casts(scene.castMasked))
            std::fill_n(casts.begin() + group.firstIndex / 3, group.indexCount / 3, 1);
    return casts;
}

} // namespace

void SurfaceNumbers::fit(int width, int height) {
    const bool flipped = gl::boundFramebuffer() == 0 && capabilities_.framebufferFlip;
    if (size_ == glm::ivec2(width, height) && flipped == flipped_) return;
    const gl::FramebufferKeeper keeper;
    size_ = glm::ivec2(0); // in case the GL refuses below
    flipped_ = flipped;
    target_ = gl::ColorTarget(width, height);
    depth_.emplace(width, height, capabilities_);
    depth_->attach();
    if (flipped_) capabilities_.framebufferFlip->flip();
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ExitStatus::unavailable,
                    "This GL can't draw into a texture with depth, which '--shadows "
                    "irregular-z-buffer' needs; '--shadows volumes' works without it.");
    size_ = {width, height};
}

SurfaceNumbers::Kept& SurfaceNumbers::keptOf(const GpuScene& scene, const GpuBatch& batch) {
    const Geometry& geometry = *batch.geometry;
    auto found = kept_.find(&geometry);
    if (found == kept_.end() || found->second.scene != scene.identity)
        found =
            kept_
                .insert_or_assign(
                    &geometry, Kept{batch.geometry, scene.identity, castersAmong(scene, geometry),
                                    gl::vertexBuffer<NumberedVertex>(numbered(geometry))})
                .first;
    found->second.used = true;
    return found->second;
}

void SurfaceNumbers::find(const GpuScene& scene, const FrameView& view, const DepthSlice& slice,
                          const PixelRectangle& area, SeenTriangles& seen) {
    fit(view.width, view.height);
    for (auto& [geometry, kept] : kept_)
        kept.used = false;
    seen.area = area;
    seen.surfaces.clear();
    std::size_t next = 1; // 0: no surface
    for (const GpuBatch& batch : scene.batches) {
        if (batch.hidden || (batch.ground && !view.ground)) continue;
        const Kept& kept = keptOf(scene, batch);
        const Geometry& geometry = *batch.geometry;
        seen.surfaces.push_back({geometry.positions, geometry.indices, kept.casts,
                                 batch.worldFromBatch, static_cast<std::uint32_t>(next)});
        next += geometry.indices.size() / 3;
    }
    std::erase_if(kept_, [](const auto& entry) { return !entry.second.used; });
    if (next > mostTriangles)
        throw Error(ExitStatus::unavailable,
                    "'--shadows irregular-z-buffer' numbers at most 16,777,215 triangles; "
                    "'--shadows volumes' takes any number.");

    const gl::FramebufferKeeper keeper;
    glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer.name());
    const gl::ScissorScope cut(area);
    glViewport(0, 0, view.width, view.height);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glEnable(GL_DEPTH_TEST);
    for (const GLenum off : {GL_BLEND, GL_CULL_FACE, GL_DITHER, GL_STENCIL_TEST})
        glDisable(off);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    auto surfaces = seen.surfaces.begin();
    for (const GpuBatch& batch : scene.batches)
        if (!batch.hidden && (!batch.ground || view.ground))
            drawBatch(scene, batch, view, slice, kept_.at(&*batch.geometry), (surfaces++)->first);
    read(area, seen.numbers);
    glEnable(GL_DITHER);
}

void SurfaceNumbers::drawBatch(const GpuScene& scene, const GpuBatch& batch, const FrameView& view,
                               const DepthSlice& slice, const Kept& kept, std::uint32_t first) {
    const BatchView seen = batchViewOf(batch, view, slice);
    const auto number = static_cast<std::size_t>(&batch - scene.batches.data());
    AttributeBinding binding(nullptr);
    const auto add = [&](int components, std::size_t offset) {
        binding.add(kept.vertices, components, GL_FLOAT, false, sizeof(NumberedVertex), offset,
                    false);
    };
    add(3, offsetof(NumberedVertex, position));
    add(1, offsetof(NumberedVertex, number));
    add(2, offsetof(NumberedVertex, texcoord));
    add(1, offsetof(NumberedVertex, alpha));
    for (const SurfaceGroup& group : batch.geometry->groups) {
        const Material& material = scene.materials[group.material];
        if (material.alphaMode == AlphaMode::blend || !material.isSeen()) continue;
        const bool alphaTest = material.alphaMode == AlphaMode::mask;
        const gl::Program& used = program({alphaTest, std::isfinite(slice.far)});
        used.use();
        used.set("u_clipFromObject", seen.clipFromObject);
        used.set("u_firstNumber", static_cast<float>(first));
        used.set("u_farthest", static_cast<float>(slice.far * sliceOverlap));
        if (alphaTest) setAlphaLookup(used, scene.alphaOf(number, group.material));
        const CullScope frontAlone(seen.culls && !material.doubleSided, seen.mirrored);
        glDrawArrays(GL_TRIANGLES, static_cast<GLint>(group.firstIndex),
                     static_cast<GLsizei>(group.indexCount));
    }
}

const gl::Program& SurfaceNumbers::program(const Variant& variant) {
    return programs_.get(variant, [&] {
        return gl::Program(
            shaders::surface_number_vert, shaders::surface_number_frag,
            gl::definesOf({{"ALPHA_TEST", variant.alphaTest}, {"SLICED", variant.sliced}}),
            {"a_position", "a_number", "a_texcoord", "a_alpha"});
    });
}

void SurfaceNumbers::read(const PixelRectangle& area, std::vector<std::uint32_t>& numbers) {
    const std::size_t count =
        static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height);
    pixels_.resize(4 * count);
    numbers.resize(count);
    glReadPixels(area.x, area.y, area.width, area.height, GL_RGBA, GL_UNSIGNED_BYTE,
                 pixels_.data());
    for (std::size_t i = 0; i < count; ++i)
        numbers[i] = pixels_[4 * i] | static_cast<std::uint32_t>(pixels_[4 * i + 1]) << 8 |
                     static_cast<std::uint32_t>(pixels_[4 * i + 2]) << 16;
}

std::size_t SurfaceNumbers::bytes() const {
    std::size_t total = 4 * static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
    if (depth_) total += depth_->bytes();
    for (const auto& [geometry, kept] : kept_)
        total += kept.vertices.size();
    return total;
}

} // namespace edgeshade
