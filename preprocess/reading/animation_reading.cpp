#include "preprocess/reading/animation_reading.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/accessor.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"
#include "preprocess/reading/rest_transform.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <tuple>

namespace edgeshade {
namespace {

using Floats = std::shared_ptr<const std::vector<float>>;

/// The shortest text that says this number.
std::string shown(float number) {
    // std::to_chars() of a float is not in every standard library that this is built with.
    char text[32];
    for (int digits = 6; digits <= 9; ++digits) {
        std::snprintf(text, sizeof text, "%.*g", digits, static_cast<double>(number));
        if (std::strtof(text, nullptr) == number) break;
    }
    return text;
}

Interpolation interpolationOf(const tinygltf::AnimationSampler& sampler) {
    if (sampler.interpolation == "STEP") return Interpolation::step;
    if (sampler.interpolation == "CUBICSPLINE") return Interpolation::cubicSpline;
    return Interpolation::linear; // also the default; other words were refused before
}

bool movesNode(const tinygltf::AnimationChannel& channel) {
    const std::string& path = channel.target_path;
    return channel.target_node >= 0 &&
           (path == "translation" || path == "rotation" || path == "scale");
}

/// Whether it moves weights that the node's mesh has.
bool movesWeights(const GltfDocument& document, const tinygltf::AnimationChannel& channel) {
    if (channel.target_path != "weights" || channel.target_node < 0) return false;
    return morphTargetCount(document, document.model->nodes.at(channel.target_node).mesh) > 0;
}

bool movesAnything(const GltfDocument& document, const tinygltf::Animation& animation) {
    return std::any_of(animation.channels.begin(), animation.channels.end(),
                       [&](const tinygltf::AnimationChannel& channel) {
                           return movesNode(channel) || movesWeights(document, channel);
                       });
}

/// The property's keyframes in the motion of its node.
std::optional<Keyframes>& keyframesOf(NodeMotion& motion, const std::string& path) {
    if (path == "translation") return motion.translation;
    return path == "rotation" ? motion.rotation : motion.scale;
}

/// Reads the animations of one document. An accessor that many samplers name is read and looked
/// through once, so that a small file can't ask for endless work.
class AnimationReader {
  public:
    explicit AnimationReader(const GltfDocument& document)
        : document_(document), memory_(document.memory) {}

    Animation read(std::size_t index) {
        const tinygltf::Animation& source = document_.model->animations[index];
        const std::string field = "animations[" + std::to_string(index) + "]";
        Animation animation;
        for (const tinygltf::AnimationChannel& channel : source.channels) {
            const bool ofWeights = movesWeights(document_, channel);
            if (!ofWeights && !movesNode(channel)) continue;
            const int node = channel.target_node;
            const std::string& path = channel.target_path;
            std::optional<Keyframes>& keyframes =
                ofWeights ? animation.weights[node]
                          : keyframesOf(motionOf(animation, node, field), path);
            if (keyframes)
                throw InputError(document_.where(field) + " moves nodes[" + std::to_string(node) +
                                 "]." + path + " by two channels.");
            const std::string samplerField =
                field + ".samplers[" + std::to_string(channel.sampler) + "]";
            const tinygltf::AnimationSampler& sampler = source.samplers.at(channel.sampler);
            keyframes = ofWeights ? readWeights(sampler, node, samplerField)
                                  : readSampler(sampler, path == "rotation", samplerField);
            animation.duration =
                std::max(animation.duration, static_cast<double>(keyframes->times->back()));
        }
        return animation;
    }

  private:
    NodeMotion& motionOf(Animation& animation, int index, const std::string& field) const {
        const tinygltf::Node& node = document_.model->nodes.at(index);
        if (hasMatrix(node)) // (glTF 2.0, 3.5.3)
            throw InputError(document_.where("nodes[") + std::to_string(index) +
                             "].matrix can't be moved by " + field +
                             "; translation, rotation and scale can.");
        return animation.motions.try_emplace(index, NodeMotion{restTransform(node), {}, {}, {}})
            .first->second;
    }

    Keyframes readSampler(const tinygltf::AnimationSampler& sampler, bool isRotation,
                          const std::string& field) {
        Keyframes keyframes = readKeyframes(sampler, 1, field);
        keyframes.values =
            readValues(sampler.output, isRotation,
                       keyframes.interpolation == Interpolation::cubicSpline, field + ".output");
        return keyframes;
    }

    /// All weights of a time follow each other (glTF 2.0, 3.11).
    Keyframes readWeights(const tinygltf::AnimationSampler& sampler, int node,
                          const std::string& field) {
        const int mesh = document_.model->nodes.at(node).mesh;
        Keyframes keyframes = readKeyframes(sampler, morphTargetCount(document_, mesh), field);
        keyframes.values = readWeightValues(sampler.output, field + ".output");
        return keyframes;
    }

    /// Without its values, which are so many elements each.
    Keyframes readKeyframes(const tinygltf::AnimationSampler& sampler, std::size_t elements,
                            const std::string& field) {
        Keyframes keyframes;
        keyframes.interpolation = interpolationOf(sampler);
        const bool isSpline = keyframes.interpolation == Interpolation::cubicSpline;
        keyframes.times = readTimes(sampler.input, field + ".input");
        const std::size_t count = keyframes.times->size();
        if (isSpline && count < 2)
            throw InputError(document_.where(field) + ".input has 1 element, but a CUBICSPLINE "
                                                      "needs 2 or more.");
        const std::size_t wanted = (isSpline ? 3 * count : count) * elements;
        const std::size_t found = elementCount(document_, sampler.output, field + ".output");
        if (found != wanted)
            throw InputError(document_.where(field) + ".output has " + std::to_string(found) +
                             " elements, but " + sampler.interpolation + " of " +
                             std::to_string(count) + " times " +
                             (elements == 1 ? "" : std::to_string(elements) + " weights ") +
                             "needs " + std::to_string(wanted) + ".");
        return keyframes;
    }

