#pragma once

#include "preprocess/gltf/gltf_document.hpp"

#include <string>
#include <vector>

namespace edgeshade {

/// What an accessor's elements are made of, by glTF's numbers (glTF 2.0, 3.6.2.2).
enum class ComponentType : int {
    unsignedByte = 5121,
    unsignedShort = 5123,
    unsignedInt = 5125,
    float32 = 5126
};

/// And what they are, of those that are asked for.
enum class ElementType { scalar, vec3, vec4 };

/// An accessor's elements as floats, `components` a element, one after the other.
struct FloatArray {
    std::vector<float> values;
    int components = 0;

    std::size_t count() const { return components == 0 ? 0 : values.size() / components; }
};

/// Reads an accessor of any component type as floats: strides, sparse values and normalisation
/// (glTF 2.0, 3.6.2.2) applied. `field` names the use in messages, e.g.
/// "meshes[0].primitives[1].attributes.POSITION". Safe on untrusted input. Throws InputError.
FloatArray readFloats(const GltfDocument& document, int accessor, const std::string& field);

/// Throws InputError where the array, which `field` names, holds NaN or an infinite value.
void requireFinite(const GltfDocument& document, const FloatArray& array, const std::string& field);

/// Reads a SCALAR accessor of an unsigned component type. Throws InputError.
std::vector<std::uint32_t> readIndices(const GltfDocument& document, int accessor,
                                       const std::string& field);

/// The same, counted in `memory` before anything is read.
FloatArray readFloats(const GltfDocument& document, int accessor, const std::string& field,
                      MemoryBudget& memory);
std::vector<std::uint32_t> readIndices(const GltfDocument& document, int accessor,
                                       const std::string& field, MemoryBudget& memory);

/// The accessor with that index. Throws InputError naming `field` if there is none.
const tinygltf::Accessor& accessorAt(const GltfDocument& document, int accessor,
                                     const std::string& field);

/// How many elements it has, and its buffer view, -1 for none. Throw the same.
std::size_t elementCount(const GltfDocument& document, int accessor, const std::string& field);
int bufferViewOf(const GltfDocument& document, int accessor, const std::string& field);

/// Refuses an accessor that holds anything but floats of this type or, if `mayBeSmall`, normalised
/// bytes or shorts (the tables of glTF 2.0, 3.11, and EXT_mesh_gpu_instancing). `wanted` says so in
/// a message. Throws InputError naming `field`.
void requireKind(const GltfDocument& document, int accessor, ElementType type, bool mayBeSmall,
                 const char* wanted, const std::string& field);

} // namespace edgeshade
