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

/// Chooses all items of a name; returns whether there are any.
template <class Title>
bool choose(const GltfDocument& document, const std::string& name, const Title& title,
            Chosen& chosen) {
    bool found = false;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (title(document, i) != name) continue;
        chosen[i] = 1;
        found = true;
    }
    return found;
}

[[noreturn]] void failUnknown(const GltfDocument& document, const char* option, const char* kind,
                              const std::string& name) {
    throw Error(ExitStatus::usage, std::string(option) + ": '" + document.path.string() +
                                       "' has no " + kind + " '" + name + "'.");
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
                                   const std::vector<std::string>& materials,
                                   const std::vector<std::string>& windows) {
    const auto byNames = [](const std::vector<std::string>& names, std::size_t count) {
        return Chosen(count, names.empty() ? 1 : 0);
    };
    const std::size_t nodeCount = countOf(document, "nodes");
    // The material after the last is the default material.
    const std::size_t materialCount = countOf(document, "materials") + 1;
    Chosen chosenNodes = byNames(nodes, nodeCount), windowNodes = byNames(windows, nodeCount),
           chosenMaterials = byNames(materials, materialCount),
           windowMaterials = byNames(windows, materialCount);
    for (const std::string& name : nodes)
        if (!choose(document, name, nodeTitle, chosenNodes))
            failUnknown(document, "--nodes", "node", name);
    for (const std::string& name : materials)
        if (!choose(document, name, materialTitle, chosenMaterials))
            failUnknown(document, "--materials", "material", name);
    for (const std::string& name : windows) {
        const bool ofNodes = choose(document, name, nodeTitle, windowNodes),
                   ofMaterials = choose(document, name, materialTitle, windowMaterials);
        if (!ofNodes && !ofMaterials) failUnknown(document, "--windows", "node or material", name);
    }
    if (!nodes.empty()) spread(document, chosenNodes);
    if (!windows.empty()) spread(document, windowNodes);
    return [=](std::uint32_t node, std::uint32_t material) {
        return chosenNodes.at(node) != 0 && chosenMaterials.at(material) != 0 &&
               (windowNodes.at(node) != 0 || windowMaterials.at(material) != 0);
    };
}

} // namespace edgeshade::cli
