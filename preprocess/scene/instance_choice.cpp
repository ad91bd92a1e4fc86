#include "preprocess/scene/instance_choice.hpp"

#include "preprocess/base/names.hpp"

namespace edgeshade {
namespace {

constexpr std::size_t leastTriangles = 256;

} // namespace

const char* nameOf(InstanceChoice choice) {
    using enum InstanceChoice;
    return nameIn({{shared, "shared"}, {repeated, "repeated"}, {automatic, "auto"}}, choice);
}

bool sharingPays(InstanceChoice choice, std::size_t triangles, std::size_t places) {
    if (places < 2 || triangles == 0) return false;
    if (choice == InstanceChoice::automatic) return triangles >= leastTriangles;
    return choice == InstanceChoice::shared;
}

} // namespace edgeshade
