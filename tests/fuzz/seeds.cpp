#include "tests/fuzz/seeds.hpp"

#include "src/image/png.hpp"
#include "tests/support/draco_encoding.hpp"
#include "tests/support/meshopt_encoding.hpp"
#include "tests/support/moving_scenes.hpp"
#include "tests/support/packing.hpp"
#include "tests/support/webp_encoding.hpp"

#include <meshoptimizer.h>
#include <stb_image_write.h>

namespace edgeshade::test {
namespace {

const glm::vec3 one(1.0f);

Bytes bytesOfText(const std::string& text) {
    return {text.begin(), text.end()};
}

/// A textured, animated box below another node, with a sampler and a texture transform.
GltfBuilder texturedScene() {
    GltfBuilder gltf;
    gltf.addImage({{"bufferView", gltf.addView(smallPng())}, {"mimeType", "image/png"}});
    gltf.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}}};
    gltf.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    gltf.addMaterial({{"alphaMode", "MASK"},
                      {"alphaCutoff", 0.25},
                      {"pbrMetallicRoughness",
                       {{"baseColorFactor", {1, 0.5, 0.25, 1}},
                        {"baseColorTexture",
                         {{"index", 0},
                          {"extensions",
                           {{"KHR_texture_transform",
                             {{"offset", {0.5, 0}}, {"rotation", 1}, {"scale", {2, 2}}}}}}}}}}});
    const int node = gltf.addNode(
        {{"mesh", gltf.addShape(box(one), {{"material", 0}})}, {"rotation", {0, 0, 0, 1}}}, false);
    gltf.addNode({{"children", Json::array({node})}, {"translation", {1e6, 0, 3}}});
    gltf.animate(node, "rotation");
    return gltf;
}

/// A strip and a fan without normals, with colours, byte indices, and points.
GltfBuilder modesScene() {
    GltfBuilder gltf;
    const int positions = gltf.addVectors(zigzag());
    const int colors = gltf.addArray(std::vector<std::uint8_t>(24, 200), 4, {{"normalized", true}});
    Json primitives = Json::array();
    for (const int mode : {0, 4, 5, 6})
        primitives.push_back({{"attributes", {{"POSITION", positions}, {"COLOR_0", colors}}},
                              {"indices", gltf.addIndices<std::uint8_t>({0, 1, 2, 3, 4, 5})},
                              {"mode", mode}});
    const int mesh = gltf.addMesh(primitives);
    gltf.addNode({{"mesh", mesh}});
    gltf.addNode({{"mesh", mesh}, {"matrix", {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1}}});
    return gltf;
}

/// Sparse positions, all others of which are zero, and quantised ones.
GltfBuilder sparseScene() {
    GltfBuilder gltf;
    const int elements = gltf.addView(bytesOf(std::vector<std::uint16_t>{0, 2, 3}));
    const int values = gltf.addView(bytesOf(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1}));
    const int sparse =
        gltf.addAccessor(-1, componentTypeOf<float>, 4, "VEC3",
                         {{"sparse",
                           {{"count", 3},
                            {"indices", {{"bufferView", elements}, {"componentType", 5123}}},
                            {"values", {{"bufferView", values}}}}}});
    const int indices = gltf.addIndices<std::uint32_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
    gltf.addNode(
        {{"mesh", gltf.addMesh({{"attributes", {{"POSITION", sparse}}}, {"indices", indices}})}});
    const int quantised =
        gltf.addArray(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 0, 32767, 0, 0, 0, -32768}, 3,
                      {{"normalized", true}});
    gltf.useExtension("KHR_mesh_quantization");
    gltf.addNode(
        {{"mesh", gltf.addMesh({{"attributes", {{"POSITION", quantised}}}, {"indices", indices}})},
         {"scale", {2, 3, -4}}});
    return gltf;
}

/// A skinned tetrahedron with a morph target.
GltfBuilder skinnedScene() {
    GltfBuilder gltf;
    const int joint = gltf.addNode({{"translation", {0, 3, 0}}});
    std::vector<float> bind(16, 0.0f);
    bind[0] = bind[5] = bind[10] = bind[15] = 1.0f;
    gltf.json["skins"] = {
        {{"joints", Json::array({joint})}, {"inverseBindMatrices", gltf.addArray(bind, 16)}}};
    Json primitive = gltf.primitiveOf(tetrahedron());
    primitive["attributes"]["JOINTS_0"] = gltf.addArray(std::vector<std::uint8_t>(16, 0), 4);
    primitive["attributes"]["WEIGHTS_0"] = gltf.addArray(std::vector<float>(16, 0.25f), 4);
    primitive["targets"] = {{{"POSITION", gltf.addVectors(std::vector<glm::vec3>(4, one))}}};
    const int mesh = gltf.addMesh(primitive);
    gltf.json["meshes"][mesh]["weights"] = {0.5};
    gltf.addNode({{"mesh", mesh}, {"skin", 0}});
    return gltf;
}

GltfBuilder dracoScene(const Shape& shape) {
    GltfBuilder gltf;
    gltf.useExtension(dracoExtension);
    gltf.addNode({{"mesh", gltf.addMesh(dracoPrimitive(gltf, shape))}});
    return gltf;
}

/// Many boxes in one shape, so that connectivity has splits and several components.
Shape boxes(int count) {
    Shape all;
    for (int i = 0; i < count; ++i) {
        const Shape single = box(glm::vec3(0.3f + 0.1f * static_cast<float>(i)));
        const auto base = static_cast<std::uint32_t>(all.positions.size());
        for (const glm::vec3& position : single.positions)
            all.positions.push_back(position + glm::vec3(static_cast<float>(i)));
        all.normals.insert(all.normals.end(), single.normals.begin(), single.normals.end());
        all.texcoords.insert(all.texcoords.end(), single.texcoords.begin(), single.texcoords.end());
        for (const std::uint32_t index : single.indices)
            all.indices.push_back(base + index);
    }
    return all;
}

