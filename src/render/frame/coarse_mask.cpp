#include "src/render/frame/coarse_mask.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/vectors.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

/// Greatest difference of slopes on a curved surface within a texel. A smaller value breaks up
/// curved surfaces, a larger one lets light leak over low steps. This value ignores steps of half a
/// texel.
constexpr double slopeOfCurves = 0.5;

/// The planes' space for a picture of this size.
PlaneSpace planeSpace(const FrameView& view, const DepthSlice& slice, const glm::dvec2& size) {
    const glm::dvec2 window = view.frustum.size();
    PlaneSpace space{glm::vec2(0.5 * window),
                     glm::vec2(0.5 * (view.frustum.low + view.frustum.high)),
                     glm::vec2(size / window), static_cast<float>(slice.near)};
    if (view.frustum.orthographic)
        space.depthRange = static_cast<float>(view.farPlane - slice.near);
    return space;
}

} // namespace

CoarseMask::CoarseMask(int scale, const gl::Capabilities& capabilities)
    : scale_(scale), capabilities_(capabilities) {
    if (!capabilities.has("GL_OES_standard_derivatives"))
        throw Error(ExitStatus::unavailable,
                    "This GL has no derivatives in shaders (GL_OES_standard_derivatives), which a "
                    "mask of lower resolution needs; '--mask-scale 1' works without it.");
}

gl::ColorTarget CoarseMask::makeTarget(const glm::ivec2& size) const {
    gl::ColorTarget made(size.x, size.y);
    depthStencil_->attach();
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ExitStatus::unavailable,
                    "This GL can't draw into a texture with depth and stencil, which a mask of "
                    "lower resolution needs; '--mask-scale 1' works without it.");
    return made;
}

void CoarseMask::fit(int width, int height) {
    const glm::ivec2 size = (glm::ivec2(width, height) + scale_ - 1) / scale_;
    if (size == size_) return;
    size_ = glm::ivec2(0); // in case the GL refuses below
    depthStencil_.emplace(size.x, size.y, capabilities_);
    surfaces_ = makeTarget(size);
    counts_ = makeTarget(size);
    size_ = size;
}

void CoarseMask::bindSurfaces() const {
    glBindFramebuffer(GL_FRAMEBUFFER, surfaces_.framebuffer.name());
    glViewport(0, 0, size_.x, size_.y);
}

void CoarseMask::bindCounts() const {
    glBindFramebuffer(GL_FRAMEBUFFER, counts_.framebuffer.name());
    glViewport(0, 0, size_.x, size_.y);
}

PlaneSpace CoarseMask::space(const FrameView& view, const DepthSlice& slice) const {
    return planeSpace(view, slice, size_);
}

CoarseMaskLookup CoarseMask::lookup(const FrameView& view, const DepthSlice& slice,
                                    const Light& light) const {
    CoarseMaskLookup lookup;
    lookup.surface = surfaces_.texture.name();
    lookup.lit = counts_.texture.name();
    const glm::dvec2 picture(view.width, view.height);
    lookup.space = planeSpace(view, slice, picture);
    lookup.size = glm::vec2(size_);
    lookup.texel = glm::vec2(picture / glm::dvec2(size_));
    lookup.slack = static_cast<float>(slopeOfCurves * scale_) / lookup.space.focal.y;
    glm::dvec4 inView = view.frustum.viewFromWorld * light.position;
    inView.z = -inView.z;
    if (view.frustum.orthographic) {
        lookup.slack /= *lookup.space.depthRange;
        inView.z -= slice.near * inView.w;
        lookup.light = glm::vec4(inView);
        return lookup;
    }
    // Scale a directional light's direction, so that no double exceeds the range of floats.
    const double unit = light.position.w != 0.0 ? slice.near : largestComponent(glm::dvec3(inView));
    lookup.light = glm::vec4(glm::dvec3(inView) / unit, inView.w);
    return lookup;
}

std::size_t CoarseMask::bytes() const {
    if (!depthStencil_) return 0;
    const std::size_t texels =
        static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
    return 2 * 4 * texels + depthStencil_->bytes();
}

} // namespace edgeshade
