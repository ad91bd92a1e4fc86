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

/// The shortest text that reads back as this number.
std::string shown(float number) {
    // Some supported standard libraries lack std::to_chars() for floats.
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
    return Interpolation::linear; // also the default; other values were refused earlier
}

bool movesNode(const tinygltf::AnimationChannel& channel) {
    const std::string& path = channel.target_path;
    return channel.target_node >= 0 &&
           (path == "translation" || path == "rotation" || path == "scale");
}

/// Whether the channel moves weights that the node's mesh has.
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

/// The keyframes of a property in its node's motion.
std::optional<Keyframes>& keyframesOf(NodeMotion& motion, const std::string& path) {
    if (path == "translation") return motion.translation;
    return path == "rotation" ? motion.rotation : motion.scale;
}

/// Reads the animations of one document. An accessor that many samplers use is read and checked
/// once, so that a small file can't cause endless work.
class AnimationReader {
  public:
    AnimationReader(const GltfDocument& document, Warnings& warnings)
        : document_(document), warnings_(warnings), memory_(document.memory) {}

    /// Reads the playable channels; null if there are none.
    std::optional<Animation> read(std::size_t index) {
        const tinygltf::Animation& source = document_.model->animations[index];
        const std::string field = "animations[" + std::to_string(index) + "]";
        Animation animation;
        bool leftOut = false, played = false;
        for (const tinygltf::AnimationChannel& channel : source.channels) {
            if (!movesWeights(document_, channel) && !movesNode(channel)) continue;
            const bool sound = readOrWarn(warnings_, "the channel is left out",
                                          [&] { readChannel(source, channel, field, animation); });
            (sound ? played : leftOut) = true;
        }
        if (leftOut && !played) return std::nullopt;
        return animation;
    }

  private:
    void readChannel(const tinygltf::Animation& source, const tinygltf::AnimationChannel& channel,
                     const std::string& field, Animation& animation) {
        const int node = channel.target_node;
        const std::string& path = channel.target_path;
        const std::string samplerField =
            field + ".samplers[" + std::to_string(channel.sampler) + "]";
        const tinygltf::AnimationSampler& sampler = source.samplers.at(channel.sampler);
        const auto put = [&](std::optional<Keyframes>& to, const auto& read) {
            if (to)
                throw InputError(document_.where(field) + " moves nodes[" + std::to_string(node) +
                                 "]." + path + " with two channels.");
            to = read();
            animation.duration =
                std::max(animation.duration, static_cast<double>(to->times->back()));
        };
        if (path != "weights")
            return put(keyframesOf(motionOf(animation, node, field), path),
                       [&] { return readSampler(sampler, path == "rotation", samplerField); });
        std::optional<Keyframes> keyframes;
        if (const auto known = animation.weights.find(node); known != animation.weights.end())
            keyframes = known->second;
        put(keyframes, [&] { return readWeights(sampler, node, samplerField); });
        animation.weights[node] = std::move(keyframes);
    }

    NodeMotion& motionOf(Animation& animation, int index, const std::string& field) {
        const auto known = animation.motions.find(index);
        if (known != animation.motions.end()) return known->second;
        const NodeTransform rest = restOf(index, field);
        return animation.motions.emplace(index, NodeMotion{rest, {}, {}, {}}).first->second;
    }

    /// The transform of a node at rest, of which channels move parts. A matrix must not be animated
    /// (glTF 2.0, 3.5.3); one composed of translation, rotation and scale is read as these.
    NodeTransform restOf(int index, const std::string& field) {
        const tinygltf::Node& node = document_.model->nodes.at(index);
        if (!hasMatrix(node)) return restTransform(node);
        const std::string matrix = document_.where("nodes[") + std::to_string(index) +
                                   "].matrix can't be animated by " + field;
        const auto parts = partsOf(restMatrix(node));
        if (!parts) throw InputError(matrix + "; only translation, rotation and scale can.");
        warnings_.add(matrix + "; its translation, rotation and scale are animated instead.");
        return *parts;
    }