/// The box compressed by meshopt, with filtered positions or normals.
GltfBuilder filteredScene(const std::string& filter) {
    const Shape shape = box(one);
    const std::size_t count = shape.positions.size();
    GltfBuilder gltf = meshoptScene(shape);
    Json& attributes = gltf.json["meshes"][0]["primitives"][0]["attributes"];
    if (filter == "EXPONENTIAL") {
        Bytes filtered(12 * count);
        meshopt_encodeFilterExp(filtered.data(), count, 12, 15, &shape.positions[0].x);
        attributes["POSITION"] = gltf.addAccessor(addMeshoptVertices(gltf, filtered, 12, filter),
                                                  componentTypeOf<float>, count, "VEC3");
        return gltf;
    }
    std::vector<float> source;
    for (const glm::vec3& normal : shape.normals)
        source.insert(source.end(), {normal.x, normal.y, normal.z, 0.0f});
    const bool isOctahedral = filter == "OCTAHEDRAL";
    const std::size_t stride = isOctahedral ? 4 : 8;
    Bytes filtered(stride * count);
    if (isOctahedral)
        meshopt_encodeFilterOct(filtered.data(), count, stride, 8, source.data());
    else
        meshopt_encodeFilterQuat(filtered.data(), count, stride, 12, source.data());
    attributes["NORMAL"] = gltf.addAccessor(addMeshoptVertices(gltf, filtered, stride, filter),
                                            isOctahedral ? componentTypeOf<std::int8_t>
                                                         : componentTypeOf<std::int16_t>,
                                            count, "VEC3", {{"normalized", true}});
    return gltf;
}

GltfBuilder indexSequenceScene() {
    GltfBuilder gltf;
    const int indices = gltf.addAccessor(addMeshoptIndices(gltf, {0, 1, 2, 3, 4, 5}),
                                         componentTypeOf<std::uint16_t>, 6, "SCALAR");
    gltf.addShapeNode({zigzag(), {}, {}, {}}, {{"mode", 5}, {"indices", indices}});
    return gltf;
}

std::vector<std::uint8_t> gradient(int width, int height, int channels) {
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < width * height * channels; ++i)
        pixels.push_back(static_cast<std::uint8_t>(i * 7));
    return pixels;
}

void append(void* to, void* data, int size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    static_cast<Bytes*>(to)->insert(static_cast<Bytes*>(to)->end(), bytes, bytes + size);
}

} // namespace

Seeds gltfSeeds() {
    GltfBuilder plain;
    plain.addShapeNode(tetrahedron());
    return {
        {"tetrahedron.glb", plain.glb()},        {"tetrahedron.gltf", bytesOfText(plain.gltf())},
        {"textured.glb", texturedScene().glb()}, {"modes.glb", modesScene().glb()},
        {"sparse.glb", sparseScene().glb()},     {"skinned.glb", skinnedScene().glb()},
        {"varied.glb", variedScene().glb()},     {"figure.glb", walkingFigure(3, 2).glb()},
        {"ball.glb", morphingBall(3, 2).glb()}};
}

Seeds compressionSeeds() {
    Shape noTexcoords = box(one);
    noTexcoords.texcoords.clear();
    return {{"draco.glb", dracoScene(box(one)).glb()},
            {"draco_boxes.glb", dracoScene(boxes(4)).glb()},
            {"meshopt.glb", meshoptScene(noTexcoords).glb()},
            {"octahedral.glb", filteredScene("OCTAHEDRAL").glb()},
            {"quaternion.glb", filteredScene("QUATERNION").glb()},
            {"exponential.glb", filteredScene("EXPONENTIAL").glb()},
            {"indices.glb", indexSequenceScene().glb()}};
}

Seeds shadowSeeds() {
    GltfBuilder plain;
    plain.addShapeNode(tetrahedron());
    Seeds seeds;
    for (const Encoding encoding : everyEncoding) {
        const std::string name = nameOf(encoding);
        seeds.emplace_back(name + ".glb", packed(plain.glb(), encoding));
        seeds.emplace_back("varied_" + name + ".glb", packed(variedScene().glb(), encoding));
    }
    CasterSettings coarse;
    coarse.weldTolerance = 0.01;
    coarse.casterError = 0.1;
    coarse.flatTolerance = 5.0;
    coarse.castMasked = true;
    seeds.emplace_back("coarse.glb", packed(variedScene().glb(), Encoding::indexed, coarse));
    return seeds;
}

Seeds imageSeeds() {
    Bytes jpeg;
    stbi_write_jpg_to_func(append, &jpeg, 17, 9, 3, gradient(17, 9, 3).data(), 80);
    Bytes gray;
    stbi_write_jpg_to_func(append, &gray, 8, 8, 1, gradient(8, 8, 1).data(), 20);
    return {{"small.png", smallPng()},
            {"rgba.png", encodePng(gradient(9, 7, 4), 9, 7)},
            {"color.jpg", jpeg},
            {"gray.jpg", gray},
            {"lossless.webp", webpOf(gradient(9, 7, 4), 9, 7)},
            {"lossy.webp", webpOf(gradient(33, 17, 4), 33, 17, true)},
            {"animated.webp", animatedWebp()}};
}

} // namespace edgeshade::test
