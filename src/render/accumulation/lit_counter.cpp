#include "src/render/accumulation/lit_counter.hpp"

#include "preprocess/base/error.hpp"
#include "src/gl/framebuffer_keeper.hpp"
#include "src/render/frame/prepare_scene.hpp"

#include <algorithm>
#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

/// Uploads the groups of casters that the view's lights need, and keeps those of others.
void uploadGroups(const Renderer& renderer, GpuScene& scene, const LoadedScene& loaded,
                  const FrameView& view, std::span<const FrameLight> others) {
    const auto records = renderer.settings().records();
    if (!records) return;
    std::vector<FrameLight> lights = view.lights;
    lights.insert(lights.end(), others.begin(), others.end());
    scene.groups.upload(loaded, lights, *records);
}

} // namespace

std::size_t LitCounter::lightsAtOnce(const GpuScene& scene) {
    constexpr std::size_t mostPlans = 16384; // for one batch and one light
    return std::clamp<std::size_t>(mostPlans / std::max<std::size_t>(scene.batches.size(), 1), 1,
                                   std::size_t{8});
}

void LitCounter::begin(int width, int height, const std::optional<PixelRectangle>& part) {
    const gl::FramebufferKeeper keeper;
    lights_ = pictures_ = 0;
    const bool fits = sum_.size() == glm::ivec2(width, height);
    sum_.begin(width, height, part);
    if (fits) return;
    masks_ = gl::ColorTarget(width, height);
    depthStencil_.emplace(width, height, capabilities_);
    depthStencil_->attach();
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) depthStencil_.reset();
}

void LitCounter::add(Renderer& renderer, GpuScene& scene, const LoadedScene& loaded,
                     const FrameView& view, std::span<const FrameLight> others, StageClock* clock) {
    std::size_t added = 0;
    for (const FrameLight& of : view.lights)
        added += of.atOnce ? of.points.size() : 1;
    if (lights_ + added > PictureSum::most)
        throw Error(ExitStatus::usage,
                    "At most " + std::to_string(PictureSum::most) + " masks can be added up.");
    uploadGroups(renderer, scene, loaded, view, others);
    const gl::FramebufferKeeper keeper;
    if (depthStencil_) glBindFramebuffer(GL_FRAMEBUFFER, masks_.framebuffer.name());
    glDisable(GL_DITHER); // the bytes are counts
    renderer.draw(scene, view, clock);
    if (!depthStencil_) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, masks_.texture.name());
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, view.width, view.height);
    }
    sum_.add(masks_.texture.name());
    lights_ += static_cast<std::uint32_t>(added);
    ++pictures_;
}

bool LitCounter::planAhead(Renderer& renderer, GpuScene& scene, const LoadedScene& loaded,
                           const FrameView& view, std::span<const FrameLight> others) {
    uploadGroups(renderer, scene, loaded, view, others);
    const gl::FramebufferKeeper keeper;
    return renderer.planAhead(scene, view);
}

void LitCounter::addPoints(Renderer& renderer, GpuScene& scene, const LoadedScene& loaded,
                           const FrameView& view, std::size_t light, std::size_t first,
                           std::size_t count, std::span<const FrameLight> others,
                           StageClock* clock) {
    const bool byMap = renderer.settings().looksUpPrimitives() &&
                       extendedMapOf(scene, view.lights[light].light) != nullptr;
    const std::size_t most = byMap ? mostSummed / placesAtOnce * placesAtOnce : lightsAtOnce(scene);
    for (const std::size_t end = first + count; first < end;) {
        const std::size_t next = std::min(end - first, most);
        add(renderer, scene, loaded,
            byMap ? pointsByMapView(view, light, first, next, placesAtOnce)
                  : pointsView(view, light, first, next),
            others, clock);
        first += next;
    }
}

VisibilityLookup LitCounter::visibility() {
    const gl::FramebufferKeeper keeper;
    return {sum_.share(std::max(lights_, 1u)), glm::vec2(sum_.size())};
}

LitCounts LitCounter::read() const {
    const gl::FramebufferKeeper keeper;
    const std::vector<std::uint16_t> sums = sum_.read();
    LitCounts counts{sum_.size().x, sum_.size().y, lights_, pictures_, {}, {}};
    for (std::size_t i = 0; i < sums.size(); i += 4) {
        counts.lit.push_back(sums[i]);
        counts.surface.push_back(sums[i + 3]);
    }
    return counts;
}

std::size_t LitCounter::bytes() const {
    const auto pixels =
        static_cast<std::size_t>(sum_.size().x) * static_cast<std::size_t>(sum_.size().y);
    return sum_.bytes() + (depthStencil_ ? 4 * pixels + depthStencil_->bytes() : 0);
}

} // namespace edgeshade
