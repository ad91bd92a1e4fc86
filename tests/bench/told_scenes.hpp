#pragma once

#include "preprocess/base/box.hpp"

#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

namespace edgeshade {

/// A light above a scene and to its side, like bench's light.
inline glm::dvec3 besideAndAbove(const Box& bounds) {
    return bounds.center() + glm::dvec3(0.3, 0.6, 0.2) * bounds.diagonal();
}

/// Prints a JSON array of measured(path) for each of a program's arguments; returns the exit
/// status.
inline int tellOfScenes(int count, char** words,
                        nlohmann::ordered_json (*measured)(const std::string& path)) {
    auto scenes = nlohmann::ordered_json::array();
    for (int i = 1; i < count; ++i)
        scenes.push_back(measured(words[i]));
    std::cout << scenes.dump(1) << "\n";
    return 0;
}

} // namespace edgeshade
