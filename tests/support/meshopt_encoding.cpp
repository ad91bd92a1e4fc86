#include "tests/support/meshopt_encoding.hpp"

#include <meshoptimizer.h>

namespace edgeshade::test {
namespace {

constexpr const char* extensionName = "EXT_meshopt_compression";

template <class Encode>
Bytes encodedWith(std::size_t bound, Encode encode) {
    Bytes bytes(bound);
    bytes.resize(encode(bytes.data(), bytes.size()));
    return bytes;
}

} // namespace

int addMeshoptView(GltfBuilder& gltf, const Bytes& compressed, std::size_t count,
                   std::size_t stride, const std::string& mode, const std::string& filter) {
    if (!gltf.json.contains("buffers")) {
        gltf.useExtension(extensionName);
        gltf.json["buffers"] = {
            Json::object(),
            {{"byteLength", 0}, {"extensions", {{extensionName, {{"fallback", true}}}}}}};
    }
    const int view = gltf.addView(compressed);
    Json& json = gltf.json["bufferViews"][view];
    Json extension = {{"buffer", 0},
                      {"byteOffset", json["byteOffset"]},
                      {"byteLength", compressed.size()},
                      {"byteStride", stride},
                      {"count", count},
                      {"mode", mode}};
    if (!filter.empty()) extension["filter"] = filter;
    Json& fallbackLength = gltf.json["buffers"][1]["byteLength"];
    const auto offset = (fallbackLength.get<std::size_t>() + 3) / 4 * 4;
    json = {{"buffer", 1},
            {"byteOffset", offset},
            {"byteLength", count * stride},
            {"extensions", {{extensionName, extension}}}};
    if (mode == "ATTRIBUTES") json["byteStride"] = stride;
    fallbackLength = offset + count * stride;
    return view;
}

int addMeshoptVertices(GltfBuilder& gltf, const Bytes& vertices, std::size_t stride,
                       const std::string& filter) {
    const std::size_t count = vertices.size() / stride;
    const Bytes compressed = encodedWith(
        meshopt_encodeVertexBufferBound(count, stride), [&](std::uint8_t* to, std::size_t size) {
            return meshopt_encodeVertexBuffer(to, size, vertices.data(), count, stride);
        });
    return addMeshoptView(gltf, compressed, count, stride, "ATTRIBUTES", filter);
}

int addMeshoptTriangles(GltfBuilder& gltf, const std::vector<std::uint32_t>& indices) {
    const Bytes compressed =
        encodedWith(meshopt_encodeIndexBufferBound(indices.size(), indices.size()),
                    [&](std::uint8_t* to, std::size_t size) {
                        return meshopt_encodeIndexBuffer(to, size, indices.data(), indices.size());
                    });
    return addMeshoptView(gltf, compressed, indices.size(), 2, "TRIANGLES");
}

int addMeshoptIndices(GltfBuilder& gltf, const std::vector<std::uint32_t>& indices) {
    const Bytes compressed = encodedWith(
        meshopt_encodeIndexSequenceBound(indices.size(), indices.size()),
        [&](std::uint8_t* to, std::size_t size) {
            return meshopt_encodeIndexSequence(to, size, indices.data(), indices.size());
        });
    return addMeshoptView(gltf, compressed, indices.size(), 2, "INDICES");
}

GltfBuilder meshoptScene(const Shape& shape) {
    GltfBuilder gltf;
    const std::size_t count = shape.positions.size();
    const int positions =
        gltf.addAccessor(addMeshoptVertices(gltf, bytesOf(shape.positions), 12),
                         componentTypeOf<float>, count, "VEC3", boundsOf(shape.positions));
    const int normals = gltf.addAccessor(addMeshoptVertices(gltf, bytesOf(shape.normals), 12),
                                         componentTypeOf<float>, count, "VEC3");
    const int indices =
        gltf.addAccessor(addMeshoptTriangles(gltf, shape.indices), componentTypeOf<std::uint16_t>,
                         shape.indices.size(), "SCALAR");
    const int mesh = gltf.addMesh(
        {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"indices", indices}});
    gltf.addNode({{"mesh", mesh}});
    return gltf;
}

} // namespace edgeshade::test
