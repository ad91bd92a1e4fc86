#include "preprocess/gltf/accessor.hpp"
#include "preprocess/gltf/buffer_view.hpp"
#include "preprocess/packing/edge_codec.hpp"
#include "preprocess/packing/shadow_extension.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

/// Appends views and accessors to a document.
class AccessorWriter {
  public:
    AccessorWriter(Json& json, Bytes& binary) : json_(json), binary_(binary) {}

    int add(std::span<const glm::vec4> vectors) {
        return add(vectors.data(), vectors.size_bytes(), vectors.size(), ComponentType::float32,
                   "VEC4");
    }

    int add(const Bytes& bytes) {
        return add(bytes.data(), bytes.size(), bytes.size(), ComponentType::unsignedByte, "SCALAR");
    }

    /// Adds unsigned integers, in the smallest type that holds them.
    int add(std::span<const std::uint32_t> values) {
        const std::uint32_t largest =
            values.empty() ? 0 : *std::max_element(values.begin(), values.end());
        if (largest <= 0xFF) return addAs<std::uint8_t>(values, ComponentType::unsignedByte);
        if (largest <= 0xFFFF) return addAs<std::uint16_t>(values, ComponentType::unsignedShort);
        return addAs<std::uint32_t>(values, ComponentType::unsignedInt);
    }

  private:
    template <class T>
    int addAs(std::span<const std::uint32_t> values, ComponentType componentType) {
        const std::vector<T> narrow(values.begin(), values.end());
        return add(narrow.data(), narrow.size() * sizeof(T), narrow.size(), componentType,
                   "SCALAR");
    }

    int add(const void* data, std::size_t size, std::size_t count, ComponentType componentType,
            const char* type) {
        const std::size_t view =
            appendView(json_, binary_, {static_cast<const std::uint8_t*>(data), size});
        Json& accessors = json_["accessors"];
        accessors.push_back({{"bufferView", view},
                             {"componentType", static_cast<int>(componentType)},
                             {"count", count},
                             {"type", type}});
        return static_cast<int>(accessors.size()) - 1;
    }

    Json& json_;
    Bytes& binary_;
};

void appendIndexed(const EdgeList& edges, AccessorWriter& writer, Json& batch) {
    const EncodedEdges encoded = encodeEdges(edges);
    batch["edgeCount"] = edges.edges.size();
    batch["edgeVertices"] = writer.add(encoded.vertices);
    batch["oppositeCounts"] = writer.add(encoded.counts);
    batch["oppositeVertices"] = writer.add(encoded.opposites);
}

} // namespace

void appendShadowExtension(Json& json, Bytes& binary, const Scene& scene,
                           const Topologies& topology, Encoding encoding,
                           const CasterSettings& settings) {
    const int maxMultiplicity = sceneMultiplicity(topology);
    Json batches = Json::array();
    AccessorWriter writer(json, binary);
    const std::vector<std::size_t> first = firstOfGeometry(scene.batches);
    for (std::size_t i = 0; i < topology.size(); ++i) {
        if (first[i] != i) continue;
        const BatchTopology& of = *topology[i];
        Json batch = Json::object();
        if (scene.batches[i].node >= 0) batch["node"] = scene.batches[i].node;
        batch["positionsHash"] = hashText(of.hash);
        if (const auto& casters = scene.batches[i].geometry->simplifiedCasters) {
            batch["simplifiedTriangles"] = casters->size() / 3;
            if (!casters->empty()) batch["simplifiedCasters"] = writer.add(*casters);
        }
        if (!of.edges.edges.empty() && encoding == Encoding::indexed)
            appendIndexed(of.edges, writer, batch);
        if (!of.edges.edges.empty() && encoding == Encoding::expanded) {
            const BatchShadow shadow = buildShadow(of, maxMultiplicity);
            batch["sides"] = writer.add(shadow.sides.records);
            batch["caps"] = writer.add(shadow.caps.records);
        }
        batches.push_back(std::move(batch));
    }
    json["extensions"][shadowExtensionName] = {{"version", shadowExtensionVersion},
                                               {"encoding", nameOf(encoding)},
                                               {"maxMultiplicity", maxMultiplicity},
                                               {"weldTolerance", settings.weldTolerance},
                                               {"castMasked", settings.castMasked},
                                               {"casterError", settings.casterError},
                                               {"flatTolerance", settings.flatTolerance},
                                               {"instances", nameOf(settings.instances)},
                                               {"batches", std::move(batches)}};
    json["extensionsUsed"].push_back(shadowExtensionName);
}

} // namespace edgeshade
