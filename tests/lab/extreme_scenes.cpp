#include "tests/lab/extreme_scenes.hpp"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace edgeshade::test {
namespace {

constexpr float fullTurn = 6.2831853f;

/// Quads over a grid of (columns + 1) x (rows + 1) positions.
template <class At>
void addGrid(SceneBuilder& builder, int columns, int rows, At at) {
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j)
            builder.quad(at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
}

float part(int i, int count) {
    return static_cast<float>(i) / static_cast<float>(count);
}

} // namespace

LoadedScene loaded(Scene scene, bool castMasked) {
    LoadedScene result;
    result.planePairs = buildPlanePairs(scene, castMasked);
    result.shadows = buildShadows(scene, castMasked);
    result.scene = std::move(scene);
    result.settings.castMasked = castMasked;
    return result;
}

std::function<LoadedScene()> later(const std::function<SceneBuilder()>& draw, bool castMasked) {
    return [draw, castMasked] { return loaded(draw().scene(), castMasked); };
}

glm::dmat4 ordinaryPlace() {
    return glm::rotate(glm::translate(glm::dmat4(1.0), {-0.353, 0.192, -0.314}), 0.2718,
                       glm::normalize(glm::dvec3(-0.15, 0.94, -0.31)));
}

LoadedScene turnedYard() {
    Scene scene = yard().scene();
    for (glm::vec3& position : scene.batches.front().geometry.edit().positions)
        position = glm::vec3(glm::dvec3(ordinaryPlace() * glm::dvec4(glm::dvec3(position), 1.0)));
    return loaded(std::move(scene));
}

SceneBuilder sliver(float aspect) {
    // One sliver alone, and one in the seam of a sheet, where a crack would show.
    const glm::vec3 a(-1, 1.2f, 1), b(1, 1.5f, -1), c(1, 1.5f, -1 + 2.8f / aspect);
    return SceneBuilder()
        .floor(6)
        .triangle({-2, 1, 0}, {2, 1, 0.2f}, {2, 1 + 4 / aspect, 0.2f})
        .triangle(a, b, {-1, 1.3f, -1})
        .triangle(a, c, b)
        .triangle(a, {1, 1.4f, 1}, c);
}

SceneBuilder fan(int n) {
    SceneBuilder builder = SceneBuilder().floor(6);
    for (int i = 0; i < n; ++i) {
        const float angle = 0.05f + 6.2f * part(i, n);
        builder.triangle({0, 0.5f, 0}, {0, 2, 0},
                         {1.5f * std::cos(angle), 1, 1.5f * std::sin(angle)});
    }
    return builder;
}

SceneBuilder duplicated(bool opposite) {
    SceneBuilder builder = SceneBuilder().floor(6);
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 a(-1, 1, 0), b(1, 1.3f, 0.4f), c(0, 2, -1);
        if (opposite && i == 1)
            builder.triangle(c, b, a);
        else
            builder.triangle(a, b, c);
    }
    return builder;
}

SceneBuilder boxWithDegenerateTriangles() {
    const glm::vec3 a(-1, 0.5f, 1), b(1, 0.5f, 1), c(1, 2, 1);
    return SceneBuilder()
        .floor(6)
        .box({-1, 0.5f, -1}, c)
        .triangle(c, c, c)                                // a point
        .triangle(b, c, b)                                // an edge, there and back
        .triangle(a, {0, 0.5f, 1}, b)                     // a new vertex on an edge
        .triangle(b, {1, 1, 1}, c)                        // another
        .triangle(a, {0, 1.25f, 1}, c)                    // on a face's diagonal
        .triangle({-1, 2, -1}, {-1, 2, 0.5f}, {-1, 2, 1}) // vertices and triangle all on one edge
        .triangle({2, 1, 0}, {2, 2, 0}, {2, 3, 0});       // alone in the air
}

SceneBuilder tJunction() {
    return SceneBuilder()
        .floor(6)
        .quad({-1, 1, 1}, {1, 1, 1}, {1, 1, 0}, {-1, 1, 0})
        .quad({-1, 1, 0}, {0, 1, 0}, {0, 1, -1}, {-1, 1, -1})
        .quad({0, 1, 0}, {1, 1, 0}, {1, 1, -1}, {0, 1, -1});
}

SceneBuilder moebiusStrip() {
    SceneBuilder builder = SceneBuilder().floor(6);
    constexpr int segments = 24;
    const auto at = [](int i, int j) {
        const bool closes = i == segments;
        const float side = (j == 0) == closes ? 1.0f : -1.0f;
        const float turn = fullTurn * part(closes ? 0 : i, segments);
        const float r = 1.5f + 0.4f * side * std::cos(0.5f * turn);
        return glm::vec3(r * std::cos(turn), 1.5f + 0.4f * side * std::sin(0.5f * turn),
                         r * std::sin(turn));
    };
    addGrid(builder, segments, 1, at);
    return builder;
}

