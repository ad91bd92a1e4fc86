#include "preprocess/reading/instances.hpp"

#include "preprocess/gltf/accessor.hpp"
#include "preprocess/gltf/json_field.hpp"
#include "preprocess/scene/node_transform.hpp"

namespace edgeshade {
namespace {

/// The number of instances; every attribute must have one value for each.
std::size_t countInstances(const GltfDocument& document, const JsonField& attributes) {
    std::optional<std::size_t> count;
    std::string first;
    attributes.forEachMember([&](const JsonField& attribute) {
        const std::size_t found = elementCount(document, attribute.index(), attribute.name());
        if (count && *count != found)
            attribute.fail(" has " + std::to_string(found) + " elements, but " + first + " has " +
                           std::to_string(*count));
        if (!count) first = attribute.key();
        count = found;
    });
    return count.value_or(1); // withAttributes() never passes an empty object
}

/// The attribute's values; empty if it is missing.
FloatArray readAttribute(const GltfDocument& document, const JsonField& attributes,
                         const char* name, ElementType type, const char* wanted,
                         MemoryBudget& memory) {
    FloatArray values;
    attributes.ifPresent(name, [&](const JsonField& attribute) {
        const std::string field = attribute.name();
        const bool isRotation = type == ElementType::vec4;
        requireKind(document, attribute.index(), type, isRotation, wanted, field);
        values = readFloats(document, attribute.index(), field, memory);
        requireFinite(document, values, field);
        for (std::size_t i = 0; isRotation && i < values.count(); ++i) {
            const float* q = &values.values[4 * i];
            if (q[0] == 0.0f && q[1] == 0.0f && q[2] == 0.0f && q[3] == 0.0f)
                attribute.fail(" holds (0, 0, 0, 0) at element " + std::to_string(i) +
                               ", which is not a rotation");
        }
    });
    return values;
}

std::vector<glm::dmat4> readMatrices(const GltfDocument& document, const JsonField& attributes,
                                     MemoryBudget& memory) {
    const std::size_t count = countInstances(document, attributes);
    memory.take(count, sizeof(glm::dmat4), document.where(attributes.name()));
    const FloatArray translations = readAttribute(document, attributes, "TRANSLATION",
                                                  ElementType::vec3, "VEC3 floats", memory);
    const FloatArray rotations = readAttribute(document, attributes, "ROTATION", ElementType::vec4,
                                               "VEC4 floats or normalized bytes or shorts", memory);
    const FloatArray scales =
        readAttribute(document, attributes, "SCALE", ElementType::vec3, "VEC3 floats", memory);
    std::vector<glm::dmat4> matrices;
    matrices.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        NodeTransform transform;
        if (translations.components) {
            const float* t = &translations.values[3 * i];
            transform.translation = {t[0], t[1], t[2]};
        }
        if (rotations.components) { // bytes may have rounded its length
            const float* q = &rotations.values[4 * i];
            transform.rotation = glm::normalize(glm::dquat(q[3], q[0], q[1], q[2]));
        }
        if (scales.components) {
            const float* s = &scales.values[3 * i];
            transform.scale = {s[0], s[1], s[2]};
        }
        matrices.push_back(transform.matrix());
    }
    return matrices;
}

/// Calls use(extension) with the node's instancing extension, if it has one.
template <class Use>
void withExtension(const GltfDocument& document, int node, Use use) {
    const auto index = static_cast<std::size_t>(node);
    const std::string name = "nodes[" + std::to_string(node) + "]";
    const JsonField field(document.path, document.json.at("nodes").at(index), name.c_str());
    field.ifExtension("EXT_mesh_gpu_instancing", use);
}

bool hasAttributes(const JsonField& extension) {
    const auto attributes = extension.find("attributes");
    return attributes && !attributes->value().empty();
}

/// Calls use(attributes) with the attributes of a node's instances, if it has any.
template <class Use>
void withAttributes(const GltfDocument& document, int node, Use use) {
    withExtension(document, node, [&](const JsonField& extension) {
        if (hasAttributes(extension)) use(extension.member("attributes"));
    });
}

} // namespace

std::size_t instanceCount(const GltfDocument& document, int node) {
    std::size_t count = 1;
    withAttributes(document, node, [&](const JsonField& attributes) {
        count = countInstances(document, attributes);
    });
    return count;
}

void warnOfNoAttributes(const GltfDocument& document, int node, Warnings& warnings) {
    withExtension(document, node, [&](const JsonField& extension) {
        if (!hasAttributes(extension))
            warnings.add(extension.where() +
                         ".attributes is empty, so the number of instances is unknown; "
                         "the mesh is drawn once.");
    });
}

std::vector<glm::dmat4> readInstances(const GltfDocument& document, int node,
                                      MemoryBudget& memory) {
    std::vector<glm::dmat4> matrices = {glm::dmat4(1.0)};
    withAttributes(document, node, [&](const JsonField& attributes) {
        matrices = readMatrices(document, attributes, memory);
    });
    return matrices;
}

} // namespace edgeshade
