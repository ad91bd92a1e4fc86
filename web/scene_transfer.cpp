#include "web/scene_transfer.hpp"

#include "preprocess/gltf/buffer_view.hpp"
#include "preprocess/gltf/glb.hpp"
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/packing/packed_file.hpp"
#include "web/mesh_archive.hpp"

#include <set>

namespace edgeshade::web {

using Json = nlohmann::ordered_json;

template <class Archive>
void transfer(Archive& archive, Maybe<MorphTarget> auto& target) {
    archive(target.positions, target.normals, target.tangents);
}

template <class Archive>
void transfer(Archive& archive, Maybe<SourceMesh> auto& mesh) {
    archive(mesh.positions, mesh.normals, mesh.tangents, mesh.targets, mesh.influences.all,
            mesh.influences.firstOf);
}

template <class Archive>
void transfer(Archive& archive, Maybe<DeformedPart> auto& part) {
    archive(part.mesh, part.batchFromMesh, part.node, part.restWeights, part.firstVertex,
            part.corners);
}

template <class Archive>
void transfer(Archive& archive, Maybe<Deformation> auto& deformation) {
    archive(deformation.meshes, deformation.joints, deformation.place, deformation.parts);
}

/// Everything except its geometry.
template <class Archive>
void transfer(Archive& archive, Maybe<Batch> auto& batch) {
    archive(batch.node, batch.worldFromBatch, batch.nodeFromBatch, batch.hidden, batch.deformation,
            batch.shape.batchFromMesh, batch.shape.weights);
}

template <class Archive>
void transfer(Archive& archive, Maybe<SceneCamera> auto& camera) {
    archive(camera.name, camera.nodeName, camera.place, camera.worldFromCamera, camera.orthographic,
            camera.height);
}

template <class Archive>
void transfer(Archive& archive, Maybe<SceneLight> auto& light) {
    archive(light.kind, light.name, light.nodeName, light.place, light.position, light.direction,
            light.color, light.intensity, light.range, light.innerCone, light.outerCone);
}

namespace {

/// A GLB that contains only the images that materials use, at their indices, except those whose
/// pixels are at hand.
Bytes imagesAlone(const LoadedScene& loaded) {
    Json json = {{"asset", {{"version", "2.0"}}}};
    Bytes binary;
    std::set<int> wanted;
    for (const Material& material : loaded.scene.materials)
        for (const MaterialTexture& texture : material.textures)
            if (texture.image >= 0 && !loaded.images.contains(texture.image))
                wanted.insert(texture.image);
    for (const int index : wanted) {
        if (!json.contains("images"))
            json["images"] = Json(loaded.document->json["images"].size(),
                                  {{"uri", "data:application/octet-stream;base64,AA=="}});
        const auto image = static_cast<std::size_t>(index);
        const std::size_t view =
            appendView(json, binary, encodedImageBytes(*loaded.document, index));
        json["images"].at(image) = {{"bufferView", view}, {"mimeType", "image/png"}};
    }
    if (!binary.empty()) json["buffers"] = Json::array({{{"byteLength", binary.size()}}});
    return joinGlb(json.dump(), std::move(binary));
}

Bytes documentFor(const LoadedScene& loaded) {
    const Json& json = loaded.document->json;
    if (!json.contains("animations") || json["animations"].empty()) return imagesAlone(loaded);
    Warnings ofImages; // the images that are drawn have been checked already
    return packedGlb(*loaded.document, loaded.scene, {}, Encoding::none, loaded.settings, ofImages);
}

} // namespace

Bytes toTransfer(const LoadedScene& loaded) {
    Bytes bytes;
    Writer writer(bytes);
    writer(loaded.document->path.string(), documentFor(loaded), loaded.scene.batches,
           loaded.scene.animatedNodes, loaded.scene.materials, loaded.scene.cameras,
           loaded.scene.lights, loaded.scene.culls, loaded.settings);
    const std::vector<std::size_t> first = firstOfGeometry(loaded.scene.batches);
    writer(first);
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i] != i) continue;
        transfer(writer, *loaded.scene.batches[i].geometry);
        transfer(writer, *loaded.planePairs[i]);
    }
    writer(loaded.images.size());
    for (const auto& [index, image] : loaded.images)
        writer(index, image->width, image->height, image->rgba);
    writer(loaded.scene.warnings.sentences().size());
    for (const std::string& sentence : loaded.scene.warnings.sentences())
        writer(sentence);
    return bytes;
}

LoadedScene fromTransfer(std::span<const std::uint8_t> bytes) {
    LoadedScene loaded;
    Reader reader(bytes);
    std::string path;
    Bytes document;
    std::size_t images = 0, warnings = 0;
    reader(path, document, loaded.scene.batches, loaded.scene.animatedNodes, loaded.scene.materials,
           loaded.scene.cameras, loaded.scene.lights, loaded.scene.culls, loaded.settings);
    std::vector<std::size_t> first;
    reader(first);
    std::vector<Batch>& batches = loaded.scene.batches;
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i] != i) {
            batches[i].geometry = batches[first[i]].geometry;
            loaded.planePairs.push_back(loaded.planePairs[first[i]]);
            continue;
        }
        Geometry geometry;
        transfer(reader, geometry);
        batches[i].geometry = CopyOnWrite(std::move(geometry));
        PlanePairShadow shadow;
        transfer(reader, shadow);
        loaded.planePairs.push_back(std::make_shared<const PlanePairShadow>(std::move(shadow)));
    }
    reader(images);
    for (std::size_t i = 0; i < images; ++i) {
        int index = 0;
        Image image;
        reader(index, image.width, image.height, image.rgba);
        loaded.images[index] = std::make_shared<const Image>(std::move(image));
    }
    reader(warnings);
    loaded.document = std::make_shared<const GltfDocument>(parseGltf(document, path));
    for (std::size_t i = 0; i < warnings; ++i) {
        std::string sentence;
        reader(sentence);
        loaded.scene.warnings.add(sentence);
    }
    return loaded;
}

} // namespace edgeshade::web
