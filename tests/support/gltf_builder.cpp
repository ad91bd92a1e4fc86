#include "tests/support/gltf_builder.hpp"

#include "preprocess/gltf/glb.hpp"

namespace edgeshade::test {
namespace {

int append(Json& json, const char* section, Json item) {
    json[section].push_back(std::move(item));
    return static_cast<int>(json[section].size()) - 1;
}

template <class Vector>
std::vector<float> flat(const std::vector<Vector>& vectors) {
    std::vector<float> values;
    for (const Vector& vector : vectors)
        for (glm::length_t c = 0; c < Vector::length(); ++c)
            values.push_back(vector[c]);
    return values;
}

} // namespace

int GltfBuilder::addView(std::span<const std::uint8_t> bytes, int byteStride) {
    binary.resize((binary.size() + 3) / 4 * 4, 0);
    Json view = {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}};
    if (byteStride != 0) view["byteStride"] = byteStride;
    binary.insert(binary.end(), bytes.begin(), bytes.end());
    return append(json, "bufferViews", std::move(view));
}

int GltfBuilder::addAccessor(int view, int componentType, std::size_t count,
                             const std::string& type, const Json& more) {
    Json accessor = {{"componentType", componentType}, {"count", count}, {"type", type}};
    if (view >= 0) accessor["bufferView"] = view;
    accessor.update(more);
    return append(json, "accessors", std::move(accessor));
}

int GltfBuilder::addMesh(Json primitives) {
    if (primitives.is_object()) primitives = Json::array({std::move(primitives)});
    return append(json, "meshes", {{"primitives", std::move(primitives)}});
}

int GltfBuilder::addMaterial(Json material) {
    return append(json, "materials", std::move(material));
}

int GltfBuilder::addNode(Json node, bool isRoot) {
    const int index = append(json, "nodes", std::move(node));
    if (isRoot) json["scenes"][0]["nodes"].push_back(index);
    return index;
}

int GltfBuilder::addImage(Json image) {
    return append(json, "images", std::move(image));
}

int GltfBuilder::addVectors(const std::vector<glm::vec2>& vectors) {
    return addArray(flat(vectors), 2);
}

int GltfBuilder::addVectors(const std::vector<glm::vec3>& vectors) {
    return addArray(flat(vectors), 3, boundsOf(vectors));
}

Json GltfBuilder::primitiveOf(const Shape& shape, const Json& more) {
    Json attributes = {{"POSITION", addVectors(shape.positions)}};
    if (!shape.normals.empty()) attributes["NORMAL"] = addVectors(shape.normals);
    if (!shape.texcoords.empty()) attributes["TEXCOORD_0"] = addVectors(shape.texcoords);
    Json primitive = {{"attributes", attributes}};
    if (!shape.indices.empty())
        primitive["indices"] = shape.positions.size() < 65536
                                   ? addIndices<std::uint16_t>(shape.indices)
                                   : addIndices<std::uint32_t>(shape.indices);
    primitive.update(more);
    return primitive;
}

int GltfBuilder::addShape(const Shape& shape, const Json& more) {
    return addMesh(primitiveOf(shape, more));
}

int GltfBuilder::addShapeNode(const Shape& shape, const Json& more) {
    return addNode({{"mesh", addShape(shape, more)}});
}

void GltfBuilder::animate(int node, const std::string& path) {
    const int components = path == "rotation" ? 4 : 3;
    const int times = addArray<float>({0.0f, 1.0f}, 1, {{"min", {0.0}}, {"max", {1.0}}});
    std::vector<float> values(static_cast<std::size_t>(2 * components), 0.0f);
    if (path == "rotation") values[3] = values[7] = 1.0f;
    const int output = addArray(values, components);
    append(json, "animations",
           {{"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}},
            {"samplers", {{{"input", times}, {"output", output}}}}});
}

void GltfBuilder::useExtension(const std::string& name, bool required) {
    json["extensionsUsed"].push_back(name);
    if (required) json["extensionsRequired"].push_back(name);
}

Bytes GltfBuilder::glb() const {
    return joinGlb(jsonWithBuffer(nullptr).dump(), binary);
}

std::string GltfBuilder::gltf(const std::string& uri) const {
    return jsonWithBuffer(uri.empty() ? dataUri(binary) : uri).dump(1);
}

Json GltfBuilder::jsonWithBuffer(const Json& uri) const {
    Json whole = json;
    if (binary.empty()) return whole;
    if (!whole.contains("buffers")) whole["buffers"] = Json::array({Json::object()});
    Json& buffer = whole["buffers"][0];
    if (!buffer.is_object()) return whole;
    if (!buffer.contains("byteLength")) buffer["byteLength"] = binary.size();
    if (uri.is_string() && !buffer.contains("uri")) buffer["uri"] = uri;
    return whole;
}

const char* GltfBuilder::typeOf(int components) {
    switch (components) {
    case 1:
        return "SCALAR";
    case 2:
        return "VEC2";
    case 3:
        return "VEC3";
    case 4:
        return "VEC4";
    default:
        return "MAT4";
    }
}

Json boundsOf(const std::vector<glm::vec3>& positions) {
    if (positions.empty()) return Json::object();
    glm::vec3 low = positions.front(), high = positions.front();
    for (const glm::vec3& position : positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    return {{"min", {low.x, low.y, low.z}}, {"max", {high.x, high.y, high.z}}};
}

std::string dataUri(std::span<const std::uint8_t> bytes, const std::string& mimeType) {
    constexpr const char* alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text = "data:" + mimeType + ";base64,";
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? alphabet[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

Bytes smallPng() {
    return {0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49,
            0x48, 0x44, 0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x02, 0x08, 0x02,
            0x00, 0x00, 0x00, 0xFD, 0xD4, 0x9A, 0x73, 0x00, 0x00, 0x00, 0x14, 0x49, 0x44,
            0x41, 0x54, 0x78, 0xDA, 0x63, 0xF8, 0xCF, 0xC0, 0xC0, 0x00, 0xC2, 0x0C, 0xFF,
            0xFF, 0xFF, 0x67, 0x00, 0x00, 0x1E, 0xEF, 0x04, 0xFC, 0x73, 0x1C, 0x53, 0xCC,
            0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};
}

GlbParts::GlbParts(const Bytes& glb) {
    GlbChunks chunks = splitGlb(glb, "test.glb");
    json = Json::parse(chunks.json);
    if (chunks.binary) binary = std::move(*chunks.binary);
}

Bytes GlbParts::glb() const {
    return joinGlb(json.dump(), binary);
}

std::size_t GlbParts::offsetOf(int accessor) const {
    const Json& view =
        json["bufferViews"].at(json["accessors"].at(accessor).at("bufferView").get<std::size_t>());
    return view.value("byteOffset", std::size_t{0}) +
           json["accessors"][accessor].value("byteOffset", std::size_t{0});
}

} // namespace edgeshade::test
