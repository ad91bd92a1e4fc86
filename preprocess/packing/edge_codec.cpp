#include "preprocess/packing/edge_codec.hpp"

#include <bit>
#include <meshoptimizer.h>

namespace edgeshade {
namespace {

static_assert(std::endian::native == std::endian::little);

/// Maps a difference of either sign to a number that is small if the difference is.
std::uint32_t folded(std::uint32_t to, std::uint32_t from) {
    return to >= from ? 2 * (to - from) : 2 * (from - to) - 1;
}

std::int64_t unfolded(std::uint32_t value) {
    const auto half = static_cast<std::int64_t>(value >> 1);
    return value & 1 ? -half - 1 : half;
}

Bytes encodeNumbers(const std::vector<std::uint32_t>& numbers, std::size_t perGroup) {
    const std::size_t count = numbers.size() / perGroup, size = perGroup * sizeof(std::uint32_t);
    Bytes bytes(meshopt_encodeVertexBufferBound(count, size));
    bytes.resize(
        meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), numbers.data(), count, size));
    return bytes;
}

/// Decodes `count` groups of `perGroup` numbers; null if the bytes hold anything else.
std::optional<std::vector<std::uint32_t>> decodeNumbers(const Bytes& bytes, std::size_t count,
                                                        std::size_t perGroup) {
    std::vector<std::uint32_t> numbers(count * perGroup);
    const int status = meshopt_decodeVertexBuffer(
        numbers.data(), count, perGroup * sizeof(std::uint32_t), bytes.data(), bytes.size());
    if (status != 0) return std::nullopt;
    return numbers;
}

} // namespace

EncodedEdges encodeEdges(const EdgeList& edges) {
    std::vector<std::uint32_t> vertices, counts, opposites;
    std::uint32_t lastA = 0;
    for (const Edge& edge : edges.edges) {
        vertices.insert(vertices.end(), {edge.a - lastA, edge.b - edge.a});
        counts.push_back(edge.oppositeCount);
        lastA = edge.a;
        std::uint32_t last = edge.b;
        for (const Opposite& opposite : edges.oppositesOf(edge)) {
            opposites.push_back(folded(opposite.vertex, last));
            last = opposite.vertex;
        }
    }
    meshopt_encodeVertexVersion(0);
    return {encodeNumbers(vertices, 2), encodeNumbers(counts, 1), encodeNumbers(opposites, 1)};
}

std::size_t largestStream(std::size_t count, std::size_t perGroup) {
    return meshopt_encodeVertexBufferBound(count, perGroup * sizeof(std::uint32_t));
}

DecodedEdges decodeEdges(const EncodedEdges& streams, std::size_t edgeCount,
                         std::size_t oppositeCount, std::size_t vertexCount) {
    const auto vertices = decodeNumbers(streams.vertices, edgeCount, 2);
    if (!vertices) return {{}, EdgeStream::vertices, {}};
    const auto counts = decodeNumbers(streams.counts, edgeCount, 1);
    if (!counts) return {{}, EdgeStream::counts, {}};
    const auto opposites = decodeNumbers(streams.opposites, oppositeCount, 1);
    if (!opposites) return {{}, EdgeStream::opposites, {}};

    EdgeList list;
    list.edges.reserve(edgeCount);
    list.opposites.reserve(oppositeCount);
    std::uint64_t a = 0;
    for (std::size_t e = 0; e < edgeCount; ++e) {
        a += (*vertices)[2 * e];
        const std::uint64_t b = a + (*vertices)[2 * e + 1];
        if (!(a < b && b < vertexCount)) return {{}, EdgeStream::vertices, e};
        const std::size_t first = list.opposites.size();
        const std::uint32_t count = (*counts)[e];
        if (count < 1 || count > oppositeCount - first) return {{}, EdgeStream::counts, e};
        list.edges.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                              static_cast<std::uint32_t>(first), count});
        std::uint64_t vertex = b;
        for (std::uint32_t i = 0; i < count; ++i) {
            // A negative result wraps around to more than there are.
            vertex += static_cast<std::uint64_t>(unfolded((*opposites)[first + i]));
            if (vertex >= vertexCount || vertex == a || vertex == b)
                return {{}, EdgeStream::opposites, e};
            list.opposites.push_back({static_cast<std::uint32_t>(vertex), 0});
        }
    }
    if (list.opposites.size() != oppositeCount) return {{}, EdgeStream::counts, edgeCount - 1};
    return {std::move(list), {}, {}};
}

} // namespace edgeshade
