#include "preprocess/reading/scene_names.hpp"

#include "preprocess/reading/node_parts.hpp"

namespace edgeshade {
namespace {

std::string titleOf(const GltfDocument& document, const char* items, std::size_t index) {
    const JsonField root(document.path, document.json);
    const std::string name = nameOf(root.member(items).item(index));
    return name.empty() ? std::string(items) + "[" + std::to_string(index) + "]" : name;
}

} // namespace

std::string nodeTitle(const GltfDocument& document, std::size_t node) {
    return titleOf(document, "nodes", node);
}

std::string materialTitle(const GltfDocument& document, std::size_t material) {
    const JsonField root(document.path, document.json);
    if (material >= root.countOf("materials")) return "default material";
    return titleOf(document, "materials", material);
}

} // namespace edgeshade
