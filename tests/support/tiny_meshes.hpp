#pragma once

// Meshes small enough to know completely. Coordinates are small integers, so that every sign is
// computed exactly and a light can lie in a plane.

#include "preprocess/mesh/edges.hpp"
#include "preprocess/mesh/weld.hpp"
#include "preprocess/volumes/published/sides_data.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade::test {

/// Triangles as in a file, before welding.
struct Soup {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices; ///< three a triangle
};

/// A soup after all stages: weld, edges, sides.
struct Built {
    WeldedMesh mesh;
    EdgeList edges;
    SidesData sides;
};

inline Built build(const Soup& soup) {
    Built built;
    built.mesh = weld(soup.positions, soup.indices);
    built.edges = buildEdges(built.mesh);
    built.sides = buildSides(built.mesh.positions, built.edges,
                             recordMultiplicityFor(built.edges.largestOppositeCount()));
    return built;
}

//      6-------7
//     /|      /|      z
//    4-------5 |      | y
//    | 2-----|-3      |/
//    |/      |/       +--x
//    0-------1
//
/// The unit cube with one corner at the origin, wound outwards; two triangles per face.
inline Soup cube() {
    return {
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
        {0, 3, 1, 0, 2, 3,   // bottom, z = 0
         0, 1, 5, 0, 5, 4,   // y = 0
         1, 3, 7, 1, 7, 5,   // x = 1
         3, 2, 6, 3, 6, 7,   // y = 1
         2, 0, 4, 2, 4, 6,   // x = 0
         4, 5, 7, 4, 7, 6}}; // top, z = 1
}

/// The cube without its top.
inline Soup openBox() {
    Soup box = cube();
    box.indices.resize(box.indices.size() - 6);
    return box;
}

//          B                 seen from above:     F
//         /|\                                     |
//        / | \                                P---A---Q
//       P--A--Q
//
/// Three pages on one spine A-B: P to the left, Q to the right, F to the back.
inline Soup fin() {
    return {{{0, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, // A B P Q F
            {0, 1, 2, 0, 1, 3, 0, 1, 4}};
}

//    seen from above:   / .
//                      /.         the opposite vertices (1, k, 0), k = 0, 1, ...
//                     A----
//
/// `pages` triangles on one spine from (0, 0, 0) to (0, 0, 1).
inline Soup fan(std::uint32_t pages) {
    Soup fan{{{0, 0, 0}, {0, 0, 1}}, {}};
    for (std::uint32_t k = 0; k < pages; ++k) {
        fan.positions.emplace_back(1.0f, static_cast<float>(k), 0.0f);
        fan.indices.insert(fan.indices.end(), {0, 1, k + 2});
    }
    return fan;
}

//    from above:   1---3         triangles (i, i+1, i+2) modulo 5: the strip 012, 123, 234
//                 / \ / \        closes with 340 and 401, half a turn later
//                0---2---4
//
/// The Moebius strip of five vertices and five triangles: it has a boundary, one side, and no
/// consistent orientation.
inline Soup moebiusStrip() {
    return {{{0, 0, 0}, {1, 2, 1}, {2, 0, 2}, {3, 2, 3}, {4, 0, 5}},
            {0, 1, 2, 1, 2, 3, 2, 3, 4, 3, 4, 0, 4, 0, 1}};
}

//          E
//         /|\         D, M and E stand above one another. The large triangle below knows nothing
//        / | \        of M, which lies on its edge A-C.
//       A--M--C
//        \   /
//          D
//
/// A T-junction: A-C is one edge below and two above.
inline Soup tJunction() {
    return {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, -1, 0}, {1, 1, 0}}, // A M C D E
            {0, 3, 2, 0, 1, 4, 1, 2, 4}};
}

} // namespace edgeshade::test