    Floats readTimes(int accessor, const std::string& field) {
        Floats& times = times_[accessor];
        if (times) return times;
        requireKind(document_, accessor, ElementType::scalar, false, "SCALAR floats", field);
        const FloatArray array = readFloats(document_, accessor, field, memory_);
        requireFinite(document_, array, field);
        if (array.values.empty()) throw InputError(document_.where(field) + " has no elements.");
        if (array.values[0] < 0.0f)
            throw InputError(document_.where(field) + " starts at " + shown(array.values[0]) +
                             " seconds, but must not be negative.");
        for (std::size_t i = 1; i < array.values.size(); ++i)
            if (array.values[i] <= array.values[i - 1])
                throw InputError(document_.where(field) + " holds " + shown(array.values[i]) +
                                 " at element " + std::to_string(i) + " after " +
                                 shown(array.values[i - 1]) + ", but times must increase.");
        return times = std::make_shared<const std::vector<float>>(array.values);
    }

    Floats readValues(int accessor, bool isRotation, bool isSpline, const std::string& field) {
        Floats& values = values_[{accessor, isRotation, isSpline}];
        if (values) return values;
        if (isRotation)
            requireKind(document_, accessor, ElementType::vec4, true,
                        "VEC4 floats or normalized bytes or shorts", field);
        else
            requireKind(document_, accessor, ElementType::vec3, false, "VEC3 floats", field);
        const FloatArray array = readFloats(document_, accessor, field, memory_);
        requireFinite(document_, array, field);
        if (isRotation) requireNoZeroQuaternion(array, isSpline, field);
        return values = std::make_shared<const std::vector<float>>(array.values);
    }

    Floats readWeightValues(int accessor, const std::string& field) {
        Floats& values = weights_[accessor];
        if (values) return values;
        requireKind(document_, accessor, ElementType::scalar, true,
                    "SCALAR floats or normalized bytes or shorts", field);
        const FloatArray array = readFloats(document_, accessor, field, memory_);
        requireFinite(document_, array, field);
        return values = std::make_shared<const std::vector<float>>(array.values);
    }

    /// Zero turns nothing into anything; a spline's tangents may be zero.
    void requireNoZeroQuaternion(const FloatArray& array, bool isSpline,
                                 const std::string& field) const {
        for (std::size_t e = isSpline ? 1 : 0; e < array.count(); e += isSpline ? 3 : 1) {
            const float* q = &array.values[4 * e];
            if (q[0] == 0.0f && q[1] == 0.0f && q[2] == 0.0f && q[3] == 0.0f)
                throw InputError(document_.where(field) + " holds (0, 0, 0, 0) at element " +
                                 std::to_string(e) + ", which is no rotation.");
        }
    }

    const GltfDocument& document_;
    MemoryBudget memory_;
    std::map<int, Floats> times_;
    std::map<int, Floats> weights_;
    std::map<std::tuple<int, bool, bool>, Floats> values_; ///< by accessor, is rotation, is spline
};

} // namespace

std::vector<AnimationTitle> animationTitles(const GltfDocument& document) {
    const auto& animations = document.model->animations;
    std::vector<AnimationTitle> titles;
    for (std::size_t i = 0; i < animations.size(); ++i) {
        if (!movesAnything(document, animations[i])) continue;
        const auto& source = document.json.at("animations").at(i);
        const auto name = source.find("name");
        const bool named = name != source.end() && name->is_string();
        titles.push_back({i, named ? name->get<std::string>() : ""});
        if (titles.back().name.empty()) titles.back().name = "animation " + std::to_string(i);
    }
    return titles;
}

const AnimationTitle* findAnimation(const std::vector<AnimationTitle>& titles,
                                    const std::string& nameOrIndex) {
    const auto find = [&](auto matches) {
        const auto found = std::find_if(titles.begin(), titles.end(), matches);
        return found == titles.end() ? nullptr : &*found;
    };
    const AnimationTitle* named =
        find([&](const AnimationTitle& title) { return title.name == nameOrIndex; });
    return named ? named : find([&](const AnimationTitle& title) {
        return std::to_string(title.index) == nameOrIndex;
    });
}

std::optional<Animation> readAnimation(const GltfDocument& document, Warnings& warnings,
                                       std::optional<std::size_t> index) {
    std::optional<Animation> animation;
    AnimationReader reader(document);
    const auto read = [&](std::size_t which) {
        return readOrWarn(warnings, "the animation is left out",
                          [&] { animation = reader.read(which); });
    };
    if (index) {
        read(*index);
        return animation;
    }
    for (const AnimationTitle& title : animationTitles(document))
        if (read(title.index)) break;
    return animation;
}

std::size_t morphTargetCount(const GltfDocument& document, int mesh) {
    const auto& meshes = document.model->meshes;
    std::size_t count = 0;
    if (mesh >= 0 && static_cast<std::size_t>(mesh) < meshes.size())
        for (const tinygltf::Primitive& primitive :
             meshes[static_cast<std::size_t>(mesh)].primitives)
            count = std::max(count, primitive.targets.size());
    return count;
}

std::set<int> morphingNodes(const GltfDocument& document) {
    std::set<int> nodes;
    for (const tinygltf::Animation& animation : document.model->animations)
        for (const tinygltf::AnimationChannel& channel : animation.channels)
            if (movesWeights(document, channel)) nodes.insert(channel.target_node);
    return nodes;
}

} // namespace edgeshade
