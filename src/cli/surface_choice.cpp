#include "src/cli/surface_choice.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/reading/scene_names.hpp"

#include <algorithm>

namespace edgeshade::cli {
namespace {

using Chosen = std::vector<std::uint8_t>; ///< by index in the file

std::size_t countOf(const GltfDocument& document, const char* items) {
    const auto found = document.json.find(items);
    return found == document.json.end() ? 0 : found->size();
}

template <class Title>
Chosen chosenBy(const std::vector<std::string>& names, std::size_t count, const Title& title,
                const GltfDocument& document, const char* option, const char* kind) {
    Chosen chosen(count, names.empty() ? 1 : 0);
    for (const std::string& name : names) {
        bool found = false;
        for (std::size_t i = 0; i < count; ++i) {
            if (title(document, i) != name) continue;
            chosen[i] = 1;
            found = true;
        }
        if (!found)
            throw Error(ExitStatus::usage, std::string(option) + ": '" + document.path.string() +
                                               "' has no " + kind + " '" + name + "'.");
    }
    return chosen;
}

/// Chooses all nodes beneath chosen ones. Reading has checked that nodes form trees.
void spread(const GltfDocument& document, Chosen& chosen) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i] != 0) open.push_back(i);
    while (!open.empty()) {
        const auto& node = document.json["nodes"][open.back()];
        open.pop_back();
        if (!node.contains("children")) continue;
        for (const auto& child : node["children"]) {
            const auto index = child.get<std::size_t>();
            if (chosen[index] != 0) continue;
            chosen[index] = 1;
            open.push_back(index);
        }
    }
}

} // namespace

hours::SurfaceChoice surfaceChoice(const GltfDocument& document,
                                   const std::vector<std::string>& nodes,
                                   const std::vector<std::string>& materials) {
    Chosen chosenNodes =
        chosenBy(nodes, countOf(document, "nodes"), nodeTitle, document, "--nodes", "node");
    if (!nodes.empty()) spread(document, chosenNodes);
    // The material after the last is the default material.
    Chosen chosenMaterials = chosenBy(materials, countOf(document, "materials") + 1, materialTitle,
                                      document, "--materials", "material");
    return [chosenNodes = std::move(chosenNodes), chosenMaterials = std::move(chosenMaterials)](
               std::uint32_t node, std::uint32_t material) {
        return chosenNodes.at(node) != 0 && chosenMaterials.at(material) != 0;
    };
}

} // namespace edgeshade::cli
