#include "preprocess/scene/instance_choice.hpp"

namespace edgeshade {
namespace {

constexpr std::size_t leastTriangles = 256;

} // namespace

const char* nameOf(InstanceChoice choice) {
    switch (choice) {
    case InstanceChoice::shared:
        return "shared";
    case InstanceChoice::repeated:
        return "repeated";
    default:
        return "auto";
    }
}

bool sharingPays(InstanceChoice choice, std::size_t triangles, std::size_t places) {
    if (places < 2 || triangles == 0) return false;
    if (choice == InstanceChoice::automatic) return triangles >= leastTriangles;
    return choice == InstanceChoice::shared;
}

} // namespace edgeshade
