#include "preprocess/section/cut_writer.hpp"

#include "preprocess/section/vertex_attributes.hpp"

#include <algorithm>
#include <limits>

namespace edgeshade {
namespace {

template <class Value>
void take(const std::vector<Value>& from, std::size_t more, std::vector<Value>& to) {
    if (from.empty() || to.size() < from.size())
        to.clear();
    else
        to.resize(from.size());
    if (from.empty()) return;
    to.reserve(from.size() + more);
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(to.size()), from.end());
}

} // namespace

void takeVertices(const Geometry& geometry, std::size_t more, Geometry& to) {
    forEachAttribute([&](const auto& values, auto& taken) { take(values, more, taken); }, geometry,
                     to);
    to.indices.clear();
    to.groups.clear();
    to.sources.clear();
    to.simplifiedCasters.reset();
}

CutWriter::CutWriter(const Geometry& from, const std::vector<TriangleFate>& fates,
                     std::span<const CutTriangle> pieces, int placedBy, Geometry& to,
                     CutOrigins& origins)
    : from_(from), fates_(fates), pieces_(pieces), placedBy_(placedBy), to_(to), origins_(origins) {
    to_.indices.reserve(from.indices.size() + 3 * pieces.size());
    origins_.ofTriangle.reserve(from.indices.size() / 3 + pieces.size());
}

void CutWriter::begin(std::size_t material) {
    to_.groups.push_back({material, static_cast<std::uint32_t>(to_.indices.size()), 0});
}

void CutWriter::end() {
    SurfaceGroup& group = to_.groups.back();
    group.indexCount = static_cast<std::uint32_t>(to_.indices.size()) - group.firstIndex;
    if (group.indexCount == 0) to_.groups.pop_back();
}

void CutWriter::add(const std::array<std::uint32_t, 3>& corners, std::uint32_t origin) {
    to_.indices.insert(to_.indices.end(), corners.begin(), corners.end());
    origins_.ofTriangle.push_back(origin);
}

std::uint32_t CutWriter::addSourceOf(std::uint32_t triangle) {
    constexpr std::uint32_t noEnd = std::numeric_limits<std::uint32_t>::max();
    if (from_.sources.empty() && to_.sources.empty()) return noEnd;
    addSource(to_, nodeOf(from_, placedBy_, 3 * triangle));
    const auto after = std::upper_bound(
        from_.sources.begin(), from_.sources.end(), 3 * triangle,
        [](std::uint32_t at, const SourceNode& source) { return at < source.firstIndex; });
    return after == from_.sources.end() ? noEnd : after->firstIndex / 3;
}

void CutWriter::addWhole(std::uint32_t first, std::uint32_t end) {
    while (first < end) {
        const std::uint32_t last = std::min(end, addSourceOf(first));
        const auto corners = from_.indices.begin();
        to_.indices.insert(to_.indices.end(), corners + std::ptrdiff_t{3} * first,
                           corners + std::ptrdiff_t{3} * last);
        for (; first < last; ++first)
            origins_.ofTriangle.push_back(first);
    }
}

void CutWriter::addPart(const SurfaceGroup& group, std::size_t material, bool away) {
    const std::uint32_t first = group.firstIndex / 3, last = first + group.indexCount / 3;
    const TriangleFate taken = away ? TriangleFate::away : TriangleFate::kept;
    auto piece = std::lower_bound(
        pieces_.begin(), pieces_.end(), first,
        [](const CutTriangle& of, std::uint32_t source) { return of.source < source; });
    begin(material);
    for (std::uint32_t t = first; t < last;) {
        const TriangleFate fate = fates_[t];
        std::uint32_t other = t + 1;
        while (other < last && fates_[other] == fate && fate != TriangleFate::met)
            ++other;
        if (fate == taken) addWhole(t, other);
        for (; piece != pieces_.end() && piece->source == t; ++piece) {
            if (piece->away != away) continue;
            addSourceOf(t);
            add(piece->corners, CutOrigins::piece + t);
        }
        t = other;
    }
    end();
}

void CutWriter::addFill(std::span<const CutTriangle> fill, std::size_t material) {
    if (fill.empty()) return;
    begin(material);
    for (const CutTriangle& piece : fill) {
        if (piece.away) continue;
        addSource(to_, -1);
        add(piece.corners, CutOrigins::fill);
    }
    end();
}

} // namespace edgeshade
