#include "src/lab/jury.hpp"

#include "src/lab/compared_frame.hpp"
#include "src/lab/lit_textures.hpp"
#include "src/lab/texture_alpha.hpp"

namespace edgeshade::lab {
namespace {

/// Number of lights from which the oracle's picture is drawn in one go, instead of once for each
/// set of lights that some pixels have.
constexpr std::size_t manyLights = 9;

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
    judged_.frame = comparedFrame(loaded_, request);
    judged_.oracle = std::make_unique<Oracle>(
        Question{&loaded_.scene, loaded_.settings.castMasked, judged_.frame.frustum,
                 judged_.frame.near(), request.lights, width, height, loaded_.cutoutsCast},
        alpha_);
    judged_.answers = SettledAnswers(traceAll(*judged_.oracle));
    pictures_ = {};
    unshadowed_.clear();
    frames_.clear();
    frames_.emplace(std::pair(&loaded_, std::optional<std::size_t>()), judged_.frame);
}

Comparison Jury::compare(Renderer& renderer, const Contender& contender) {
    const Unshadowed& unshadowed =
        unshadowedLike(renderer.settings(), frameWith(loaded_, contender.depthSlices, {}));
    pictures_.unshadowed = unshadowed.draw;
    pictures_.litAs = unshadowed.drawAll;
    const LoadedScene& drawn = contender.scene ? *contender.scene : loaded_;
    FrameView frame = frameFor(contender);
    drawImage(renderer, drawn, frame);
    frame.mask = true;
    pictures_.mask = studio_.draw(renderer, drawn, frame);
    methods_ = studio_.methods();
    return compareWithOracle(*judged_.oracle, judged_.answers.answers, pictures_,
                             studio_.subpixelBits());
}

WrongCounts Jury::countWrongImage(Renderer& renderer, const Contender& contender) {
    Unshadowed& unshadowed =
        unshadowedLike(renderer.settings(), frameWith(loaded_, contender.depthSlices, {}));
    if (!unshadowed.expected)
        unshadowed.expected = std::make_unique<OraclePicture>(unshadowed.draw, unshadowed.drawAll);
    drawImage(renderer, contender.scene ? *contender.scene : loaded_, frameFor(contender));
    return lab::countWrongImage(*judged_.oracle, judged_.answers, pictures_.image,
                                *unshadowed.expected);
}

void Jury::drawImage(Renderer& renderer, const LoadedScene& drawn, const FrameView& frame) {
    pictures_.image = studio_.draw(renderer, drawn, frame);
    methods_ = studio_.methods();
}

FrameView Jury::frameFor(const Contender& contender) {
    return frameWith(contender.scene ? *contender.scene : loaded_, contender.depthSlices,
                     contender.settings.shadowedLights);
}

FrameView Jury::frameWith(const LoadedScene& drawn, std::optional<int> depthSlices,
                          std::optional<std::size_t> mostShadowed) {
    const auto key = std::pair(&drawn, mostShadowed);
    auto found = frames_.find(key);
    if (found == frames_.end())
        found = frames_.emplace(key, comparedFrame(drawn, judged_.request, mostShadowed)).first;
    FrameView frame = found->second;
    frame.divide(depthSlices);
    return frame;
}

/// Contenders with the same slices and look share these pictures.
Jury::Unshadowed& Jury::unshadowedLike(const RenderSettings& settings, const FrameView& frame) {
    const Look look(frame.slices.size(), settings.shading, settings.ambient, settings.exposure);
    if (const auto known = unshadowed_.find(look); known != unshadowed_.end()) return known->second;
    std::shared_ptr<Renderer>& renderer = plain_[look];
    if (!renderer) {
        RenderSettings plain = settings;
        plain.shadows = ShadowMethod::none;
        renderer = std::make_shared<Renderer>(studio_.rendererFor(plain));
    }
    Unshadowed& unshadowed = unshadowed_[look];
    if (frame.lights.size() >= manyLights)
        unshadowed.drawAll = [this, frame, renderer](const std::vector<Answer>& answers) {
            const LitTextures lit(answers, frame.lights.size(), frame.width, frame.height);
            return studio_.draw(*renderer, loaded_, frame, lit.lookups());
        };
    const auto drawn = std::make_shared<std::map<LightSet, std::vector<std::uint8_t>>>();
    unshadowed.draw = [this, frame, renderer, drawn](const LightSet& lights) {
        if (const auto found = drawn->find(lights); found != drawn->end()) return found->second;
        FrameView view = frame;
        for (std::size_t i = 0; i < view.lights.size(); ++i)
            view.lights[i].drawn = lights.has(i);
        auto picture = studio_.draw(*renderer, loaded_, view);
        constexpr std::size_t most = 16;
        if (drawn->size() < most) drawn->emplace(lights, picture);
        return picture;
    };
    return unshadowed;
}

} // namespace edgeshade::lab
