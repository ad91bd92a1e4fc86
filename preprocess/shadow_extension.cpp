#include "preprocess/shadow_extension.hpp"

#include "preprocess/accessor.hpp"
#include "preprocess/error.hpp"
#include "shaders_es2/record_layout.glsl"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <set>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* accessorKeys[] = {"sides", "caps", "edgeVertices", "oppositeCounts",
                                        "oppositeVertices"};

std::string hexadecimal(std::uint64_t value) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return text;
}

/// Adds views and accessors at the end of a document.
class AccessorWriter {
  public:
    AccessorWriter(Json& json, Bytes& binary) : json_(json), binary_(binary) {}

    int add(std::span<const glm::vec4> vectors) {
        return add(vectors.data(), vectors.size_bytes(), vectors.size(),
                   TINYGLTF_COMPONENT_TYPE_FLOAT, "VEC4");
    }

    /// Unsigned integers in the smallest type that holds them.
    int add(std::span<const std::uint32_t> values) {
        const std::uint32_t largest =
            values.empty() ? 0 : *std::max_element(values.begin(), values.end());
        if (largest <= 0xFF)
            return addAs<std::uint8_t>(values, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE);
        if (largest <= 0xFFFF)
            return addAs<std::uint16_t>(values, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
        return addAs<std::uint32_t>(values, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
    }

  private:
    template <class T>
    int addAs(std::span<const std::uint32_t> values, int componentType) {
        const std::vector<T> narrow(values.begin(), values.end());
        return add(narrow.data(), narrow.size() * sizeof(T), narrow.size(), componentType,
                   "SCALAR");
    }

    int add(const void* data, std::size_t size, std::size_t count, int componentType,
            const char* type) {
        binary_.resize((binary_.size() + 3) / 4 * 4, 0);
        json_["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", size}});
        const auto* bytes = static_cast<const std::uint8_t*>(data);
        binary_.insert(binary_.end(), bytes, bytes + size);
        json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                      {"componentType", componentType},
                                      {"count", count},
                                      {"type", type}});
        return static_cast<int>(json_["accessors"].size()) - 1;
    }

    Json& json_;
    Bytes& binary_;
};

void appendIndexed(const EdgeList& edges, AccessorWriter& writer, Json& batch) {
    std::vector<std::uint32_t> edgeVertices, oppositeCounts, oppositeVertices;
    for (const Edge& edge : edges.edges) {
        edgeVertices.insert(edgeVertices.end(), {edge.a, edge.b});
        oppositeCounts.push_back(edge.oppositeCount);
    }
    for (const Opposite& opposite : edges.opposites)
        oppositeVertices.push_back(opposite.vertex);
    batch["edgeVertices"] = writer.add(edgeVertices);
    batch["oppositeCounts"] = writer.add(oppositeCounts);
    batch["oppositeVertices"] = writer.add(oppositeVertices);
}

/// Reads one batch of a packed document.
class BatchReader {
  public:
    BatchReader(const GltfDocument& document, std::size_t index)
        : document_(document),
          field_(std::string(shadowExtensionName) + ".batches[" + std::to_string(index) + "]"),
          batch_(document.json["extensions"][shadowExtensionName]["batches"][index]) {}

    void requireHash(std::uint64_t hash) const {
        const std::string stored = batch_.value("positionsHash", std::string());
        if (stored != hexadecimal(hash))
            fail(".positionsHash is " + stored + ", but the positions have " + hexadecimal(hash) +
                 ": the geometry was changed after packing. Pack the file again");
    }

    void requireNode(int node) const {
        const int stored = batch_.value("node", -1);
        if (stored != node)
            fail(".node is " + std::to_string(stored) + ", but the scene's batch follows node " +
                 std::to_string(node) + ". Pack the file again");
    }

