#include "web/masks/mesh_transfer.hpp"

#include "src/engine/merged_meshes.hpp"
#include "web/mesh_archive.hpp"

namespace edgeshade::web {
namespace {

void write(Writer& writer, const PreparedMesh::Data& mesh) {
    transfer(writer, *mesh.geometry);
    transfer(writer, *mesh.shadow);
    writer(mesh.alphaTested, mesh.alphaCorners);
}

PreparedMesh read(Reader& reader) {
    Geometry geometry;
    transfer(reader, geometry);
    auto shadow = std::make_shared<PlanePairShadow>();
    transfer(reader, *shadow);
    PreparedMesh::Data data{CopyOnWrite<Geometry>(std::move(geometry)), std::move(shadow)};
    reader(data.alphaTested, data.alphaCorners);
    return PreparedMesh(std::make_shared<const PreparedMesh::Data>(std::move(data)));
}

} // namespace

Bytes toTransfer(const PreparedMesh& mesh) {
    Bytes bytes;
    Writer writer(bytes);
    write(writer, *mesh.data());
    return bytes;
}

PreparedMesh meshFromTransfer(std::span<const std::uint8_t> bytes) {
    Reader reader(bytes);
    return read(reader);
}

Bytes toTransfer(const MergedMeshes& meshes) {
    const MergedMesh& merged = meshes.data()->merged;
    Bytes bytes;
    Writer writer(bytes);
    writer(merged.worldFromMerged);
    write(writer, *merged.mesh.data());
    return bytes;
}

MergedMesh mergedFromTransfer(std::span<const std::uint8_t> bytes) {
    Reader reader(bytes);
    glm::dmat4 worldFromMerged{1.0};
    reader(worldFromMerged);
    return {read(reader), worldFromMerged};
}

} // namespace edgeshade::web
