#include "web/masks/mesh_transfer.hpp"

#include "src/engine/merged_meshes.hpp"
#include "web/mesh_archive.hpp"

namespace edgeshade::web {
namespace {

void write(SplitWriter& writer, const PreparedMesh::Data& mesh) {
    transfer(writer, *mesh.geometry);
    transfer(writer, *mesh.shadow);
    writer(mesh.alphaTested, mesh.alphaCorners);
}

/// Reads in place, as vectors that lie apart are filled later.
PreparedMesh read(SplitReader& reader) {
    const auto shadow = std::make_shared<PlanePairShadow>();
    const auto data = std::make_shared<PreparedMesh::Data>(PreparedMesh::Data{{}, shadow});
    transfer(reader, data->geometry.edit());
    transfer(reader, *shadow);
    reader(data->alphaTested, data->alphaCorners);
    return PreparedMesh(data);
}

/// The bytes of what writeHead(writer) writes.
template <class WriteHead>
Bytes withHead(WriteHead&& writeHead) {
    Bytes head;
    std::vector<std::span<const std::uint8_t>> arrays;
    SplitWriter writer(head, arrays);
    writeHead(writer);
    std::size_t size = sizeof(std::uint32_t) + head.size();
    for (const auto& array : arrays)
        size += array.size();
    Bytes bytes;
    bytes.reserve(size);
    Writer start(bytes);
    start(static_cast<std::uint32_t>(head.size()));
    bytes.insert(bytes.end(), head.begin(), head.end());
    for (const auto& array : arrays)
        bytes.insert(bytes.end(), array.begin(), array.end());
    return bytes;
}

} // namespace

Bytes toTransfer(const PreparedMesh& mesh) {
    return withHead([&](SplitWriter& writer) { write(writer, *mesh.data()); });
}

Bytes toTransfer(const MergedMeshes& meshes) {
    return withHead([&](SplitWriter& writer) {
        const MergedMesh& merged = meshes.data()->merged;
        writer(merged.worldFromMerged);
        write(writer, *merged.mesh.data());
    });
}

Outlined<PreparedMesh> meshOfHead(std::span<const std::uint8_t> head) {
    std::vector<VectorApart> arrays;
    SplitReader reader(head, arrays);
    PreparedMesh mesh = read(reader);
    return {std::move(mesh), std::move(arrays)};
}

Outlined<MergedMesh> mergedOfHead(std::span<const std::uint8_t> head) {
    std::vector<VectorApart> arrays;
    SplitReader reader(head, arrays);
    glm::dmat4 worldFromMerged{1.0};
    reader(worldFromMerged);
    PreparedMesh mesh = read(reader);
    return {{std::move(mesh), worldFromMerged}, std::move(arrays)};
}

} // namespace edgeshade::web