SceneBuilder kleinBottle() {
    SceneBuilder builder = SceneBuilder().floor(6);
    constexpr int segments = 32, ring = 18;
    const auto at = [](int i, int j) {
        // After one turn the ring comes back mirrored.
        const bool closes = i == segments;
        const int onRing = closes ? (ring - j) % ring : j % ring;
        const float turn = fullTurn * part(closes ? 0 : i, segments);
        const float around = fullTurn * part(onRing, ring);
        const float c = std::cos(0.5f * turn), s = std::sin(0.5f * turn);
        const float r = 1.4f + 0.6f * (c * std::sin(around) - s * std::sin(2 * around));
        return glm::vec3(r * std::cos(turn),
                         1.3f + 0.6f * (s * std::sin(around) + c * std::sin(2 * around)),
                         r * std::sin(turn));
    };
    addGrid(builder, segments, ring, at);
    return builder;
}

SceneBuilder hemisphere() {
    SceneBuilder builder = SceneBuilder().floor(6);
    const auto at = [](int i, int j) {
        const float a = fullTurn * part(i % 16, 16), b = 0.26f * static_cast<float>(j);
        return glm::vec3(1.5f * std::cos(a) * std::cos(b), 0.5f + 1.5f * std::sin(b),
                         1.5f * std::sin(a) * std::cos(b));
    };
    addGrid(builder, 16, 6, at);
    return builder;
}

SceneBuilder stack(int count) {
    SceneBuilder builder = SceneBuilder().floor(6);
    for (int i = 0; i < count; ++i) {
        const float y = 1.0f + 1.5f * part(i, count);
        builder.quad({-1, y, 1}, {1, y, 1}, {1, y, -1}, {-1, y, -1});
    }
    return builder;
}

SceneBuilder tinyYard() {
    constexpr float mm = 1e-3f;
    return SceneBuilder()
        .floor(5)
        .box({-2 * mm, 0.5f * mm, -mm}, {-mm, 2 * mm, 0})
        .box({0.5f * mm, 0.25f * mm, 0.5f * mm}, {1.5f * mm, mm, 2 * mm})
        .quad({-0.5f * mm, mm, 0}, {0.5f * mm, 1.2f * mm, 0}, {0.4f * mm, 2 * mm, 0.3f * mm},
              {-0.5f * mm, 2 * mm, 0.1f * mm});
}

SceneBuilder yardBehindADot() {
    return yard().triangle({4.9990f, 3.9993f, 5.9991f}, {4.9992f, 3.9993f, 5.9990f},
                           {4.9991f, 3.9996f, 5.9990f});
}

LoadedScene hills(std::uint32_t cells) {
    const auto rough = [](float x, float z) {
        return 0.4f * std::sin(1.7f * x) * std::cos(1.3f * z) + 0.2f * std::sin(3.1f * z + x);
    };
    Scene scene;
    scene.materials.emplace_back();
    Batch& batch = scene.batches.emplace_back();
    const std::uint32_t side = cells + 1;
    for (std::uint32_t i = 0; i < side * side; ++i) {
        const float step = 10.0f / static_cast<float>(cells);
        const float x = -5.0f + step * static_cast<float>(i % side);
        const float z = -5.0f + step * static_cast<float>(i / side);
        batch.geometry.edit().positions.emplace_back(x, rough(x, z), z);
        constexpr float h = 0.01f;
        batch.geometry.edit().normals.push_back(glm::normalize(glm::vec3(
            rough(x - h, z) - rough(x + h, z), 2.0f * h, rough(x, z - h) - rough(x, z + h))));
    }
    batch.geometry.edit().texcoords.assign(side * side, glm::vec2(0.0f));
    batch.geometry.edit().colors.assign(side * side, glm::vec4(1.0f));
    for (std::uint32_t z = 0; z < cells; ++z)
        for (std::uint32_t x = 0; x < cells; ++x) {
            const std::uint32_t a = z * side + x, b = a + side;
            batch.geometry.edit().indices.insert(batch.geometry->indices.end(),
                                                 {a, b, a + 1, a + 1, b, b + 1});
        }
    batch.geometry.edit().groups.push_back(
        {0, 0, static_cast<std::uint32_t>(batch.geometry->indices.size())});
    return loaded(std::move(scene));
}

} // namespace edgeshade::test
