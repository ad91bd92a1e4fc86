#pragma once

#include "preprocess/gltf/gltf_document.hpp"

#include <string>
#include <vector>

namespace edgeshade {

/// Component types of accessors, by glTF's numbers (glTF 2.0, 3.6.2.2).
enum class ComponentType : int {
    unsignedByte = 5121,
    unsignedShort = 5123,
    unsignedInt = 5125,
    float32 = 5126
};

/// Element types that requireKind() can demand.
enum class ElementType { scalar, vec3, vec4 };

/// An accessor's elements as floats, `components` per element, one element after the other.
struct FloatArray {
    std::vector<float> values;
    int components = 0;

    std::size_t count() const { return components == 0 ? 0 : values.size() / components; }
};

/// Reads an accessor of any component type as floats, and applies strides, sparse values and
/// normalisation (glTF 2.0, 3.6.2.2). `field` names the use in messages, e.g.
/// "meshes[0].primitives[1].attributes.POSITION". Safe on untrusted input. Throws InputError.
FloatArray readFloats(const GltfDocument& document, int accessor, const std::string& field);

/// Throws InputError naming `field` if the array holds NaN or an infinite value.
void requireFinite(const GltfDocument& document, const FloatArray& array, const std::string& field);

/// Reads a SCALAR accessor of an unsigned component type. Throws InputError.
std::vector<std::uint32_t> readIndices(const GltfDocument& document, int accessor,
                                       const std::string& field);

/// As above, with the memory counted in `memory` before reading.
FloatArray readFloats(const GltfDocument& document, int accessor, const std::string& field,
                      MemoryBudget& memory);
std::vector<std::uint32_t> readIndices(const GltfDocument& document, int accessor,
                                       const std::string& field, MemoryBudget& memory);

/// The accessor with that index. Throws InputError naming `field` if there is none.
const tinygltf::Accessor& accessorAt(const GltfDocument& document, int accessor,
                                     const std::string& field);

/// Its element count, and its buffer view or -1. Both throw as accessorAt().
std::size_t elementCount(const GltfDocument& document, int accessor, const std::string& field);
int bufferViewOf(const GltfDocument& document, int accessor, const std::string& field);

/// Refuses an accessor unless it holds floats of this type or, if `mayBeSmall`, normalised bytes or
/// shorts (the tables of glTF 2.0, 3.11, and EXT_mesh_gpu_instancing). `wanted` describes this in
/// the message. Throws InputError naming `field`.
void requireKind(const GltfDocument& document, int accessor, ElementType type, bool mayBeSmall,
                 const char* wanted, const std::string& field);

} // namespace edgeshade
