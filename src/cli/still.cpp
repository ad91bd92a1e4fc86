#include "src/cli/still.hpp"

#include "preprocess/base/error.hpp"
#include "src/render/accumulation/extended_lights.hpp"
#include "src/render/accumulation/subpixels.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "src/shadow/view/light_budget.hpp"

#include <algorithm>

namespace edgeshade::cli {
namespace {

/// Number of lights that half floats can add up without visible steps.
constexpr std::size_t mostShading = 256;

/// `part` of `whole` as a byte. Up to a whole of 255, `part` can be recovered exactly.
std::uint8_t byteOf(std::uint64_t part, std::uint64_t whole) {
    return static_cast<std::uint8_t>((510 * part + whole) / (2 * whole));
}

/// Draws a task's pictures one by one.
class Sitting {
  public:
    Sitting(const LoadedScene& loaded, const SceneTree& tree, const StillTask& task,
            Renderer& renderer, GpuScene& scene, const gl::HeadlessContext& context,
            const std::function<void(double)>& progress)
        : loaded_(loaded), tree_(tree), task_(task), renderer_(renderer), scene_(scene),
          context_(context), progress_(progress) {}

    std::vector<std::uint8_t> mask(const FrameView& first) {
        const bool points = !first.lights.front().points.empty();
        const std::size_t each = points ? first.lights.front().points.size() : 1;
        if (each * task_.subpixels > PictureSum::most)
            throw Error(ExitStatus::usage,
                        "--light-samples " + std::to_string(each) + " times --smooth " +
                            std::to_string(task_.subpixels) + " make more masks than the " +
                            std::to_string(PictureSum::most) + " that can be added up.");
        LitCounter counter(context_.capabilities());
        counter.begin(first.width, first.height);
        constexpr std::size_t atOnce = 240; // points between two calls of `progress`
        forEachPicture(first, [&](const FrameView& view, double done, double share) {
            for (std::size_t from = 0; from < each;) {
                const std::size_t count = std::min(each - from, atOnce);
                if (points)
                    counter.addPoints(renderer_, scene_, loaded_, view, 0, from, count);
                else
                    counter.add(renderer_, scene_, loaded_, firstAlone(view));
                from += count;
                progress_(done + share * static_cast<double>(from) / static_cast<double>(each));
            }
        });
        const LitCounts counts = counter.read();
        std::vector<std::uint8_t> picture;
        for (std::size_t i = 0; i < counts.lit.size(); ++i) {
            const std::uint8_t grey = byteOf(counts.lit[i], counts.lights);
            picture.insert(picture.end(),
                           {grey, grey, grey, byteOf(counts.surface[i], counts.pictures)});
        }
        return picture;
    }

    std::vector<std::uint8_t> picture(const FrameView& first) {
        ExtendedLights extended(context_.capabilities());
        std::vector<std::uint32_t> sums;
        forEachPicture(first, [&](const FrameView& view, double done, double share) {
            if (task_.shadeSamples)
                renderer_.draw(scene_, shadedByPoints(view));
            else
                drawAll(extended, view, done, share);
            gl::requireNoError("drawing");
            const std::vector<std::uint8_t> pixels = context_.readPixels();
            sums.resize(pixels.size());
            std::transform(pixels.begin(), pixels.end(), sums.begin(), sums.begin(),
                           [](std::uint8_t pixel, std::uint32_t sum) { return sum + pixel; });
        });
        std::vector<std::uint8_t> picture;
        picture.reserve(sums.size());
        const auto count = static_cast<std::uint32_t>(task_.subpixels);
        for (const std::uint32_t sum : sums)
            picture.push_back(static_cast<std::uint8_t>((2 * sum + count) / (2 * count)));
        return picture;
    }