    BatchShadow readExpanded(const CasterMesh& mesh, std::size_t capCount,
                             int maxMultiplicity) const {
        BatchShadow shadow;
        shadow.groups = mesh.groups;
        shadow.sides.maxMultiplicity = maxMultiplicity;
        if (capCount == 0) return shadow;
        shadow.sides.records = vectors("sides");
        shadow.caps.records = vectors("caps");
        if (shadow.sides.records.size() % shadow.sides.vectorsPerRecord() != 0)
            fail(".sides has " + std::to_string(shadow.sides.records.size()) +
                 " vectors, no whole number of records");
        if (shadow.caps.records.size() != capCount * CapsData::vectorsPerRecord)
            fail(".caps has " + std::to_string(shadow.caps.records.size()) +
                 " vectors, but there are " + std::to_string(capCount) + " casting triangles");
        requireOrders(shadow.sides);
        return shadow;
    }

    EdgeList readIndexed(const WeldedMesh& mesh) const {
        EdgeList list;
        if (mesh.triangles.empty()) return list;
        const auto edgeVertices = integers("edgeVertices");
        const auto oppositeCounts = integers("oppositeCounts");
        const auto oppositeVertices = integers("oppositeVertices");
        if (edgeVertices.size() != 2 * oppositeCounts.size())
            fail(".edgeVertices and .oppositeCounts do not match");
        for (std::size_t e = 0; e < oppositeCounts.size(); ++e) {
            const Edge edge{edgeVertices[2 * e], edgeVertices[2 * e + 1],
                            static_cast<std::uint32_t>(list.opposites.size()), oppositeCounts[e]};
            const bool valid =
                edge.a < edge.b && edge.b < mesh.positions.size() && edge.oppositeCount >= 1 &&
                edge.oppositeCount <= oppositeVertices.size() - list.opposites.size();
            if (!valid) fail(".edgeVertices has an invalid edge " + std::to_string(e));
            for (std::uint32_t i = 0; i < edge.oppositeCount; ++i) {
                const std::uint32_t vertex = oppositeVertices[list.opposites.size()];
                if (vertex >= mesh.positions.size() || vertex == edge.a || vertex == edge.b)
                    fail(".oppositeVertices holds " + std::to_string(vertex) + " for edge " +
                         std::to_string(e) + ", which can't be");
                list.opposites.push_back({vertex, 0});
            }
            list.edges.push_back(edge);
        }
        if (list.opposites.size() != 3 * mesh.triangles.size())
            fail(".oppositeVertices has " + std::to_string(list.opposites.size()) +
                 " entries, but there are " + std::to_string(mesh.triangles.size()) +
                 " casting triangles");
        return list;
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(document_.where(field_) + what + ".");
    }

    int accessorOf(const char* key) const {
        if (!batch_.contains(key) || !batch_[key].is_number_integer())
            fail(std::string(".") + key + " is missing");
        return batch_[key].get<int>();
    }

    std::vector<glm::vec4> vectors(const char* key) const {
        const FloatArray array = readFloats(document_, accessorOf(key), field_ + "." + key);
        if (array.components != 4) fail(std::string(".") + key + " is no VEC4 accessor");
        for (const float value : array.values)
            if (!std::isfinite(value)) fail(std::string(".") + key + " holds NaN or infinity");
        std::vector<glm::vec4> result(array.count());
        std::memcpy(result.data(), array.values.data(), array.values.size() * sizeof(float));
        return result;
    }

    std::vector<std::uint32_t> integers(const char* key) const {
        return readIndices(document_, accessorOf(key), field_ + "." + key);
    }

    void requireOrders(const SidesData& sides) const {
        const std::size_t stride = sides.vectorsPerRecord();
        for (std::size_t i = 0; i < sides.records.size(); ++i) {
            const float w = sides.records[i].w;
            const bool isOpposite = i % stride >= 2;
            const bool valid = isOpposite ? w == static_cast<float>(ORDER_ABSENT) ||
                                                w == static_cast<float>(ORDER_OPPOSITE_FIRST) ||
                                                w == static_cast<float>(ORDER_OPPOSITE_BETWEEN) ||
                                                w == static_cast<float>(ORDER_OPPOSITE_LAST)
                                          : w == 0.0f;
            if (!valid)
                fail(".sides has the fourth component " + std::to_string(w) + " in vector " +
                     std::to_string(i) + ", which means nothing");
        }
    }

