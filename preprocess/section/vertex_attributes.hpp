#pragma once

#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// Calls visit() for each array of vertices' attributes, positions first, with that array of each
/// of the geometries. Arrays that a geometry doesn't have are empty.
template <class Visit, class... Geometries>
void forEachAttribute(const Visit& visit, Geometries&... of) {
    visit(of.positions...);
    visit(of.normals...);
    visit(of.texcoords...);
    visit(of.colors...);
    for (std::size_t i = 0; i < mostTexcoordChannels - 1; ++i)
        visit(of.moreTexcoords[i]...);
    visit(of.tangents...);
}

} // namespace edgeshade
