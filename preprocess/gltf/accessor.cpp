#include "preprocess/gltf/accessor.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace edgeshade {
namespace {

/// The elements must fit into memory as floats, which is 4 GiB in a browser.
constexpr std::size_t largestCount =
    std::min(std::size_t{1} << 30, std::numeric_limits<std::size_t>::max() / (16 * sizeof(float)));

int componentsOf(int type) {
    switch (type) {
    case TINYGLTF_TYPE_SCALAR:
        return 1;
    case TINYGLTF_TYPE_VEC2:
        return 2;
    case TINYGLTF_TYPE_VEC3:
        return 3;
    case TINYGLTF_TYPE_VEC4:
        return 4;
    case TINYGLTF_TYPE_MAT4:
        return 16;
    default:
        return 0; // small matrices have padding and are never used here
    }
}

std::size_t bytesOf(int componentType) {
    switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return 4;
    default:
        return 0;
    }
}

template <class T>
T load(const std::uint8_t* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

template <class T>
float loadSmall(const std::uint8_t* at, bool normalized) {
    const float value = load<T>(at);
    return normalized ? std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0f)
                      : value;
}

float loadFloat(const std::uint8_t* at, int componentType, bool normalized) {
    switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return loadSmall<std::int8_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return loadSmall<std::uint8_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return loadSmall<std::int16_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return loadSmall<std::uint16_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return static_cast<float>(load<std::uint32_t>(at));
    default:
        return load<float>(at);
    }
}

std::uint32_t loadIndex(const std::uint8_t* at, int componentType) {
    switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return load<std::uint8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return load<std::uint16_t>(at);
    default:
        return load<std::uint32_t>(at);
    }
}

bool isIndexType(int componentType) {
    return componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

/// `count` elements of `elementSize` bytes, `stride` apart, known to lie within one view.
struct ElementRange {
    const std::uint8_t* first;
    std::size_t stride;
};

/// Locates the elements. `view` and `offset` as in glTF; throws if any element is outside the view.
ElementRange elements(const GltfDocument& document, int view, std::size_t offset, std::size_t count,
                      std::size_t elementSize, bool strided, const std::string& field) {
    const auto bytes = bufferViewBytes(document, view);
    const std::size_t viewStride = document.model->bufferViews[view].byteStride;
    const std::size_t stride = strided && viewStride != 0 ? viewStride : elementSize;
    const bool fits =
        stride >= elementSize &&
        (count == 0 || (offset <= bytes.size() && elementSize <= bytes.size() - offset &&
                        (count - 1) <= (bytes.size() - offset - elementSize) / stride));
    if (!fits)
        throw InputError(document.where(field) + ": " + std::to_string(count) + " elements of " +
                         std::to_string(elementSize) + " bytes at offset " +
                         std::to_string(offset) + " do not fit into bufferViews[" +
                         std::to_string(view) + "] of " + std::to_string(bytes.size()) + " bytes.");
    return {bytes.data() + offset, stride};
}

/// Calls store(element, address) for every element of the accessor and then for every sparse one.
template <class Store>
void forEachElement(const GltfDocument& document, const tinygltf::Accessor& accessor,
                    std::size_t elementSize, const std::string& field, Store store) {
    if (accessor.bufferView >= 0) {
        const ElementRange range = elements(document, accessor.bufferView, accessor.byteOffset,
                                            accessor.count, elementSize, true, field);
        for (std::size_t i = 0; i < accessor.count; ++i)
            store(i, range.first + i * range.stride);
    }
    if (!accessor.sparse.isSparse) return;

    const auto& sparse = accessor.sparse;
    if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > accessor.count)
        throw InputError(document.where(field) + ".sparse.count is " +
                         std::to_string(sparse.count) + ", which is out of range.");
    const int indexType = sparse.indices.componentType;
    if (!isIndexType(indexType))
        throw InputError(document.where(field) + ".sparse.indices.componentType is " +
                         std::to_string(indexType) + ", which is not an unsigned integer type.");
    const auto count = static_cast<std::size_t>(sparse.count);
    const ElementRange indices =
        elements(document, sparse.indices.bufferView, sparse.indices.byteOffset, count,
                 bytesOf(indexType), false, field + ".sparse.indices");
    const ElementRange values =
        elements(document, sparse.values.bufferView, sparse.values.byteOffset, count, elementSize,
                 false, field + ".sparse.values");
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t element = loadIndex(indices.first + i * indices.stride, indexType);
        if (element >= accessor.count)
            throw InputError(document.where(field) + ".sparse.indices holds " +
                             std::to_string(element) + ", but there are " +
                             std::to_string(accessor.count) + " elements.");
        store(element, values.first + i * values.stride);
    }
}

/// Throws where the accessor's elements, but for sparse ones, are not all there. An accessor
/// without a buffer view is all zeros, and no data backs its count.
void requireData(const GltfDocument& document, const tinygltf::Accessor& accessor,
                 std::size_t elementSize, const std::string& field) {
    if (accessor.bufferView >= 0)
        elements(document, accessor.bufferView, accessor.byteOffset, accessor.count, elementSize,
                 true, field);
    else if (accessor.count > (1u << 24))
        throw InputError(document.where(field) + ".count is " + std::to_string(accessor.count) +
                         " without any data.");
}