    const GltfDocument& document_;
    const std::string field_;
    const Json& batch_;
};

const Json* extensionOf(const Json& json) {
    const auto extensions = json.find("extensions");
    if (extensions == json.end() || !extensions->is_object()) return nullptr;
    const auto extension = extensions->find(shadowExtensionName);
    return extension == extensions->end() ? nullptr : &*extension;
}

/// Indices of all accessors that the extension refers to.
std::set<int> accessorsOf(const Json& extension) {
    std::set<int> accessors;
    for (const Json& batch : extension.at("batches"))
        for (const char* key : accessorKeys)
            if (batch.contains(key)) accessors.insert(batch.at(key).get<int>());
    return accessors;
}

} // namespace

const char* nameOf(Encoding encoding) {
    switch (encoding) {
    case Encoding::expanded:
        return "expanded";
    case Encoding::indexed:
        return "indexed";
    default:
        return "none";
    }
}

std::optional<ShadowHeader> readShadowHeader(const GltfDocument& document) {
    const Json* extension = extensionOf(document.json);
    if (!extension) return std::nullopt;
    const std::string name = shadowExtensionName;
    try {
        const int version = extension->at("version").get<int>();
        if (version != shadowExtensionVersion)
            throw InputError(document.where(name) + ".version is " + std::to_string(version) +
                             "; this program reads version " +
                             std::to_string(shadowExtensionVersion) + ".");
        ShadowHeader header;
        const auto encoding = extension->at("encoding").get<std::string>();
        bool known = false;
        for (const Encoding candidate : {Encoding::expanded, Encoding::indexed, Encoding::none})
            if (encoding == nameOf(candidate)) {
                header.encoding = candidate;
                known = true;
            }
        if (!known)
            throw InputError(document.where(name) + ".encoding is '" + encoding +
                             "', which is not known.");
        header.maxMultiplicity = extension->at("maxMultiplicity").get<int>();
        if (header.maxMultiplicity < 1 || header.maxMultiplicity > LARGEST_RECORD_MULTIPLICITY)
            throw InputError(document.where(name) + ".maxMultiplicity is " +
                             std::to_string(header.maxMultiplicity) + ", not 1 to " +
                             std::to_string(LARGEST_RECORD_MULTIPLICITY) + ".");
        header.settings.weldTolerance = extension->at("weldTolerance").get<double>();
        header.settings.castMasked = extension->at("castMasked").get<bool>();
        if (!(header.settings.weldTolerance >= 0.0))
            throw InputError(document.where(name) + ".weldTolerance is negative.");
        if (!extension->at("batches").is_array())
            throw InputError(document.where(name) + ".batches is no array.");
        return header;
    } catch (const Json::exception& error) {
        throw InputError(document.where(name) + " is malformed: " + error.what() + ".");
    }
}

std::vector<BatchShadow> readShadows(const GltfDocument& document, const ShadowHeader& header,
                                     const Scene& scene) {
    const Json& batches = (*extensionOf(document.json))["batches"];
    if (batches.size() != scene.batches.size())
        throw InputError(document.where(shadowExtensionName) + ".batches has " +
                         std::to_string(batches.size()) + " entries, but the scene has " +
                         std::to_string(scene.batches.size()) + " batches. Pack the file again.");
    std::vector<BatchShadow> shadows;
    try {
        for (std::size_t i = 0; i < scene.batches.size(); ++i) {
            const Batch& batch = scene.batches[i];
            const Casters casters = castersOf(batch, scene.materials, header.settings.castMasked);
            const BatchReader reader(document, i);
            reader.requireNode(batch.node);
            reader.requireHash(positionsHash(batch, casters));
            BatchTopology topology;
            topology.mesh = weldCasters(batch, casters);
            if (header.encoding == Encoding::expanded) {
                shadows.push_back(reader.readExpanded(
                    topology.mesh, topology.mesh.welded.triangles.size(), header.maxMultiplicity));
                continue;
            }
            topology.edges = header.encoding == Encoding::indexed
                                 ? reader.readIndexed(topology.mesh.welded)
                                 : buildEdges(topology.mesh.welded);
            shadows.push_back(buildShadow(topology, header.maxMultiplicity));
        }
    } catch (const Json::exception& error) {
        throw InputError(document.where(shadowExtensionName) + " is malformed: " + error.what() +
                         ".");
    }
    return shadows;
}

