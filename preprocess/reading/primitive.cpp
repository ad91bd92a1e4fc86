#include "preprocess/reading/primitive.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/accessor.hpp"
#include "preprocess/gltf/draco_primitive.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"

#include <algorithm>
#include <numeric>

namespace edgeshade {
namespace {

/// Reads the attributes of one primitive, from accessors or Draco data.
class AttributeReader {
  public:
    AttributeReader(const GltfDocument& document, const tinygltf::Primitive& primitive,
                    std::string field, MemoryBudget& memory)
        : document_(document), primitive_(primitive), field_(std::move(field)), memory_(memory),
          draco_(readDracoPrimitive(document, primitive, field_, memory)) {}

    bool has(const std::string& name) const { return primitive_.attributes.contains(name); }

    std::string fieldOf(const std::string& name) const {
        return field_ + ".attributes." + name + " (accessors[" +
               std::to_string(primitive_.attributes.at(name)) + "])";
    }

    /// Reads an attribute with `least` to `most` components per vertex and `count` vertices (0: any
    /// number), all finite.
    FloatArray read(const std::string& name, int least, int most, std::size_t count) const {
        const bool compressed = draco_ && draco_->attributes.contains(name);
        FloatArray array = compressed ? draco_->attributes.at(name)
                                      : readFloats(document_, primitive_.attributes.at(name),
                                                   field_ + ".attributes." + name, memory_);
        if (array.components < least || array.components > most)
            throw InputError(document_.where(fieldOf(name)) + " has " +
                             std::to_string(array.components) + " components, not " +
                             std::to_string(least) +
                             (least == most ? "" : " or " + std::to_string(most)) + ".");
        if (count != 0 && array.count() != count)
            throw InputError(document_.where(fieldOf(name)) + " has " +
                             std::to_string(array.count()) + " elements, but POSITION has " +
                             std::to_string(count) + ".");
        requireFinite(document_, array, fieldOf(name));
        return array;
    }
    FloatArray read(const std::string& name, int components, std::size_t count) const {
        return read(name, components, components, count);
    }

    /// The indices in the order that the primitive's mode uses.
    std::vector<std::uint32_t> readIndexSequence(std::size_t vertexCount) const {
        if (draco_) return draco_->indices;
        std::vector<std::uint32_t> indices;
        if (primitive_.indices >= 0) {
            indices = readIndices(document_, primitive_.indices, field_ + ".indices", memory_);
        } else {
            memory_.take(vertexCount, sizeof(std::uint32_t), document_.where(field_));
            indices.resize(vertexCount);
            std::iota(indices.begin(), indices.end(), 0u);
        }
        return indices;
    }

    bool isTriangleListAlready() const { return draco_.has_value(); }

  private:
    const GltfDocument& document_;
    const tinygltf::Primitive& primitive_;
    std::string field_;
    MemoryBudget& memory_;
    std::optional<DracoPrimitive> draco_;
};

template <glm::length_t N>
std::vector<glm::vec<N, float>> asVectors(const FloatArray& array) {
    std::vector<glm::vec<N, float>> vectors(array.count());
    for (std::size_t i = 0; i < vectors.size(); ++i)
        for (glm::length_t c = 0; c < N; ++c)
            vectors[i][c] = array.values[i * array.components + c];
    return vectors;
}

/// Converts strips and fans to a triangle list of the same orientation (glTF 2.0, 3.7.2.1).
std::vector<std::uint32_t> asTriangleList(std::vector<std::uint32_t> sequence, int mode) {
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        sequence.resize(sequence.size() / 3 * 3);
        return sequence;
    }
    std::vector<std::uint32_t> triangles;
    for (std::size_t i = 0; i + 2 < sequence.size(); ++i) {
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
            triangles.insert(triangles.end(), {sequence[i + 1], sequence[i + 2], sequence[0]});
        else
            triangles.insert(triangles.end(),
                             {sequence[i], sequence[i + 1 + i % 2], sequence[i + 2 - i % 2]});
    }
    return triangles;
}

/// Reads the morph targets of a primitive's `count` vertices (glTF 2.0, 3.7.2.2).
class TargetReader {
  public:
    TargetReader(const GltfDocument& document, const tinygltf::Primitive& primitive,
                 std::string field, std::size_t count, MemoryBudget& memory)
        : document_(document), primitive_(primitive), field_(std::move(field)), count_(count),
          memory_(memory) {}

    /// The target's deltas; empty if it lacks the attribute.
    std::vector<glm::vec3> deltas(std::size_t target, const std::string& name) const {
        const auto found = primitive_.targets[target].find(name);
        if (found == primitive_.targets[target].end()) return {};
        const std::string field = field_ + ".targets[" + std::to_string(target) + "]." + name;
        const FloatArray array = readFloats(document_, found->second, field, memory_);
        if (array.components != 3 || array.count() != count_)
            throw InputError(document_.where(field) + " does not match POSITION.");
        requireFinite(document_, array, field);
        return asVectors<3>(array);
    }

    /// Adds weight * delta of every target that has the attribute.
    void blend(const std::string& name, const std::vector<double>& weights,
               std::vector<glm::vec3>& values) const {
        for (std::size_t t = 0; t < primitive_.targets.size() && t < weights.size(); ++t) {
            if (weights[t] == 0.0 || values.empty()) continue;
            const std::vector<glm::vec3> all = deltas(t, name);
            for (std::size_t i = 0; i < all.size(); ++i)
                values[i] += static_cast<float>(weights[t]) * all[i];
        }
    }

