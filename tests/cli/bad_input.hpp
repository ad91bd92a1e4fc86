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

    std::string name; ///< an identifier, as GoogleTest requires
    Make make;
    std::vector<std::string> words; ///< words of the message, besides the file's name
    std::vector<std::string> verbs = {"info", "pack", "render"};
    std::vector<std::string> options = {}; ///< for each verb
    bool warned = false; ///< not refused: drawn without the faulty part, with the message as a
                         ///< warning
};

/// A row with these bytes as input.
BadInput badBytes(const std::string& name, const std::function<Bytes()>& bytes,
                  const std::vector<std::string>& words);

/// A row with this text as input, as .gltf.
BadInput badText(const std::string& name, const std::string& text,
                 const std::vector<std::string>& words);

/// A row with a sound scene after `change` as input: a textured, animated box of one material. Node
/// 0, mesh 0, accessors 0 POSITION, 1 NORMAL, 2 TEXCOORD_0, 3 indices, 4 times, 5 translations.
BadInput badScene(const std::string& name, const std::function<void(GltfBuilder&)>& change,
                  const std::vector<std::string>& words);

/// The same row, for an input that is drawn like the sound scene, with a warning.
BadInput warned(BadInput row);

/// The sound scene.
GltfBuilder soundScene();

/// The sound scene's only primitive.
Json& primitiveOf(GltfBuilder& gltf);

/// The table, one part per file.
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
std::vector<BadInput> badCities();

} // namespace edgeshade::test
