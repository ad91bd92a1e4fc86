// What is wrong with an animation before its keyframes are looked at: it is left out. The rest is
// in tests/gltf/bad_animation_test.cpp.
#include "tests/cli/bad_input.hpp"

namespace edgeshade::test {
namespace {

/// The sound scene with its animation changed.
BadInput withAnimation(const std::string& name, const std::function<void(Json&)>& change,
                       const std::vector<std::string>& words) {
    std::vector<std::string> all = words;
    all.push_back("the animation is left out");
    return warned(badScene(
        name, [=](GltfBuilder& gltf) { change(gltf.json["animations"][0]); }, all));
}

/// The sound scene with a key of its sampler changed.
BadInput withSampler(const std::string& name, const std::string& key, const Json& value,
                     const std::vector<std::string>& words) {
    return withAnimation(
        name, [=](Json& animation) { animation["samplers"][0][key] = value; }, words);
}

/// The sound scene with a key of its channel's target changed.
BadInput withTarget(const std::string& name, const std::string& key, const Json& value,
                    const std::vector<std::string>& words) {
    return withAnimation(
        name, [=](Json& animation) { animation["channels"][0]["target"][key] = value; }, words);
}

} // namespace

std::vector<BadInput> badAnimations() {
    const std::string sampler = "animations[0].samplers[0]";
    const std::string channel = "animations[0].channels[0]";
    return {
        withSampler("TimesOfNoAccessor", "input", 99, {sampler + ".input", "99"}),
        withSampler("TimesOfANegativeAccessor", "input", -1, {sampler + ".input", "-1"}),
        withSampler("TimesAreText", "input", "4", {sampler + ".input", "4"}),
        withSampler("ValuesOfNoAccessor", "output", 99, {sampler + ".output", "99"}),
        withSampler("ValuesOfAHugeAccessor", "output", 4294967296, {sampler + ".output"}),
        withSampler("UnknownInterpolation", "interpolation", "SMOOTH",
                    {sampler + ".interpolation", "SMOOTH"}),
        withSampler("InterpolationIsANumber", "interpolation", 1, {sampler + ".interpolation"}),
        withTarget("AnimatedNodeOutOfRange", "node", 99, {channel + ".target.node", "99"}),
        withTarget("AnimatedNodeNegative", "node", -1, {channel + ".target.node", "-1"}),
        withTarget("UnknownAnimationPath", "path", "shear", {channel + ".target.path", "shear"}),
        withTarget("AnimationPathIsANumber", "path", 3, {channel + ".target.path"}),
        withAnimation("AnimationPathIsMissing",
                      [](Json& animation) { animation["channels"][0]["target"].erase("path"); },
                      {channel + ".target.path", "missing"}),
        withAnimation("TimesAreMissing",
                      [](Json& animation) { animation["samplers"][0].erase("input"); },
                      {sampler + ".input", "missing"}),
        withAnimation("ValuesAreMissing",
                      [](Json& animation) { animation["samplers"][0].erase("output"); },
                      {sampler + ".output", "missing"}),
        withAnimation("AnimationSamplersAreMissing",
                      [](Json& animation) { animation.erase("samplers"); },
                      {channel + ".sampler", "0 samplers"}),
        withAnimation("AnimationSamplerIsANumber",
                      [](Json& animation) { animation["samplers"] = {7}; }, {sampler}),
        withAnimation("AnimationSamplerOutOfRange",
                      [](Json& animation) { animation["channels"][0]["sampler"] = 1; },
                      {channel + ".sampler", "1"}),
        withAnimation("ChannelOfNoSampler",
                      [](Json& animation) { animation["channels"][0].erase("sampler"); },
                      {channel + ".sampler", "missing"}),
        withAnimation("ChannelsAreAnObject",
                      [](Json& animation) { animation["channels"] = Json::object(); },
                      {"animations[0].channels"}),
        withAnimation("ChannelTargetIsANumber",
                      [](Json& animation) { animation["channels"][0]["target"] = 0; },
                      {channel + ".target"}),
    };
}

} // namespace edgeshade::test
