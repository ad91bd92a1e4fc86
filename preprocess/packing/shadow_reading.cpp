#include "preprocess/base/error.hpp"
#include "preprocess/gltf/accessor.hpp"
#include "preprocess/packing/edge_codec.hpp"
#include "preprocess/packing/shadow_extension.hpp"
#include "shaders_es2/record_layout.glsl"

#include <cmath>
#include <cstring>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

const char* keyOf(EdgeStream stream) {
    return stream == EdgeStream::vertices ? "edgeVertices"
           : stream == EdgeStream::counts ? "oppositeCounts"
                                          : "oppositeVertices";
}

/// Reads one batch of a packed document.
class BatchReader {
  public:
    BatchReader(const GltfDocument& document, std::size_t index)
        : document_(document),
          field_(std::string(shadowExtensionName) + ".batches[" + std::to_string(index) + "]"),
          batch_((*shadowExtensionOf(document.json))["batches"][index]) {}

    void requireHash(std::uint64_t hash) const {
        const std::string stored = batch_.value("positionsHash", std::string());
        if (stored != hashText(hash))
            fail(".positionsHash is " + stored + ", but the positions have " + hashText(hash) +
                 ": the geometry was changed after packing. Pack the file again");
    }

    void requireNode(int node) const {
        const int stored = batch_.value("node", -1);
        if (stored != node)
            fail(".node is " + std::to_string(stored) + ", but the scene's batch follows node " +
                 std::to_string(node) + ". Pack the file again");
    }

    /// `mostTriangles`: the number before simplification.
    std::vector<std::uint32_t> readSimplified(std::size_t vertexCount,
                                              std::size_t mostTriangles) const {
        if (!batch_.contains("simplifiedTriangles")) fail(".simplifiedTriangles is missing");
        const auto triangles = batch_["simplifiedTriangles"].get<std::size_t>();
        if (triangles == 0) return {};
        if (triangles > mostTriangles)
            fail(".simplifiedTriangles is " + std::to_string(triangles) +
                 ", but there are no more than " + std::to_string(mostTriangles) + " to simplify");
        requireAtMost("simplifiedCasters", 3 * mostTriangles);
        std::vector<std::uint32_t> corners = integers("simplifiedCasters");
        if (corners.size() % 3 != 0 || corners.size() / 3 != triangles)
            fail(".simplifiedCasters holds " + std::to_string(corners.size()) +
                 " corners, but .simplifiedTriangles is " + std::to_string(triangles));
        for (const std::uint32_t corner : corners)
            if (corner >= vertexCount)
                fail(".simplifiedCasters holds " + std::to_string(corner) + ", but the batch has " +
                     std::to_string(vertexCount) + " vertices");
        return corners;
    }

    BatchShadow readExpanded(const CasterMesh& mesh, std::size_t capCount,
                             int maxMultiplicity) const {
        BatchShadow shadow;
        shadow.groups = mesh.groups;
        shadow.sides.maxMultiplicity = maxMultiplicity;
        if (capCount == 0) return shadow;
        // An edge has at most as many records as triangles, and a triangle has three edges.
        requireAtMost("sides", 3 * capCount * shadow.sides.vectorsPerRecord());
        requireAtMost("caps", capCount * CapsData::vectorsPerRecord);
        shadow.sides.records = vectors("sides");
        shadow.caps.records = vectors("caps");
        if (shadow.sides.records.size() % shadow.sides.vectorsPerRecord() != 0)
            fail(".sides has " + std::to_string(shadow.sides.records.size()) +
                 " vectors, which is not a whole number of records");
        if (shadow.caps.records.size() != capCount * CapsData::vectorsPerRecord)
            fail(".caps has " + std::to_string(shadow.caps.records.size()) +
                 " vectors, but there are " + std::to_string(capCount) + " casting triangles");
        requireOrders(shadow.sides);
        requireNoOrders(shadow.caps);
        return shadow;
    }

