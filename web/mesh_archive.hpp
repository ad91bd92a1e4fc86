#pragma once

#include "preprocess/volumes/plane_pair_data.hpp"
#include "web/archive.hpp"

namespace edgeshade::web {

template <class Archive>
void transfer(Archive& archive, Maybe<RecordVertices> auto& vertices) {
    archive(vertices.inBatch, vertices.pairs, vertices.singles, vertices.caps);
}

template <class Archive>
void transfer(Archive& archive, Maybe<Geometry> auto& geometry) {
    archive(geometry.positions, geometry.normals, geometry.texcoords, geometry.colors,
            geometry.tangents, geometry.indices, geometry.groups, geometry.simplifiedCasters);
    for (auto& texcoords : geometry.moreTexcoords)
        archive(texcoords);
}

template <class Archive>
void transfer(Archive& archive, Maybe<PlanePairShadow> auto& shadow) {
    archive(shadow.pairs, shadow.pairPlanes, shadow.singles, shadow.singlePlanes, shadow.caps,
            shadow.capTriangles, shadow.groups, shadow.clusters, shadow.leaves, shadow.edges,
            shadow.flatPairs, shadow.flatEdges, shadow.vertices, shadow.solids);
}

} // namespace edgeshade::web
