// Errors in an animation that are found before its keyframes are read: the channel is left out.
// tests/gltf/bad_animation_test.cpp has the other errors.
#include "tests/cli/bad_input.hpp"

namespace edgeshade::test {
namespace {

/// The sound scene with its animation changed.
BadInput withAnimation(const std::string& name, const std::function<void(Json&)>& change,
                       const std::vector<std::string>& words) {
    std::vector<std::string> all = words;
    all.push_back(" is left out");
    return warned(badScene(
        name, [=](GltfBuilder& gltf) { change(gltf.json["animations"][0]); }, all));
}

/// The sound scene with one key of its sampler changed.
BadInput withSampler(const std::string& name, const std::string& key, const Json& value,
                     const std::vector<std::string>& words) {
    return withAnimation(
        name, [=](Json& animation) { animation["samplers"][0][key] = value; }, words);
}

/// The sound scene with one key of its channel's target changed.
BadInput withTarget(const std::string& name, const std::string& key, const Json& value,
                    const std::vector<std::string>& words) {
    return withAnimation(
        name, [=](Json& animation) { animation["channels"][0]["target"][key] = value; }, words);
}

/// Uses only verbs that read keyframes, since a picture at rest reads none.
BadInput inInfo(BadInput row) {
    row.verbs = {"info", "pack"};
    return row;
}

/// The sound scene with its two keyframes at these times.
BadInput withKeyframes(const std::string& name, const std::vector<float>& times,
                       std::vector<std::string> words) {
    words.push_back("animations[0].samplers[0].input");
    return inInfo(warned(badScene(
        name,
        [=](GltfBuilder& gltf) {
            gltf.json["animations"][0]["samplers"][0]["input"] = gltf.addArray(times, 1);
        },
        words)));
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
        withAnimation("ChannelIsANumber", [](Json& animation) { animation["channels"] = {7}; },
                      {channel, "an object", "the channel is left out"}),
        withAnimation("SamplersAreAnObject",
                      [](Json& animation) { animation["samplers"] = Json::object(); },
                      {"animations[0].samplers", "an array", "the animation is left out"}),
        withKeyframes("TimesBelow0", {-1.0f, 1.0f}, {"-1 seconds", "played from 0 on"}),
        withKeyframes("TimesAlike", {1.0f, 1.0f}, {"1 at element 1 after 1", "jumps"}),
        withKeyframes("TimesThatGoBack", {1.0f, 0.5f},
                      {"0.5 at element 1 after 1", "the channel is left out"}),
        inInfo(warned(badScene("AMatrixIsMoved",
                               [](GltfBuilder& gltf) {
                                   gltf.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0,
                                                                      0, 0, 1, 0, 0, 0, 0, 1};
                               },
                               {"nodes[0].matrix", "animations[0]"}))),
    };
}

} // namespace edgeshade::test
