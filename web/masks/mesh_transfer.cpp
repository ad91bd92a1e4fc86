#include "web/masks/mesh_transfer.hpp"

#include "src/engine/prepared_mesh.hpp"
#include "web/mesh_archive.hpp"

namespace edgeshade::web {

Bytes toTransfer(const PreparedMesh& mesh) {
    Bytes bytes;
    Writer writer(bytes);
    transfer(writer, *mesh.data()->geometry);
    transfer(writer, *mesh.data()->shadow);
    writer(mesh.data()->alphaTested, mesh.data()->alphaCorners);
    return bytes;
}

PreparedMesh meshFromTransfer(std::span<const std::uint8_t> bytes) {
    Reader reader(bytes);
    Geometry geometry;
    transfer(reader, geometry);
    auto shadow = std::make_shared<PlanePairShadow>();
    transfer(reader, *shadow);
    PreparedMesh::Data data{CopyOnWrite<Geometry>(std::move(geometry)), std::move(shadow)};
    reader(data.alphaTested, data.alphaCorners);
    return PreparedMesh(std::make_shared<const PreparedMesh::Data>(std::move(data)));
}

} // namespace edgeshade::web
