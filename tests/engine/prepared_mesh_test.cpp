// Meshes of hosts, as they are prepared.
#include "src/engine/prepared_mesh.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace edgeshade {
namespace {

/// A torus whose rings end beside where they begin, by sines and cosines of a whole turn in
/// doubles, as three.js makes it: `along` rings of `around` quads.
struct Torus {
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;

    Torus(unsigned along, unsigned around, double scale, double turn = 2.0 * std::numbers::pi) {
        for (unsigned j = 0; j <= around; ++j)
            for (unsigned i = 0; i <= along; ++i) {
                const double u = turn * i / along, v = turn * j / around;
                const double out = scale * (1.0 + 0.25 * std::cos(v));
                for (const double x :
                     {out * std::cos(u), out * std::sin(u), scale * 0.25 * std::sin(v)})
                    positions.push_back(static_cast<float>(x));
            }
        const auto at = [&](unsigned j, unsigned i) { return j * (along + 1) + i; };
        for (unsigned j = 0; j < around; ++j)
            for (unsigned i = 0; i < along; ++i)
                for (const std::uint32_t index : {at(j, i), at(j, i + 1), at(j + 1, i),
                                                  at(j + 1, i), at(j, i + 1), at(j + 1, i + 1)})
                    indices.push_back(index);
    }
    std::size_t openEdges() const {
        MaskMesh mesh;
        mesh.positions = positions;
        mesh.indices = indices;
        return PreparedMesh(mesh).data()->shadow->singles.size();
    }
};

TEST(PreparedMesh, SeamsOfAWholeTurnAreClosed) {
    for (const double scale : {1e-30, 1e-3, 1.0, 12345.6, 1e30})
        EXPECT_EQ(Torus(12, 8, scale).openEdges(), 0u) << scale;
}

TEST(PreparedMesh, GapsThatFloatsOfThatSizeCanShowStayOpen) {
    EXPECT_GT(Torus(12, 8, 1.0, 2.0 * std::numbers::pi - 1e-14).openEdges(), 0u);
}

} // namespace
} // namespace edgeshade
