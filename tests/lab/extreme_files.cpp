// Extremes that need a glTF file: distant nodes, textures.
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "src/image/png.hpp"
#include "tests/lab/extreme_scenes.hpp"
#include "tests/support/gltf_builder.hpp"

namespace edgeshade::test {
namespace {

LoadedScene read(const GltfBuilder& gltf, bool castMasked) {
    GltfDocument document = parseGltf(gltf.glb(), "extreme.glb");
    LoadedScene result = loaded(flattenScene(document, 0.0), castMasked);
    result.document = std::make_shared<const GltfDocument>(std::move(document));
    return result;
}

Json at(const glm::dvec3& place) {
    return {place.x, place.y, place.z};
}

/// 8 x 8 clear texels except for two upright stripes. Borders are straight and the outline is
/// clear, so that a linear filter cuts at the same place as the nearest texel.
Bytes stripes() {
    Bytes texels;
    for (int i = 0; i < 64; ++i) {
        const std::uint8_t alpha = (i + 1) % 4 < 2 ? 0 : 255;
        texels.insert(texels.end(), {120, 200, 90, alpha});
    }
    return encodePng(texels, 8, 8);
}

/// A leaning square card of 2 x 2 across the y axis, on its edge, rotated by `turn`.
Shape card(float turn) {
    Shape shape;
    const glm::vec3 along(std::cos(turn), 0, std::sin(turn));
    const glm::vec3 up(0.3f * std::sin(turn), 1, -0.3f * std::cos(turn));
    for (const glm::vec2 corner :
         {glm::vec2(-1, 0), glm::vec2(1, 0), glm::vec2(1, 2), glm::vec2(-1, 2)}) {
        shape.positions.push_back(corner.x * along + corner.y * up + glm::vec3(0, 0.3f, 0));
        shape.normals.push_back(glm::normalize(glm::cross(along, up)));
        shape.texcoords.push_back(0.5f * (corner + glm::vec2(1, 0)));
    }
    shape.indices = {0, 1, 2, 0, 2, 3};
    return shape;
}

} // namespace

LoadedScene tinyBoxesAt(const glm::dvec3& place) {
    GltfBuilder gltf;
    const auto add = [&](const glm::vec3& half, const glm::dvec3& middle) {
        gltf.addNode({{"mesh", gltf.addShape(box(half))}, {"translation", at(place + middle)}});
    };
    constexpr float mm = 1e-3f;
    add({5, 1, 5}, {0, -1, 0});
    add({0.5f * mm, 0.75f * mm, 0.5f * mm}, {-1.5e-3, 1.25e-3, -0.5e-3});
    add({0.5f * mm, 0.4f * mm, 0.75f * mm}, {1e-3, 0.6e-3, 1.25e-3});
    add({0.5f * mm, 0.01f * mm, 0.4f * mm}, {0.1e-3, 2e-3, 0.2e-3});
    return read(gltf, false);
}

LoadedScene leavesByTexture() {
    GltfBuilder gltf;
    gltf.addMaterial({{"name", "floor"}});
    gltf.addMaterial({{"alphaMode", "MASK"},
                      {"doubleSided", true},
                      {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    gltf.addImage({{"bufferView", gltf.addView(stripes())}, {"mimeType", "image/png"}});
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.addNode({{"mesh", gltf.addShape(box({5, 0.5f, 5}), {{"material", 0}})},
                  {"translation", at({0, -0.5, 0})}});
    for (const float turn : {0.2f, 1.3f, 2.4f})
        gltf.addShapeNode(card(turn), {{"material", 1}});
    return read(gltf, true);
}

LoadedScene leavesByVertexAlpha() {
    Material leaf;
    leaf.alphaMode = AlphaMode::mask;
    SceneBuilder builder = SceneBuilder().floor(5).material(leaf);
    for (const float turn : {0.2f, 1.3f, 2.4f}) {
        const auto corners = card(turn).positions;
        builder.quad(corners[0], corners[1], corners[2], corners[3]);
    }
    Scene scene = builder.scene();
    Batch& batch = scene.batches.front();
    for (std::uint32_t i = scene.batches.front().geometry->groups.back().firstIndex;
         i < batch.geometry->colors.size(); ++i)
        batch.geometry.edit().colors[i].a =
            batch.geometry->positions[i].y < 1.0f ? 1.0f : 0.0f; // holes in the upper half
    return loaded(std::move(scene), true);
}

} // namespace edgeshade::test
