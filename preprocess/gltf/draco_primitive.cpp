#include "preprocess/gltf/draco_primitive.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/draco_claim.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"

#include <draco/compression/decode.h>

namespace edgeshade {
namespace {

constexpr const char* dracoExtension = "KHR_draco_mesh_compression";

std::unique_ptr<draco::Mesh> decodeMesh(std::span<const std::uint8_t> bytes,
                                        const std::string& where) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::Decoder decoder;
    auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
    if (!mesh.ok())
        throw InputError(where +
                         " can't be decoded: " + clauseOf(mesh.status().error_msg_string()) + ".");
    return std::move(mesh).value();
}

/// Refuses a stream for which the decoder would allocate far more than the stream can hold.
void requirePlausible(std::span<const std::uint8_t> bytes, const std::string& where,
                      MemoryBudget& memory) {
    // The most regular mesh, a flat grid of equal steps, has 162 triangles a byte at 256 x 256 and
    // 306 at 512 x 512. It would reach this many only at tens of millions of triangles.
    constexpr std::uint64_t largestExpansion = 4096;
    const auto claim = dracoClaim(bytes);
    if (!claim) return;
    const auto check = [&](std::uint64_t count, const char* things) {
        if (count / largestExpansion > bytes.size())
            throw InputError(where + " says that it holds " + std::to_string(count) + " " + things +
                             ", which is too many for " + std::to_string(bytes.size()) + " bytes.");
    };
    check(claim->faces, "triangles");
    check(claim->points, "vertices");
    if (claim->faces > memory.limits().triangles)
        throw InputError(where + " holds " + std::to_string(claim->faces) +
                         " triangles, but the limit is " +
                         std::to_string(memory.limits().triangles) + ".");
    memory.take(claim->memoryBytes(), 1, where);
}

/// Normalises by the glTF accessor's flag, which the Draco stream lacks.
float normalizedValue(float value, int componentType) {
    switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return std::max(value / 127.0f, -1.0f);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return value / 255.0f;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return std::max(value / 32767.0f, -1.0f);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return value / 65535.0f;
    default:
        return value;
    }
}

FloatArray readAttribute(const draco::Mesh& mesh, const draco::PointAttribute& attribute,
                         const tinygltf::Accessor& accessor, const std::string& where) {
    FloatArray array;
    array.components = attribute.num_components();
    if (array.components < 1 || array.components > 4)
        throw InputError(where + " has " + std::to_string(array.components) + " components.");
    array.values.resize(std::size_t{mesh.num_points()} * array.components);
    const bool integers = attribute.data_type() != draco::DT_FLOAT32;
    for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
        float value[4] = {};
        const auto index = attribute.mapped_index(point);
        bool converted;
        if (integers) {
            std::int64_t whole[4] = {};
            converted = attribute.ConvertValue<std::int64_t>(
                index, static_cast<std::int8_t>(array.components), whole);
            for (int c = 0; c < array.components; ++c)
                value[c] = static_cast<float>(whole[c]);
        } else {
            converted = attribute.ConvertValue<float>(
                index, static_cast<std::int8_t>(array.components), value);
        }
        if (!converted) throw InputError(where + " can't be converted.");
        for (int c = 0; c < array.components; ++c)
            array.values[std::size_t{point.value()} * array.components + c] =
                integers && accessor.normalized ? normalizedValue(value[c], accessor.componentType)
                                                : value[c];
    }
    return array;
}

} // namespace

std::optional<DracoPrimitive> readDracoPrimitive(const GltfDocument& document,
                                                 const tinygltf::Primitive& primitive,
                                                 const std::string& field, MemoryBudget& memory) {
    const auto found = primitive.extensions.find(dracoExtension);
    if (found == primitive.extensions.end()) return std::nullopt;
    const tinygltf::Value& extension = found->second;
    const std::string where = document.where(field) + "." + dracoExtension;
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP)
        throw InputError(where + " is used with mode " + std::to_string(primitive.mode) +
                         "; only triangles and triangle strips can be compressed.");

    const auto bytes = bufferViewBytes(document, extension.Get("bufferView").GetNumberAsInt());
    requirePlausible(bytes, where, memory);
    const auto mesh = decodeMesh(bytes, where);

    DracoPrimitive decoded;
    const tinygltf::Value& ids = extension.Get("attributes");
    for (const std::string& name : ids.Keys()) {
        const int id = ids.Get(name).GetNumberAsInt(); // checked by checkDraco() in gltf_checks.cpp
        const auto* attribute = mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
        if (!attribute)
            throw InputError(where + ".attributes." + name + " is " + std::to_string(id) +
                             ", which the compressed mesh does not have.");
        const auto accessor = primitive.attributes.find(name);
        if (accessor == primitive.attributes.end()) continue;
        memory.take(mesh->num_points(), 4 * sizeof(float), where + ".attributes." + name);
        decoded.attributes.emplace(
            name, readAttribute(*mesh, *attribute,
                                accessorAt(document, accessor->second, field + "." + name),
                                where + ".attributes." + name));
    }
    decoded.indices.reserve(std::size_t{mesh->num_faces()} * 3);
    for (draco::FaceIndex face(0); face < mesh->num_faces(); ++face)
        for (const draco::PointIndex& point : mesh->face(face)) {
            if (point.value() >= mesh->num_points())
                throw InputError(where + " holds index " + std::to_string(point.value()) +
                                 ", but there are " + std::to_string(mesh->num_points()) +
                                 " vertices.");
            decoded.indices.push_back(point.value());
        }
    return decoded;
}

} // namespace edgeshade