std::size_t storedShadowBytes(const GltfDocument& document) {
    const Json* extension = extensionOf(document.json);
    if (!extension) return 0;
    std::size_t bytes = 0;
    for (const int accessor : accessorsOf(*extension))
        bytes += bufferViewBytes(document,
                                 accessorAt(document, accessor, shadowExtensionName).bufferView)
                     .size();
    return bytes;
}

void appendShadowExtension(Json& json, Bytes& binary, const Scene& scene,
                           const std::vector<BatchTopology>& topology, Encoding encoding,
                           const CasterSettings& settings) {
    const int maxMultiplicity = sceneMultiplicity(topology);
    Json batches = Json::array();
    AccessorWriter writer(json, binary);
    for (std::size_t i = 0; i < topology.size(); ++i) {
        Json batch = Json::object();
        if (scene.batches[i].node >= 0) batch["node"] = scene.batches[i].node;
        batch["positionsHash"] = hexadecimal(topology[i].hash);
        if (!topology[i].edges.edges.empty() && encoding == Encoding::indexed)
            appendIndexed(topology[i].edges, writer, batch);
        if (!topology[i].edges.edges.empty() && encoding == Encoding::expanded) {
            const BatchShadow shadow = buildShadow(topology[i], maxMultiplicity);
            batch["sides"] = writer.add(shadow.sides.records);
            batch["caps"] = writer.add(shadow.caps.records);
        }
        batches.push_back(std::move(batch));
    }
    json["extensions"][shadowExtensionName] = {
        {"version", shadowExtensionVersion},  {"encoding", nameOf(encoding)},
        {"maxMultiplicity", maxMultiplicity}, {"weldTolerance", settings.weldTolerance},
        {"castMasked", settings.castMasked},  {"batches", std::move(batches)}};
    Json& used = json["extensionsUsed"];
    if (std::find(used.begin(), used.end(), shadowExtensionName) == used.end())
        used.push_back(shadowExtensionName);
}

void removeShadowExtension(Json& json, Bytes& binary, const std::filesystem::path& path) {
    const Json* extension = extensionOf(json);
    if (!extension) return;
    const std::set<int> accessors = accessorsOf(*extension);
    for (auto accessor = accessors.rbegin(); accessor != accessors.rend(); ++accessor) {
        const bool isLast = *accessor == static_cast<int>(json["accessors"].size()) - 1;
        const auto view =
            isLast ? json["accessors"][*accessor].value("bufferView", std::size_t{0}) : 0;
        if (!isLast || view + 1 != json["bufferViews"].size())
            throw InputError("'" + path.string() +
                             "' was rearranged after it was packed: pack "
                             "the original instead.");
        const auto offset = json["bufferViews"][view].value("byteOffset", std::size_t{0});
        if (offset <= binary.size()) binary.resize(offset);
        json["accessors"].erase(json["accessors"].size() - 1);
        json["bufferViews"].erase(view);
    }
    json["extensions"].erase(shadowExtensionName);
    if (json["extensions"].empty()) json.erase("extensions");
    Json& used = json["extensionsUsed"];
    used.erase(std::remove(used.begin(), used.end(), shadowExtensionName), used.end());
    if (used.empty()) json.erase("extensionsUsed");
    for (const char* section : {"accessors", "bufferViews"})
        if (json.contains(section) && json[section].empty()) json.erase(section);
}

} // namespace edgeshade
