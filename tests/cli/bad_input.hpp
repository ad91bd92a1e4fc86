#pragma once

#include "tests/support/gltf_builder.hpp"
#include "tests/support/temp_folder.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace edgeshade::test {

/// One row of the table of bad inputs.
struct BadInput {
    /// Makes the input in the folder and returns its path.
    using Make = std::function<std::filesystem::path(const TempFolder&)>;

    std::string name; ///< an identifier, as GoogleTest wants
    Make make;
    std::vector<std::string> words; ///< what the message says beside the file's name
    std::vector<std::string> verbs = {"info", "pack", "render"};
    std::vector<std::string> options = {}; ///< of each verb
    bool warned = false; ///< not refused: drawn without what is wrong, with the message as warning
};

/// A row whose input is these bytes.
BadInput badBytes(const std::string& name, const std::function<Bytes()>& bytes,
                  const std::vector<std::string>& words);

/// A row whose input is this text, as .gltf.
BadInput badText(const std::string& name, const std::string& text,
                 const std::vector<std::string>& words);

/// A row whose input is a sound scene after `change`: a textured box, animated, of one material.
/// Node 0, mesh 0, accessors 0 POSITION, 1 NORMAL, 2 TEXCOORD_0, 3 indices, 4 times, 5
/// translations.
BadInput badScene(const std::string& name, const std::function<void(GltfBuilder&)>& change,
                  const std::vector<std::string>& words);

/// The row as one whose input is drawn like the sound scene, with a warning.
BadInput warned(BadInput row);

/// The sound scene.
GltfBuilder soundScene();

/// Its only primitive.
Json& primitiveOf(GltfBuilder& gltf);

/// The table, a part a file.
std::vector<BadInput> badContainers();
std::vector<BadInput> badJson();
std::vector<BadInput> badLimits();
std::vector<BadInput> badFiles();
std::vector<BadInput> badAccessors();
std::vector<BadInput> badNodes();
std::vector<BadInput> badAnimations();
std::vector<BadInput> badOptionalParts();
std::vector<BadInput> badImages();
std::vector<BadInput> badCompression();
std::vector<BadInput> badShadowData();

} // namespace edgeshade::test
