#pragma once

#include "preprocess/base/file_io.hpp"
#include "preprocess/mesh/edges.hpp"

#include <optional>

namespace edgeshade {

/// An EdgeList as three streams of bytes. Each is numbers of 32 bits, little-endian, mostly small,
/// as meshoptimizer's vertex codec (version 0) packs them:
///
/// - vertices: two an edge, how much larger a is than the edge's before it, and b than a;
/// - counts: one an edge, its opposite vertices;
/// - opposites: one an opposite vertex, how far it is from the one before it, the edge's first from
///   b; 2 d where d >= 0, else -2 d - 1.
///
/// What an Opposite says of its triangle is not kept.
struct EncodedEdges {
    Bytes vertices, counts, opposites;
};

EncodedEdges encodeEdges(const EdgeList& edges);

/// Bytes of the largest stream of `count` groups of `perGroup` numbers: 2 for vertices, else 1.
std::size_t largestStream(std::size_t count, std::size_t perGroup);

/// The stream in which a fault is.
enum class EdgeStream { vertices, counts, opposites };

/// What the streams say, or where they can't be right.
struct DecodedEdges {
    EdgeList edges;
    std::optional<EdgeStream> fault; ///< nothing: none
    std::optional<std::size_t> edge; ///< at which edge the fault is; nothing: it is no such stream
};

/// `edgeCount`, `oppositeCount`: how many there must be; `vertexCount`: of the sorted positions.
/// Safe for bytes from anywhere: takes memory by these counts alone, and what it returns without a
/// fault is an edge list over those positions.
DecodedEdges decodeEdges(const EncodedEdges& streams, std::size_t edgeCount,
                         std::size_t oppositeCount, std::size_t vertexCount);

} // namespace edgeshade
