#include "tests/support/draco_encoding.hpp"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <stdexcept>

namespace edgeshade::test {
namespace {

/// Adds one attribute to the encoder.
template <class Vector>
void addAttribute(draco::TriangleSoupMeshBuilder& builder, const Shape& shape,
                  draco::GeometryAttribute::Type type, const std::vector<Vector>& values) {
    const int id =
        builder.AddAttribute(type, static_cast<std::int8_t>(Vector::length()), draco::DT_FLOAT32);
    for (std::uint32_t i = 0; i < shape.indices.size(); i += 3)
        builder.SetAttributeValuesForFace(id, draco::FaceIndex(i / 3), &values[shape.indices[i]][0],
                                          &values[shape.indices[i + 1]][0],
                                          &values[shape.indices[i + 2]][0]);
}

} // namespace

Bytes dracoEncoded(const Shape& shape) {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(static_cast<int>(shape.indices.size() / 3));
    addAttribute(builder, shape, draco::GeometryAttribute::POSITION, shape.positions);
    addAttribute(builder, shape, draco::GeometryAttribute::NORMAL, shape.normals);
    addAttribute(builder, shape, draco::GeometryAttribute::TEX_COORD, shape.texcoords);
    const auto mesh = builder.Finalize();
    draco::Encoder encoder;
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::NORMAL, 10);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, 12);
    draco::EncoderBuffer buffer;
    if (!encoder.EncodeMeshToBuffer(*mesh, &buffer).ok())
        throw std::runtime_error("the shape can't be encoded");
    return Bytes(buffer.data(), buffer.data() + buffer.size());
}

Json dracoPrimitive(GltfBuilder& gltf, const Shape& shape) {
    const int view = gltf.addView(dracoEncoded(shape));
    const auto claim = [&](const char* type, std::size_t count, int componentType,
                           const Json& more = Json::object()) {
        return gltf.addAccessor(-1, componentType, count, type, more);
    };
    const std::size_t vertices = shape.positions.size();
    return {
        {"attributes",
         {{"POSITION", claim("VEC3", vertices, componentTypeOf<float>, boundsOf(shape.positions))},
          {"NORMAL", claim("VEC3", vertices, componentTypeOf<float>)},
          {"TEXCOORD_0", claim("VEC2", vertices, componentTypeOf<float>)}}},
        {"indices", claim("SCALAR", shape.indices.size(), componentTypeOf<std::uint16_t>)},
        {"extensions",
         {{dracoExtension,
           {{"bufferView", view},
            {"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"TEXCOORD_0", 2}}}}}}}};
}

} // namespace edgeshade::test
