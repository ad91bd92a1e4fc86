#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade::test {

/// A small triangle mesh to build scenes from.
struct Shape {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> texcoords;
    std::vector<std::uint32_t> indices; ///< three per triangle, counter-clockwise from outside
};

/// The box from -half to half: 24 vertices with normals and texture coordinates, 12 triangles.
Shape box(const glm::vec3& half);

/// The tetrahedron (0,0,0) (1,0,0) (0,1,0) (0,0,1): 4 vertices, positions only.
Shape tetrahedron();

/// `count` triangles around the edge (0,0,0)-(0,1,0), like the pages of an open book.
Shape book(int count);

/// The zigzag of a triangle strip in the plane z = 0, positions only, no indices:
///
///   1---3---5
///   |\  |\  |
///   | \ | \ |
///   |  \|  \|
///   0---2---4
std::vector<glm::vec3> zigzag();

} // namespace edgeshade::test