    Keyframes readSampler(const tinygltf::AnimationSampler& sampler, bool isRotation,
                          const std::string& field) {
        Keyframes keyframes = readKeyframes(sampler, 1, field);
        keyframes.values =
            readValues(sampler.output, isRotation,
                       keyframes.interpolation == Interpolation::cubicSpline, field + ".output");
        return keyframes;
    }

    /// All weights of one time are adjacent (glTF 2.0, 3.11).
    Keyframes readWeights(const tinygltf::AnimationSampler& sampler, int node,
                          const std::string& field) {
        const int mesh = document_.model->nodes.at(node).mesh;
        Keyframes keyframes = readKeyframes(sampler, morphTargetCount(document_, mesh), field);
        keyframes.values = readWeightValues(sampler.output, field + ".output");
        return keyframes;
    }

    /// Reads keyframes without their values, which have `elements` elements each.
    Keyframes readKeyframes(const tinygltf::AnimationSampler& sampler, std::size_t elements,
                            const std::string& field) {
        Keyframes keyframes;
        keyframes.interpolation = interpolationOf(sampler);
        keyframes.times = readTimes(sampler.input, field + ".input");
        const std::size_t count = keyframes.times->size();
        const std::size_t found = elementCount(document_, sampler.output, field + ".output");
        if (keyframes.interpolation == Interpolation::cubicSpline && count == 1) {
            warnings_.add(document_.where(field) +
                          ".input has 1 element, but a CUBICSPLINE needs 2 "
                          "or more; its value stays constant.");
            // without tangents
            if (found == elements) keyframes.interpolation = Interpolation::step;
        }
        const bool isSpline = keyframes.interpolation == Interpolation::cubicSpline;
        const std::size_t wanted = (isSpline ? 3 * count : count) * elements;
        if (found != wanted)
            throw InputError(
                document_.where(field) + ".output has " + std::to_string(found) +
                " elements, but " + sampler.interpolation + " with " + std::to_string(count) +
                " times " + (elements == 1 ? "" : "and " + std::to_string(elements) + " weights ") +
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
            warnings_.add(document_.where(field) + " starts at " + shown(array.values[0]) +
                          " seconds, but must not be negative; it is played from 0 on.");
        for (std::size_t i = 1; i < array.values.size(); ++i) {
            if (array.values[i] > array.values[i - 1]) continue;
            const std::string order = document_.where(field) + " holds " + shown(array.values[i]) +
                                      " at element " + std::to_string(i) + " after " +
                                      shown(array.values[i - 1]) + ", but times must increase";
            if (array.values[i] < array.values[i - 1]) throw InputError(order + ".");
            warnings_.add(order + "; the value jumps there.");
        }
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

    /// Refuses zero quaternions, which are no rotation; a spline's tangents may be zero.
    void requireNoZeroQuaternion(const FloatArray& array, bool isSpline,
                                 const std::string& field) const {
        for (std::size_t e = isSpline ? 1 : 0; e < array.count(); e += isSpline ? 3 : 1) {
            const float* q = &array.values[4 * e];
            if (q[0] == 0.0f && q[1] == 0.0f && q[2] == 0.0f && q[3] == 0.0f)
                throw InputError(document_.where(field) + " holds (0, 0, 0, 0) at element " +
                                 std::to_string(e) + ", which is not a rotation.");
        }
    }

    const GltfDocument& document_;
    Warnings& warnings_;
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
    AnimationReader reader(document, warnings);
    if (index) return reader.read(*index);
    for (const AnimationTitle& title : animationTitles(document))
        if (auto animation = reader.read(title.index)) return animation;
    return std::nullopt;
}

std::vector<AnimationTitle> playedAnimations(const GltfDocument& document, Warnings& warnings) {
    AnimationReader reader(document, warnings);
    std::vector<AnimationTitle> titles = animationTitles(document);
    std::erase_if(titles, [&](const AnimationTitle& title) { return !reader.read(title.index); });
    return titles;
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
