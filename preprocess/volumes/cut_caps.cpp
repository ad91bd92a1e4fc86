#include "preprocess/volumes/cut_caps.hpp"

#include <optional>

namespace edgeshade {
namespace {

/// A piece as a caster of the cut geometry.
struct PieceCaster {
    std::array<glm::vec3, 3> corners;
    std::uint32_t number = 0; ///< among casters with an area
};

/// The casters of the cut geometry: their numbers, without triangles that welding drops.
struct Numbers {
    std::vector<std::uint32_t> ofCap; ///< by cap before the cut; or none
    std::vector<PieceCaster> pieces;
    std::uint32_t firstAway = 0, end = 0;
    std::uint32_t singleSided = 0;
    std::optional<std::size_t> material, awayMaterial; ///< one that is visible, one that is not
};

Numbers numbersOf(const UncutRecords& uncut, const Geometry& cut, const CutOrigins& origins,
                  const std::vector<Material>& materials, bool castMasked) {
    Numbers numbers;
    numbers.ofCap.assign(uncut.shadow->caps.size(), UncutRecords::none);
    std::uint32_t next = 0;
    for (const SurfaceGroup& group : cut.groups) {
        const Material& material = materials[group.material];
        if (!material.casts(castMasked)) continue;
        if (!material.isSeen() && !numbers.awayMaterial) {
            numbers.awayMaterial = group.material;
            numbers.firstAway = next;
        }
        if (!numbers.material) numbers.material = group.material;
        const std::uint32_t first = group.firstIndex / 3, before = next;
        for (std::uint32_t t = first; t < first + group.indexCount / 3; ++t) {
            if (const std::uint32_t origin = origins.ofTriangle[t]; origin != CutOrigins::piece) {
                const std::uint32_t cap = uncut.capOf[origin];
                if (cap != UncutRecords::none) numbers.ofCap[cap] = next++;
                continue;
            }
            const std::uint32_t* const corner = &cut.indices[std::size_t{3} * t];
            const std::array<glm::vec3, 3> corners = {
                cut.positions[corner[0]], cut.positions[corner[1]], cut.positions[corner[2]]};
            if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
                numbers.pieces.push_back({corners, next++});
        }
        if (!material.doubleSided) numbers.singleSided += next - before;
    }
    numbers.end = next;
    if (!numbers.awayMaterial) numbers.firstAway = next;
    return numbers;
}

/// Adds the caps whose numbers are in [first, end), and their group.
void addPart(const UncutRecords& uncut, const Numbers& numbers, std::uint32_t first,
             std::uint32_t end, std::size_t material, CutCaps& to) {
    if (first == end) return;
    const auto isOfPart = [&](std::uint32_t number) { return number >= first && number < end; };
    const auto firstCap = static_cast<std::uint32_t>(to.caps.size());
    const std::vector<CapRecord>& before = uncut.shadow->caps;
    for (std::size_t cap = 0; cap < before.size(); ++cap) {
        if (!isOfPart(numbers.ofCap[cap])) continue;
        to.capOf[cap] = static_cast<std::uint32_t>(to.caps.size());
        to.caps.push_back(before[cap]);
        to.capTriangles.push_back(numbers.ofCap[cap]);
    }
    for (const PieceCaster& piece : numbers.pieces) {
        if (!isOfPart(piece.number)) continue;
        const auto cap = static_cast<std::uint32_t>(to.caps.size());
        to.pieces.push_back({piece.corners, cap});
        to.caps.push_back({piece.corners[0], piece.corners[1], piece.corners[2], glm::vec4(0.0f)});
        to.capTriangles.push_back(piece.number);
    }
    to.groups.push_back(
        {material, firstCap, static_cast<std::uint32_t>(to.caps.size()) - firstCap});
}

} // namespace

void findCaps(const UncutRecords& uncut, const Geometry& cut, const CutOrigins& origins,
              const std::vector<Material>& materials, bool castMasked, CutCaps& made) {
    const Numbers numbers = numbersOf(uncut, cut, origins, materials, castMasked);
    made.capOf.assign(numbers.ofCap.size(), UncutRecords::none);
    made.caps.reserve(numbers.end);
    made.capTriangles.reserve(numbers.end);
    made.pieces.reserve(numbers.pieces.size());
    addPart(uncut, numbers, 0, numbers.firstAway, numbers.material.value_or(0), made);
    addPart(uncut, numbers, numbers.firstAway, numbers.end, numbers.awayMaterial.value_or(0), made);
    made.away = numbers.end - numbers.firstAway;
    made.singleSided = numbers.singleSided;
}

} // namespace edgeshade
