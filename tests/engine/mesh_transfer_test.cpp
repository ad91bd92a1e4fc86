#include "web/masks/mesh_transfer.hpp"

#include "src/engine/merged_meshes.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

namespace edgeshade::test {
namespace {

/// `count` small upright triangles in a row.
PreparedMesh meadow(std::size_t count) {
    std::vector<float> positions;
    for (std::size_t i = 0; i < count; ++i) {
        const auto x = static_cast<float>(i);
        positions.insert(positions.end(), {x, 0.0f, 0.0f, x + 0.5f, 0.0f, 0.1f, x, 1.0f, 0.2f});
    }
    std::vector<std::uint32_t> indices(3 * count);
    std::iota(indices.begin(), indices.end(), 0u);
    return PreparedMesh(MaskMesh{.positions = positions, .indices = indices});
}

std::span<const std::uint8_t> headOf(const Bytes& bytes) {
    std::uint32_t size = 0;
    std::memcpy(&size, bytes.data(), sizeof size);
    return std::span(bytes).subspan(sizeof size, size);
}

/// Copies what follows the head, as a page does. Returns how many arrays that filled.
std::size_t fill(const Bytes& bytes, std::span<const web::VectorApart> arrays) {
    std::size_t from = sizeof(std::uint32_t) + headOf(bytes).size();
    for (const web::VectorApart& array : arrays) {
        const std::span<std::uint8_t> to = array.bytes();
        std::memcpy(to.data(), bytes.data() + from, to.size());
        from += to.size();
    }
    EXPECT_EQ(from, bytes.size());
    return arrays.size();
}

} // namespace

TEST(MeshTransfer, RestoresAMeshWhoseLargeArraysLieApart) {
    for (const std::size_t triangles : {std::size_t{3}, std::size_t{20000}}) {
        const Bytes bytes = web::toTransfer(meadow(triangles));
        const web::Outlined<PreparedMesh> taken = web::meshOfHead(headOf(bytes));
        const PreparedMesh::Data& data = *taken.mesh.data();
        const std::size_t apart = fill(bytes, taken.arrays);
        EXPECT_FALSE(data.shadow->caps.empty());
        EXPECT_EQ(web::toTransfer(taken.mesh), bytes);
        if (triangles == 3) {
            EXPECT_EQ(apart, 0u) << "nothing of it is large";
        } else {
            EXPECT_GT(apart, 5u);
            EXPECT_LT(headOf(bytes).size(), bytes.size() / 10);
        }
    }
}

TEST(MeshTransfer, RestoresMergedMeshes) {
    std::vector<MergedMeshes::Member> members;
    Matrix16 place = identity16;
    for (int i = 0; i < 40; ++i) {
        place[14] = i;
        members.push_back({meadow(900), place});
    }
    const std::vector<MergedMeshes> made = MergedMeshes::of(members);
    ASSERT_FALSE(made.empty());
    const Bytes bytes = web::toTransfer(made[0]);
    const web::Outlined<MergedMesh> taken = web::mergedOfHead(headOf(bytes));
    EXPECT_GT(fill(bytes, taken.arrays), 3u);
    const MergedMesh& merged = made[0].data()->merged;
    EXPECT_EQ(taken.mesh.worldFromMerged, merged.worldFromMerged);
    EXPECT_EQ(web::toTransfer(taken.mesh.mesh), web::toTransfer(merged.mesh));
}

} // namespace edgeshade::test
