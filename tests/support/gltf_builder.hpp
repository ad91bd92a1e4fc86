#pragma once

#include "preprocess/base/file_io.hpp"
#include "tests/support/shapes.hpp"

#include <cstring>
#include <filesystem>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace edgeshade::test {

using Json = nlohmann::ordered_json;

/// glTF's component types (glTF 2.0, 5.1.3).
template <class T>
inline constexpr int componentTypeOf = 0;
template <>
inline constexpr int componentTypeOf<std::int8_t> = 5120;
template <>
inline constexpr int componentTypeOf<std::uint8_t> = 5121;
template <>
inline constexpr int componentTypeOf<std::int16_t> = 5122;
template <>
inline constexpr int componentTypeOf<std::uint16_t> = 5123;
template <>
inline constexpr int componentTypeOf<std::uint32_t> = 5125;
template <>
inline constexpr int componentTypeOf<float> = 5126;

/// The bytes of a range of plain values.
template <class T>
Bytes bytesOf(const std::vector<T>& values) {
    Bytes bytes(values.size() * sizeof(T));
    if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

/// Builds glTF assets in code. Helpers append; `json` and `binary` are public, so that a test can
/// spell out the part that it is about.
class GltfBuilder {
  public:
    Json json = {
        {"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", Json::array()}}}}};
    Bytes binary; ///< buffer 0

    /// Each returns the index of the new item.
    int addView(std::span<const std::uint8_t> bytes, int byteStride = 0);
    int addAccessor(int view, int componentType, std::size_t count, const std::string& type,
                    const Json& more = Json::object());
    int addMesh(Json primitives);
    int addMaterial(Json material);
    /// A node; a root of scene 0 unless `isRoot` is false.
    int addNode(Json node, bool isRoot = true);
    int addImage(Json image);

    /// A view and an accessor with `components` values of T per element.
    template <class T>
    int addArray(const std::vector<T>& values, int components, const Json& more = Json::object()) {
        return addAccessor(addView(bytesOf(values)), componentTypeOf<T>,
                           values.size() / static_cast<std::size_t>(components), typeOf(components),
                           more);
    }
    int addVectors(const std::vector<glm::vec2>& vectors);
    int addVectors(const std::vector<glm::vec3>& vectors);
    /// Indices of component type T.
    template <class T>
    int addIndices(const std::vector<std::uint32_t>& indices) {
        return addArray(std::vector<T>(indices.begin(), indices.end()), 1);
    }

    /// A primitive with every attribute of the shape; `more` adds or replaces keys.
    Json primitiveOf(const Shape& shape, const Json& more = Json::object());
    /// A mesh with that primitive.
    int addShape(const Shape& shape, const Json& more = Json::object());
    /// A root node with that mesh: the smallest scene. Returns the node.
    int addShapeNode(const Shape& shape, const Json& more = Json::object());
    /// An animation of a node's translation.
    void animate(int node, const std::string& path = "translation");
    /// Lists an extension as used, and as required unless `required` is false.
    void useExtension(const std::string& name, bool required = true);

    /// The asset as GLB; buffers[0].byteLength is that of `binary`.
    Bytes glb() const;
    /// The asset as JSON text whose buffer 0 has `uri`, or a data URI if `uri` is empty.
    std::string gltf(const std::string& uri = "") const;

  private:
    static const char* typeOf(int components);
    Json jsonWithBuffer(const Json& uri) const;
};

/// An accessor's "min" and "max" for these positions.
Json boundsOf(const std::vector<glm::vec3>& positions);

/// A data URI.
std::string dataUri(std::span<const std::uint8_t> bytes,
                    const std::string& mimeType = "application/octet-stream");

/// A PNG of 2x2 pixels.
Bytes smallPng();

/// A GLB split into parts, for tampering.
struct GlbParts {
    Json json;
    Bytes binary;

    explicit GlbParts(const Bytes& glb);
    Bytes glb() const;
    /// Offset of accessor `accessor`'s first element in `binary`.
    std::size_t offsetOf(int accessor) const;
};

} // namespace edgeshade::test
