#include "src/viewer/sun_hours.hpp"

#include "shaders_es2.hpp"
#include "src/gl/framebuffer_keeper.hpp"
#include "src/plot/color_scale.hpp"
#include "src/render/accumulation/direction_masks.hpp"

#include <algorithm>
#include <GLES2/gl2.h>

namespace edgeshade::viewer {
namespace {

constexpr int shades = 256;
constexpr Sampler texelByTexel{GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE, GL_NEAREST, GL_NEAREST};

} // namespace

void SunHoursCount::see(const SeenScene& seen, const FrameView& view, const SunState& sun,
                        int step) {
    SunState day = sun;
    day.time.instant = sun::startOfDay(sun.time);
    if (view_ && seen == seen_ && day == day_ && step == step_) return;
    if (!view_ || day != day_ || step != step_)
        positions_ = hours::positionsBetween(day.place, day.time.instant,
                                             day.time.instant + std::chrono::hours(24),
                                             std::chrono::minutes(step), 0.0, day.north);
    seen_ = seen;
    view_ = view;
    day_ = day;
    step_ = step;
    counted_ = 0;
    pace_.restart();
}

bool SunHoursCount::advance(Renderer& renderer, GpuScene& scene, const LoadedScene& loaded,
                            double now) {
    if (counted_ == 0) counter_.begin(view_->width, view_->height);
    const std::size_t count =
        std::min({pace_.next(now), LitCounter::lightsAtOnce(scene), positions_.size() - counted_});
    std::vector<glm::dvec3> directions;
    for (std::size_t i = counted_; i < counted_ + count; ++i)
        directions.push_back(positions_[i].direction);
    counter_.add(renderer, scene, loaded, directionMasks(*view_, loaded, directions));
    counted_ += count;
    return isComplete();
}

SunHoursCount::Drawing::Drawing() : picture(shaders::hours_frag) {
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < shades; ++i) {
        const plot::Color color = plot::evenColor(i / (shades - 1.0));
        for (const int shift : {16, 8, 0})
            rgba.push_back(static_cast<std::uint8_t>(color >> shift));
        rgba.push_back(255);
    }
    colors = gl::makeTexture(rgba, shades, 1, texelByTexel);
}

void SunHoursCount::draw(const glm::vec3& background) {
    if (!drawing_) drawing_.emplace();
    const gl::Name framebuffer = gl::boundFramebuffer();
    const gl::Program& program = drawing_->picture.use();
    program.set("u_background", background);
    program.setTexture("u_colors", 2, drawing_->colors.name());
    counter_.sum().draw(drawing_->picture, framebuffer,
                        static_cast<std::uint32_t>(positions_.size()));
    glActiveTexture(GL_TEXTURE2);
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE0);
}

std::optional<std::uint32_t> SunHoursCount::at(const glm::ivec2& pixel) const {
    const glm::ivec2 size = counter_.sum().size();
    if (!isComplete() || pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y)
        return std::nullopt;
    const gl::FramebufferKeeper keeper;
    const auto sums = counter_.sum().at(pixel);
    if (sums[3] == 0) return std::nullopt;
    return sums[0];
}

} // namespace edgeshade::viewer