/// tinygltf's constant for the type.
int typeOf(ElementType type) {
    switch (type) {
    case ElementType::scalar:
        return TINYGLTF_TYPE_SCALAR;
    case ElementType::vec3:
        return TINYGLTF_TYPE_VEC3;
    default:
        return TINYGLTF_TYPE_VEC4;
    }
}

/// Counts the accessor's memory once read: a float or an index per component.
void takeFor(const GltfDocument& document, int index, const std::string& field,
             MemoryBudget& memory) {
    const tinygltf::Accessor& accessor = accessorAt(document, index, field);
    memory.take(std::uint64_t{accessor.count} * sizeof(float) *
                    static_cast<unsigned>(std::max(componentsOf(accessor.type), 1)),
                1, document.where(field));
}

} // namespace

const tinygltf::Accessor& accessorAt(const GltfDocument& document, int accessor,
                                     const std::string& field) {
    const auto& accessors = document.model->accessors;
    if (accessor < 0 || static_cast<std::size_t>(accessor) >= accessors.size())
        throw InputError(document.where(field) + " is accessor " + std::to_string(accessor) +
                         ", but there are " + std::to_string(accessors.size()) + ".");
    if (accessors[accessor].count > largestCount)
        throw InputError(document.where(field) + ": accessors[" + std::to_string(accessor) +
                         "].count is " + std::to_string(accessors[accessor].count) +
                         ", which is too many.");
    return accessors[accessor];
}

std::size_t elementCount(const GltfDocument& document, int accessor, const std::string& field) {
    return accessorAt(document, accessor, field).count;
}

int bufferViewOf(const GltfDocument& document, int accessor, const std::string& field) {
    return accessorAt(document, accessor, field).bufferView;
}

FloatArray readFloats(const GltfDocument& document, int index, const std::string& field) {
    const tinygltf::Accessor& accessor = accessorAt(document, index, field);
    const std::string name = field + " (accessors[" + std::to_string(index) + "])";
    const std::size_t componentSize = bytesOf(accessor.componentType);
    FloatArray array;
    array.components = componentsOf(accessor.type);
    if (array.components == 0 || componentSize == 0)
        throw InputError(document.where(name) + " has type " + std::to_string(accessor.type) +
                         " and componentType " + std::to_string(accessor.componentType) +
                         ", which is not supported.");
    requireData(document, accessor, componentSize * array.components, name);
    array.values.resize(accessor.count * array.components);
    forEachElement(document, accessor, componentSize * array.components, name,
                   [&](std::size_t element, const std::uint8_t* at) {
                       for (int c = 0; c < array.components; ++c)
                           array.values[element * array.components + c] = loadFloat(
                               at + c * componentSize, accessor.componentType, accessor.normalized);
                   });
    return array;
}

void requireFinite(const GltfDocument& document, const FloatArray& array,
                   const std::string& field) {
    for (std::size_t i = 0; i < array.values.size(); ++i)
        if (!std::isfinite(array.values[i]))
            throw InputError(document.where(field) + " holds " +
                             (std::isnan(array.values[i]) ? "NaN" : "an infinite value") +
                             " at element " + std::to_string(i / array.components) + ".");
}

std::vector<std::uint32_t> readIndices(const GltfDocument& document, int index,
                                       const std::string& field) {
    const tinygltf::Accessor& accessor = accessorAt(document, index, field);
    const std::string name = field + " (accessors[" + std::to_string(index) + "])";
    if (accessor.type != TINYGLTF_TYPE_SCALAR || !isIndexType(accessor.componentType))
        throw InputError(document.where(name) + " has componentType " +
                         std::to_string(accessor.componentType) +
                         ", but must be a scalar of an unsigned integer type.");
    const std::size_t size = bytesOf(accessor.componentType);
    requireData(document, accessor, size, name);
    std::vector<std::uint32_t> indices(accessor.count);
    forEachElement(document, accessor, size, name,
                   [&](std::size_t element, const std::uint8_t* at) {
                       indices[element] = loadIndex(at, accessor.componentType);
                   });
    return indices;
}

FloatArray readFloats(const GltfDocument& document, int index, const std::string& field,
                      MemoryBudget& memory) {
    takeFor(document, index, field, memory);
    return readFloats(document, index, field);
}

std::vector<std::uint32_t> readIndices(const GltfDocument& document, int index,
                                       const std::string& field, MemoryBudget& memory) {
    takeFor(document, index, field, memory);
    return readIndices(document, index, field);
}

void requireKind(const GltfDocument& document, int index, ElementType type, bool mayBeSmall,
                 const char* wanted, const std::string& field) {
    const tinygltf::Accessor& accessor = accessorAt(document, index, field);
    const int component = accessor.componentType;
    const bool isSmall = component == TINYGLTF_COMPONENT_TYPE_BYTE ||
                         component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                         component == TINYGLTF_COMPONENT_TYPE_SHORT ||
                         component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    const bool isRight = component == TINYGLTF_COMPONENT_TYPE_FLOAT ||
                         (mayBeSmall && isSmall && accessor.normalized);
    if (accessor.type == typeOf(type) && isRight) return;
    throw InputError(
        document.where(field) + " is accessors[" + std::to_string(index) + "], " +
        document.json["accessors"][static_cast<std::size_t>(index)]["type"].get<std::string>() +
        " of " + (accessor.normalized ? "normalized " : "") + "componentType " +
        std::to_string(component) + ", but must be " + wanted + ".");
}

} // namespace edgeshade
