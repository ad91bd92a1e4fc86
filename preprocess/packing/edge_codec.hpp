#pragma once

#include "preprocess/base/file_io.hpp"
#include "preprocess/mesh/edges.hpp"

#include <optional>

namespace edgeshade {

/// An EdgeList as three byte streams. Each holds 32-bit little-endian numbers, mostly small, as
/// packed by meshoptimizer's vertex codec (version 0):
///
/// - vertices: two per edge, the differences of a from the previous edge's a, and of b from a;
/// - counts: one per edge, its number of opposite vertices;
/// - opposites: one per opposite vertex, its difference d from the previous one, or for an edge's
///   first from b; stored as 2 d if d >= 0, otherwise as -2 d - 1.
///
/// The triangle of an Opposite is not kept.
struct EncodedEdges {
    Bytes vertices, counts, opposites;
};

EncodedEdges encodeEdges(const EdgeList& edges);

/// The largest possible size in bytes of a stream of `count` groups of `perGroup` numbers: 2 for
/// vertices, otherwise 1.
std::size_t largestStream(std::size_t count, std::size_t perGroup);

/// A stream, to say which one is faulty.
enum class EdgeStream { vertices, counts, opposites };

/// The decoded edges, or the location of the fault.
struct DecodedEdges {
    EdgeList edges;
    std::optional<EdgeStream> fault; ///< null: no fault
    std::optional<std::size_t> edge; ///< the faulty edge; null: the whole stream is invalid
};

/// `edgeCount`, `oppositeCount`: the counts required; `vertexCount`: of the sorted positions. Safe
/// on untrusted input: memory depends on these counts alone, and a result without a fault is an
/// edge list over those positions.
DecodedEdges decodeEdges(const EncodedEdges& streams, std::size_t edgeCount,
                         std::size_t oppositeCount, std::size_t vertexCount);

} // namespace edgeshade
