#pragma once

// Paths of the models beside the repository, if they exist.

#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/flatten.hpp"

#include <filesystem>
#include <string>

namespace edgeshade::test {

inline std::filesystem::path sharedScenePath(const std::string& name) {
    return std::filesystem::path(EDGESHADE_SHARED_SCENES) / (name + ".glb");
}

inline Scene readSharedScene(const std::string& name,
                             InstanceChoice instances = InstanceChoice::automatic) {
    return flattenScene(readGltf(sharedScenePath(name)), 0.0, {}, instances);
}

/// Skips the running test if the scene doesn't exist.
#define SKIP_WITHOUT_SHARED_SCENE(name)                                                            \
    if (!std::filesystem::exists(sharedScenePath(name)))                                           \
    GTEST_SKIP() << "no scene '" << sharedScenePath(name).string() << "' on this machine"

} // namespace edgeshade::test