  private:
    /// Calls draw(view, share done, share of this one) for every picture, in a prepared scene.
    template <class Draw>
    void forEachPicture(const FrameView& first, Draw draw) {
        const double share = 1.0 / static_cast<double>(task_.subpixels);
        for (std::size_t n = 0; n < task_.subpixels; ++n) {
            const FrameView view = n == 0 ? first : viewOf(loaded_, tree_, task_, n, &first);
            prepareScene(scene_, loaded_, view, renderer_);
            if (n == 0 && task_.prepared) task_.prepared();
            draw(view, static_cast<double>(n) * share, share);
            progress_(static_cast<double>(n + 1) * share);
        }
    }

    static FrameView firstAlone(const FrameView& view) {
        FrameView alone = view;
        alone.lights.resize(1);
        alone.mask = alone.sumsMasks = true;
        return alone;
    }

    void drawAll(ExtendedLights& extended, const FrameView& view, double done, double share) {
        extended.restart();
        const std::size_t points = ExtendedLights::points(view);
        while (extended.counted() < points) {
            extended.advance(renderer_, scene_, loaded_, view, LitCounter::lightsAtOnce(scene_));
            progress_(done + share * static_cast<double>(extended.counted()) /
                                 static_cast<double>(points));
        }
        renderer_.draw(scene_, view, nullptr, extended.visibility(view));
    }

    const LoadedScene& loaded_;
    const SceneTree& tree_;
    const StillTask& task_;
    Renderer& renderer_;
    GpuScene& scene_;
    const gl::HeadlessContext& context_;
    const std::function<void(double)>& progress_;
};

void requireSums(const FrameView& view, const Renderer& renderer,
                 const gl::Capabilities& capabilities) {
    if (renderer.settings().shading == Shading::base)
        throw Error(ExitStatus::usage, "--shade-samples needs --shading full.");
    std::size_t lights = 0;
    for (const FrameLight& of : view.lights)
        lights += std::max<std::size_t>(of.points.size(), 1);
    if (lights > mostShading)
        throw Error(ExitStatus::usage,
                    "--shade-samples: the lights have " + std::to_string(lights) +
                        " points, but at most " + std::to_string(mostShading) +
                        " can shade a picture; --light-samples sets the number.");
    if (!LinearTarget::isPossible(capabilities))
        throw Error(ExitStatus::unavailable,
                    "--shade-samples: this GL can't draw into half floats "
                    "(GL_EXT_color_buffer_half_float), which adding up light needs.");
}

} // namespace

bool isGrey(const StillTask& task) {
    const bool extended = task.request.lights.front().extent && task.request.lightSamples > 0;
    return task.mask && (task.subpixels > 1 || extended);
}

FrameView viewOf(const LoadedScene& loaded, const SceneTree& tree, const StillTask& task,
                 std::size_t n, const FrameView* like) {
    FrameRequest request = task.request;
    request.frustum = sampledAt(request.frustum, subpixelOffset(n), request.width, request.height);
    FrameView view =
        makeFrameView(loaded.scene, request, like ? like->bounds : worldBounds(loaded.scene), tree);
    if (!like) chooseLights(view, task.shadowedLights);
    for (std::size_t i = 0; like && i < view.lights.size(); ++i) {
        const FrameLight& known = like->lights[i];
        if (!known.shadowed) leaveWithoutShadow(view.lights[i]);
        view.lights[i].drawn = known.drawn;
        view.lights[i].layers = known.layers;
    }
    if (task.firstIsDown) view.lights.front().drawn = false;
    view.mask = task.mask;
    return view;
}

std::vector<std::uint8_t> drawStill(const LoadedScene& loaded, const SceneTree& tree,
                                    const StillTask& task, const FrameView& first,
                                    Renderer& renderer, GpuScene& scene,
                                    const gl::HeadlessContext& context,
                                    const std::function<void(double)>& progress) {
    if (task.shadeSamples) requireSums(first, renderer, context.capabilities());
    Sitting sitting(loaded, tree, task, renderer, scene, context, progress);
    // A soft map's mask needs no sum: it is already grey.
    const bool sums = isGrey(task) && renderer.settings().countedPoints() > 0;
    return sums ? sitting.mask(first) : sitting.picture(first);
}

} // namespace edgeshade::cli