  private:
    const GltfDocument& document_;
    const tinygltf::Primitive& primitive_;
    std::string field_;
    std::size_t count_;
    MemoryBudget& memory_;
};

/// One vertex's influences from all sets: joints ascending, each once, none of weight 0. Without
/// any weight, the first joint gets all of it: no skinned vertex stays in the mesh's own place.
std::vector<Influence> sortedInfluences(std::vector<Influence> given) {
    const std::uint32_t first = given.front().joint;
    std::stable_sort(given.begin(), given.end(),
                     [](const Influence& a, const Influence& b) { return a.joint < b.joint; });
    std::vector<Influence> sorted;
    for (const Influence& influence : given) {
        if (influence.weight == 0.0f) continue;
        if (!sorted.empty() && sorted.back().joint == influence.joint)
            sorted.back().weight += influence.weight;
        else
            sorted.push_back(influence);
    }
    if (totalWeight(sorted) == 0.0) return {{first, 1.0f}};
    return sorted;
}

/// Reads JOINTS_0, WEIGHTS_0 and all further sets.
Influences readInfluences(const AttributeReader& reader, std::size_t count) {
    std::vector<std::vector<glm::vec4>> joints, weights;
    for (std::size_t set = 0;; ++set) {
        const std::string number = "_" + std::to_string(set);
        if (!reader.has("JOINTS" + number) || !reader.has("WEIGHTS" + number)) break;
        joints.push_back(asVectors<4>(reader.read("JOINTS" + number, 4, count)));
        weights.push_back(asVectors<4>(reader.read("WEIGHTS" + number, 4, count)));
    }
    Influences influences;
    if (joints.empty()) return influences;
    influences.firstOf.push_back(0);
    std::vector<Influence> given;
    for (std::size_t v = 0; v < count; ++v) {
        given.clear();
        for (std::size_t set = 0; set < joints.size(); ++set)
            for (glm::length_t i = 0; i < 4; ++i)
                given.push_back(
                    {static_cast<std::uint32_t>(glm::clamp(joints[set][v][i], 0.0f, 65535.0f)),
                     weights[set][v][i]});
        const std::vector<Influence> sorted = sortedInfluences(given);
        influences.all.insert(influences.all.end(), sorted.begin(), sorted.end());
        influences.firstOf.push_back(static_cast<std::uint32_t>(influences.all.size()));
    }
    return influences;
}

bool isTriangleMode(int mode) {
    return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
           mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

} // namespace

Primitive readPrimitive(const GltfDocument& document, std::size_t mesh, std::size_t primitiveIndex,
                        const MorphUse& morphs, const Material& material, Warnings& warnings,
                        MemoryBudget& memory) {
    const tinygltf::Primitive& source = document.model->meshes[mesh].primitives[primitiveIndex];
    const std::string field =
        "meshes[" + std::to_string(mesh) + "].primitives[" + std::to_string(primitiveIndex) + "]";
    Primitive primitive;
    primitive.material = source.material;
    const int mode = source.mode < 0 ? TINYGLTF_MODE_TRIANGLES : source.mode;
    if (!isTriangleMode(mode)) {
        warnings.add("Points and lines are skipped: they cast no shadow.");
        return primitive;
    }
    if (!source.attributes.contains("POSITION")) {
        warnings.add("Primitives without POSITION are skipped.");
        return primitive;
    }

    const AttributeReader reader(document, source, field, memory);
    const FloatArray positions = reader.read("POSITION", 3, 0);
    primitive.positions = asVectors<3>(positions);
    const std::size_t count = primitive.positions.size();
    if (reader.has("NORMAL")) primitive.normals = asVectors<3>(reader.read("NORMAL", 3, count));
    for (int channel = 0; channel < material.texcoordChannels; ++channel) {
        const std::string name = "TEXCOORD_" + std::to_string(material.channels[channel].set);
        if (reader.has(name))
            primitive.texcoords[channel] = asVectors<2>(reader.read(name, 2, count));
    }
    if (material.hasNormalTexture() && reader.has("TANGENT") && reader.has("NORMAL"))
        primitive.tangents = asVectors<4>(reader.read("TANGENT", 4, count));
    if (reader.has("COLOR_0")) {
        FloatArray colors = reader.read("COLOR_0", 3, 4, count);
        primitive.colors.assign(count, glm::vec4(1.0f));
        for (std::size_t i = 0; i < count; ++i)
            for (int c = 0; c < colors.components; ++c)
                primitive.colors[i][c] = colors.values[i * colors.components + c];
    }
    primitive.influences = readInfluences(reader, count);
    const TargetReader targets(document, source, field, count, memory);
    if (!morphs.kept) {
        targets.blend("POSITION", morphs.weights, primitive.positions);
        targets.blend("NORMAL", morphs.weights, primitive.normals);
    }
    for (std::size_t t = 0; morphs.kept && t < source.targets.size(); ++t) {
        MorphTarget& target = primitive.targets.emplace_back();
        target.positions = targets.deltas(t, "POSITION");
        if (!primitive.normals.empty()) target.normals = targets.deltas(t, "NORMAL");
        if (!primitive.tangents.empty()) target.tangents = targets.deltas(t, "TANGENT");
    }

    primitive.indices = reader.readIndexSequence(count);
    for (const std::uint32_t index : primitive.indices)
        if (index >= count)
            throw InputError(document.where(field) + ".indices holds " + std::to_string(index) +
                             ", but there are " + std::to_string(count) + " vertices.");
    if (!reader.isTriangleListAlready())
        primitive.indices = asTriangleList(std::move(primitive.indices), mode);
    return primitive;
}

} // namespace edgeshade
