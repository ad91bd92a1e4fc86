#include "src/lab/jury.hpp"

#include "src/lab/texture_alpha.hpp"

namespace edgeshade::lab {
namespace {

FrameView frameOf(const LoadedScene& loaded, const FrameRequest& request) {
    FrameView frame = makeFrameView(loaded.scene, loaded.settings.castMasked, request);
    frame.drawBlended = false;
    return frame;
}

} // namespace

Jury::Jury(const LoadedScene& loaded, const CompareTask& task)
    : loaded_(loaded), task_(task), studio_(task.width, task.height, task.limits),
      alpha_(textureAlpha(loaded)) {}

void Jury::see(const LabView& view, int width, int height) {
    FrameRequest request;
    request.frustum = view.frustum;
    request.width = width;
    request.height = height;
    request.depth.near = task_.near;
    request.lights = task_.lights.empty() ? std::vector{view.light} : task_.lights;
    judged_.request = request;
    judged_.frame = frameOf(loaded_, request);
    judged_.oracle = std::make_unique<Oracle>(
        Question{&loaded_.scene, loaded_.settings.castMasked, judged_.frame.frustum,
                 judged_.frame.near(), request.lights, width, height, loaded_.cutoutsCast},
        alpha_);
    judged_.answers = SettledAnswers(traceAll(*judged_.oracle, {}));
    pictures_ = {};
    unshadowed_.clear();
    frames_ = {{&loaded_, judged_.frame}};
}

Comparison Jury::compare(Renderer& renderer, const Contender& contender) {
    pictures_.unshadowed =
        unshadowedLike(renderer.settings(), frameWith(loaded_, contender.depthSlices)).draw;
    const LoadedScene& drawn = contender.scene ? *contender.scene : loaded_;
    FrameView frame = frameWith(drawn, contender.depthSlices);
    drawImage(renderer, drawn, frame);
    frame.mask = true;
    pictures_.mask = studio_.draw(renderer, drawn, frame);
    methods_ = studio_.methods();
    return compareWithOracle(*judged_.oracle, judged_.answers.answers, pictures_,
                             studio_.subpixelBits());
}

WrongCounts Jury::countWrongImage(Renderer& renderer, const Contender& contender) {
    Unshadowed& unshadowed =
        unshadowedLike(renderer.settings(), frameWith(loaded_, contender.depthSlices));
    if (!unshadowed.expected)
        unshadowed.expected = std::make_unique<OraclePicture>(unshadowed.draw);
    const LoadedScene& drawn = contender.scene ? *contender.scene : loaded_;
    drawImage(renderer, drawn, frameWith(drawn, contender.depthSlices));
    return lab::countWrongImage(*judged_.oracle, judged_.answers, pictures_.image,
                                *unshadowed.expected);
}

void Jury::drawImage(Renderer& renderer, const LoadedScene& drawn, const FrameView& frame) {
    pictures_.image = studio_.draw(renderer, drawn, frame);
    methods_ = studio_.methods();
}

FrameView Jury::frameWith(const LoadedScene& drawn, std::optional<int> depthSlices) {
    auto found = frames_.find(&drawn);
    if (found == frames_.end())
        found = frames_.emplace(&drawn, frameOf(drawn, judged_.request)).first;
    FrameView frame = found->second;
    frame.divide(depthSlices);
    return frame;
}

/// Contenders with the same slices and the same look share them.
Jury::Unshadowed& Jury::unshadowedLike(const RenderSettings& settings, const FrameView& frame) {
    const Look look(frame.slices.size(), settings.shading, settings.ambient, settings.exposure);
    if (const auto known = unshadowed_.find(look); known != unshadowed_.end()) return known->second;
    std::shared_ptr<Renderer>& renderer = plain_[look];
    if (!renderer) {
        RenderSettings plain = settings;
        plain.shadows = ShadowMethod::none;
        renderer = std::make_shared<Renderer>(studio_.rendererFor(plain));
    }
    const auto drawn = std::make_shared<std::map<std::uint32_t, std::vector<std::uint8_t>>>();
    Unshadowed& unshadowed = unshadowed_[look];
    unshadowed.draw = [this, frame, renderer, drawn](std::uint32_t lights) {
        if (const auto found = drawn->find(lights); found != drawn->end()) return found->second;
        FrameView view = frame;
        for (std::size_t i = 0; i < view.lights.size(); ++i)
            view.lights[i].drawn = (lights >> i & 1u) != 0;
        auto picture = studio_.draw(*renderer, loaded_, view);
        constexpr std::size_t most = 16;
        if (drawn->size() < most) drawn->emplace(lights, picture);
        return picture;
    };
    return unshadowed;
}

} // namespace edgeshade::lab
