#include "web/masks/mesh_transfer.hpp"

#include "src/engine/prepared_mesh.hpp"
#include "web/mesh_archive.hpp"

namespace edgeshade::web {

Bytes toTransfer(const PreparedMesh& mesh) {
    Bytes bytes;
    Writer writer(bytes);
    transfer(writer, *mesh.data()->geometry);
    transfer(writer, *mesh.data()->shadow);
    return bytes;
}

PreparedMesh meshFromTransfer(std::span<const std::uint8_t> bytes) {
    Reader reader(bytes);
    Geometry geometry;
    transfer(reader, geometry);
    auto shadow = std::make_shared<PlanePairShadow>();
    transfer(reader, *shadow);
    return PreparedMesh(std::make_shared<const PreparedMesh::Data>(
        PreparedMesh::Data{CopyOnWrite<Geometry>(std::move(geometry)), std::move(shadow)}));
}

} // namespace edgeshade::web
