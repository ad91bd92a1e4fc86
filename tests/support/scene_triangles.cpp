#include "tests/support/scene_triangles.hpp"

#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "tests/support/gltf_builder.hpp"

#include <algorithm>
#include <glm/gtc/matrix_inverse.hpp>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

bool near(const Corner& a, const Corner& b, double tolerance) {
    return glm::distance(a.position, b.position) <= tolerance &&
           glm::distance(glm::dvec3(a.normal), glm::dvec3(b.normal)) <= tolerance &&
           glm::distance(glm::dvec2(a.texcoord), glm::dvec2(b.texcoord)) <= tolerance;
}

bool near(const WorldTriangle& a, const WorldTriangle& b, double tolerance) {
    for (std::size_t turn = 0; turn < 3; ++turn)
        if (near(a[0], b[turn], tolerance) && near(a[1], b[(turn + 1) % 3], tolerance) &&
            near(a[2], b[(turn + 2) % 3], tolerance))
            return true;
    return false;
}

} // namespace

Scene sceneOf(const Bytes& asset) {
    return flattenScene(parseGltf(asset, "test.glb"), 0.0);
}

Scene sceneOf(const GltfBuilder& builder) {
    return sceneOf(builder.glb());
}

std::vector<WorldTriangle> worldTriangles(const Scene& scene) {
    std::vector<WorldTriangle> triangles;
    for (const Batch& batch : scene.batches) {
        const glm::dmat3 normalMatrix = glm::inverseTranspose(glm::dmat3(batch.worldFromBatch));
        for (std::size_t i = 0; i < batch.geometry->indices.size(); i += 3) {
            WorldTriangle triangle;
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t index = batch.geometry->indices[i + c];
                const glm::dvec3 normal = normalMatrix * glm::dvec3(batch.geometry->normals[index]);
                triangle[c] = {glm::dvec3(batch.worldFromBatch *
                                          glm::dvec4(batch.geometry->positions[index], 1.0)),
                               glm::vec3(glm::normalize(normal)), batch.geometry->texcoords[index]};
            }
            if (batch.isMirrored()) std::swap(triangle[1], triangle[2]);
            triangles.push_back(triangle);
        }
    }
    return triangles;
}

glm::dvec3 outside(const WorldTriangle& triangle) {
    return glm::normalize(glm::cross(triangle[1].position - triangle[0].position,
                                     triangle[2].position - triangle[0].position));
}

std::size_t warningsWith(const Scene& scene, const std::string& word) {
    const auto& sentences = scene.warnings.sentences();
    return static_cast<std::size_t>(
        std::count_if(sentences.begin(), sentences.end(), [&](const std::string& sentence) {
            return sentence.find(word) != std::string::npos;
        }));
}

void expectSameTriangles(const std::vector<WorldTriangle>& actual,
                         const std::vector<WorldTriangle>& expected, double tolerance) {
    ASSERT_EQ(actual.size(), expected.size());
    std::vector<bool> taken(expected.size(), false);
    for (std::size_t i = 0; i < actual.size(); ++i) {
        std::size_t match = 0;
        while (match < expected.size() &&
               (taken[match] || !near(actual[i], expected[match], tolerance)))
            ++match;
        if (match == expected.size()) {
            ADD_FAILURE() << "triangle " << i << " is not among those expected";
            continue;
        }
        taken[match] = true;
    }
}

} // namespace edgeshade::test