    EdgeList readIndexed(const WeldedMesh& mesh) const {
        if (mesh.triangles.empty()) return {};
        const std::size_t opposites = 3 * mesh.triangles.size();
        if (!batch_.contains("edgeCount")) fail(".edgeCount is missing");
        const auto edgeCount = batch_["edgeCount"].get<std::size_t>();
        if (edgeCount < 1 || edgeCount > opposites)
            fail(".edgeCount is " + std::to_string(edgeCount) + ", but there are " +
                 std::to_string(mesh.triangles.size()) + " casting triangles");
        requireAtMost("edgeVertices", largestStream(edgeCount, 2));
        requireAtMost("oppositeCounts", largestStream(edgeCount, 1));
        requireAtMost("oppositeVertices", largestStream(opposites, 1));
        DecodedEdges decoded =
            decodeEdges({bytes("edgeVertices"), bytes("oppositeCounts"), bytes("oppositeVertices")},
                        edgeCount, opposites, mesh.positions.size());
        if (decoded.fault)
            fail("." + std::string(keyOf(*decoded.fault)) +
                 (decoded.edge
                      ? " holds an impossible value at edge " + std::to_string(*decoded.edge)
                      : " does not decode"));
        return std::move(decoded.edges);
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

    /// Refuses an accessor with more elements, before reading them.
    void requireAtMost(const char* key, std::size_t most) const {
        const std::size_t count = elementCount(document_, accessorOf(key), field_ + "." + key);
        if (count > most)
            fail("." + std::string(key) + " has " + std::to_string(count) +
                 " elements, but at most " + std::to_string(most) + " can be used");
    }

    std::vector<glm::vec4> vectors(const char* key) const {
        const FloatArray array = readFloats(document_, accessorOf(key), field_ + "." + key);
        if (array.components != 4) fail(std::string(".") + key + " is not a VEC4 accessor");
        for (const float value : array.values)
            if (!std::isfinite(value)) fail(std::string(".") + key + " holds NaN or infinity");
        std::vector<glm::vec4> result(array.count());
        std::memcpy(result.data(), array.values.data(), array.values.size() * sizeof(float));
        return result;
    }

    std::vector<std::uint32_t> integers(const char* key) const {
        return readIndices(document_, accessorOf(key), field_ + "." + key);
    }

    Bytes bytes(const char* key) const {
        const std::vector<std::uint32_t> values = integers(key);
        for (const std::uint32_t value : values)
            if (value > 0xFF) fail("." + std::string(key) + " holds values above 255");
        return {values.begin(), values.end()};
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
                     std::to_string(i) + ", which has no meaning");
        }
    }

    void requireNoOrders(const CapsData& caps) const {
        for (std::size_t i = 0; i < caps.records.size(); ++i)
            if (caps.records[i].w != 0.0f)
                fail(".caps has the fourth component " + std::to_string(caps.records[i].w) +
                     " in vector " + std::to_string(i) + ", but it must be 0");
    }

    const GltfDocument& document_;
    const std::string field_;
    const Json& batch_;
};

} // namespace

void readCasters(const GltfDocument& document, const ShadowHeader& header, Scene& scene) {
    const Json& entries = (*shadowExtensionOf(document.json))["batches"];
    const std::vector<std::size_t> first = firstOfGeometry(scene.batches);
    std::size_t geometries = 0;
    for (std::size_t i = 0; i < first.size(); ++i)
        geometries += first[i] == i ? 1 : 0;
    if (entries.size() != geometries)
        throw InputError(document.where(shadowExtensionName) + ".batches has " +
                         std::to_string(entries.size()) + " entries, but the scene has " +
                         std::to_string(geometries) + " batches. Pack the file again.");
    std::size_t entry = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        Batch& batch = scene.batches[i];
        if (first[i] != i) {
            batch.geometry = scene.batches[first[i]].geometry;
            continue;
        }
        const BatchReader reader(document, entry++);
        reader.requireNode(batch.node);
        reader.requireHash(positionsHash(batch, castingSurfacesOf(*batch.geometry, scene.materials,
                                                                  header.settings.castMasked)));
        if (header.settings.casterError > 0.0 && !batch.deforms())
            batch.geometry.edit().simplifiedCasters = reader.readSimplified(
                batch.geometry->positions.size(), batch.geometry->indices.size() / 3);
    }
}

Shadows readShadows(const GltfDocument& document, const ShadowHeader& header, const Scene& scene) {
    std::size_t entry = 0;
    return byGeometry(scene.batches, [&](std::size_t i) {
        const Batch& batch = scene.batches[i];
        const BatchReader reader(document, entry++);
        BatchTopology topology;
        topology.mesh =
            weldCasters(batch, castersOf(batch, scene.materials, header.settings.castMasked));
        if (header.encoding == Encoding::expanded)
            return std::make_shared<const BatchShadow>(reader.readExpanded(
                topology.mesh, topology.mesh.welded.triangles.size(), header.maxMultiplicity));
        topology.edges = header.encoding == Encoding::indexed
                             ? reader.readIndexed(topology.mesh.welded)
                             : buildEdges(topology.mesh.welded);
        return std::make_shared<const BatchShadow>(buildShadow(topology, header.maxMultiplicity));
    });
}

} // namespace edgeshade
