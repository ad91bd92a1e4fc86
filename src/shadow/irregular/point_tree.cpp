#include "src/shadow/irregular/point_tree.hpp"

#include <algorithm>
#include <utility>

namespace edgeshade {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

constexpr std::uint32_t cellBits = 8; ///< bits per side of a face's cell index

/// Spreads a byte's bits, with a 0 before each.
std::uint32_t spread(std::uint32_t bits) {
    bits = (bits | bits << 4) & 0x0F0Fu;
    bits = (bits | bits << 2) & 0x3333u;
    return (bits | bits << 1) & 0x5555u;
}

/// The cell of a point, in Morton order over the face.
std::uint32_t cellOf(const FacePoint& point) {
    const auto step = [](float at) {
        constexpr float most = (1u << cellBits) - 1;
        return static_cast<std::uint32_t>(
            std::clamp((at + 1.0f) * 0.5f * (1u << cellBits), 0.0f, most));
    };
    return spread(step(point.at.x)) | spread(step(point.at.y)) << 1;
}

using Cells = std::vector<std::uint32_t>;

/// By part and cell: the position of the part's first point in the cell. Points are sorted by cell,
/// and within a cell by part.
std::vector<Cells> firstPlaces(std::span<const std::vector<FacePoint>> parts, Threads threads) {
    std::vector<Cells> places(parts.size());
    inParallel(parts.size(), threads, [&](std::size_t part) {
        places[part].assign(1u << (2 * cellBits), 0);
        for (const FacePoint& point : parts[part])
            ++places[part][cellOf(point)];
    });
    std::uint32_t sum = 0;
    for (std::size_t cell = 0; cell < places[0].size(); ++cell)
        for (Cells& of : places)
            sum += std::exchange(of[cell], sum);
    return places;
}

std::size_t groupsOf(std::size_t count) {
    return (count + PointBoxes::count - 1) / PointBoxes::count;
}

template <class Parts>
float laneAt(const Parts& parts, std::size_t i) {
    return parts[i / laneCount][i % laneCount];
}

template <class Parts>
float leastOf(const Parts& parts) {
    Lanes least = parts[0];
    for (const Lanes& of : parts)
        least = of < least ? of : least;
    return std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
}

template <class Parts>
float mostOf(const Parts& parts) {
    Lanes most = parts[0];
    for (const Lanes& of : parts)
        most = of > most ? of : most;
    return std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
}

glm::vec3 lowOfAll(const PointBoxes& boxes) {
    return {leastOf(boxes.u0), leastOf(boxes.v0), leastOf(boxes.h0)};
}

glm::vec3 highOfAll(const PointBoxes& boxes) {
    return {mostOf(boxes.u1), mostOf(boxes.v1), mostOf(boxes.h1)};
}

template <class Parts>
void setLane(Parts& parts, std::size_t i, float value) {
    parts[i / laneCount][i % laneCount] = value;
}

} // namespace

PointBoxes::PointBoxes() {
    for (std::size_t p = 0; p < parts; ++p) {
        u0[p] = v0[p] = h0[p] = Lanes{} + infinity;
        u1[p] = v1[p] = h1[p] = Lanes{} - infinity;
    }
}

void PointBoxes::set(std::size_t i, const glm::vec3& low, const glm::vec3& high) {
    setLane(u0, i, low.x);
    setLane(v0, i, low.y);
    setLane(h0, i, low.z);
    setLane(u1, i, high.x);
    setLane(v1, i, high.y);
    setLane(h1, i, high.z);
}

glm::vec3 PointBoxes::lowOf(std::size_t i) const {
    return {laneAt(u0, i), laneAt(v0, i), laneAt(h0, i)};
}

glm::vec3 PointBoxes::highOf(std::size_t i) const {
    return {laneAt(u1, i), laneAt(v1, i), laneAt(h1, i)};
}

unsigned PointBoxes::meeting(const CasterBox& box) const {
    unsigned bits = 0;
    for (std::size_t p = 0; p < parts; ++p) {
        const LaneMask mask = (u0[p] <= box.u1) & (u1[p] >= box.u0) & (v0[p] <= box.v1) &
                              (v1[p] >= box.v0) & (h0[p] <= box.highest);
        bits |= bitsOf(mask) << (p * laneCount);
    }
    return bits;
}

unsigned PointBoxes::meeting(const CasterPlanes& planes) const {
    unsigned bits = 0;
    for (std::size_t p = 0; p < parts; ++p) {
        LaneMask mask = LaneMask{} - 1;
        for (const HalfSpace& of : planes)
            mask &= of.a * (of.a > 0.0f ? u1 : u0)[p] + of.b * (of.b > 0.0f ? v1 : v0)[p] +
                        of.c * (of.c > 0.0f ? h1 : h0)[p] + of.d >=
                    0.0f;
        bits |= bitsOf(mask) << (p * laneCount);
    }
    return bits;
}

unsigned PointTree::Leaf::within(const CasterBox& box) const {
    unsigned bits = 0;
    for (std::size_t p = 0; p < parts; ++p) {
        const LaneMask mask = (u[p] >= box.u0) & (u[p] <= box.u1) & (v[p] >= box.v0) &
                              (v[p] <= box.v1) & (height[p] <= box.highest);
        bits |= bitsOf(mask) << (p * laneCount);
    }
    return bits;
}

unsigned PointTree::Leaf::within(const CasterPlanes& planes) const {
    unsigned bits = 0;
    for (std::size_t p = 0; p < parts; ++p) {
        LaneMask mask = LaneMask{} - 1;
        for (const HalfSpace& of : planes)
            mask &= of.a * u[p] + of.b * v[p] + of.c * height[p] + of.d >= 0.0f;
        bits |= bitsOf(mask) << (p * laneCount);
    }
    return bits;
}

glm::vec3 PointTree::Leaf::low() const {
    return {leastOf(u), leastOf(v), leastOf(height)};
}

glm::vec3 PointTree::Leaf::high() const {
    return {mostOf(u), mostOf(v), mostOf(height)};
}

void PointTree::build(const PointFrame& frame, std::span<const std::vector<FacePoint>> parts,
                      Threads threads) {
    frame_ = frame;
    levels_.clear();
    std::size_t count = 0;
    for (const auto& of : parts)
        count += of.size();
    if (count == 0) return;
    const std::size_t leaves = (count + leafSize - 1) / leafSize;
    leaves_.resize(leaves);
    found_ = std::vector<std::atomic<std::uint16_t>>(leaves);
    const auto put = [&](std::size_t place, const FacePoint& point) {
        Leaf& leaf = leaves_[place / leafSize];
        const std::size_t i = place % leafSize;
        setLane(leaf.u, i, point.at.x);
        setLane(leaf.v, i, point.at.y);
        setLane(leaf.height, i, point.at.z);
        leaf.pixels[i] = point.pixel;
    };
    std::vector<Cells> next = firstPlaces(parts, threads);
    inParallel(parts.size(), threads, [&](std::size_t part) {
        for (const FacePoint& point : parts[part])
            put(next[part][cellOf(point)]++, point);
    });
    // Pads the last leaf with copies of one of its points, marked as found.
    const Leaf& last = leaves_.back();
    const FacePoint one{{last.u[0][0], last.v[0][0], last.height[0][0]}, last.pixels[0]};
    for (std::size_t place = count; place < leaves * leafSize; ++place) {
        put(place, one);
        found_.back().fetch_or(static_cast<std::uint16_t>(1u << place % leafSize));
    }
    buildLevels(threads);
}

void PointTree::buildLevels(Threads threads) {
    std::size_t filled = leaves_.size();
    std::vector<PointBoxes> boxes(groupsOf(filled));
    forEachItem(boxes.size(), itemsOfThread / PointBoxes::count, threads, [&](std::size_t group) {
        const std::size_t first = group * PointBoxes::count;
        for (std::size_t i = first; i < std::min(first + PointBoxes::count, filled); ++i)
            boxes[group].set(i - first, leaves_[i].low(), leaves_[i].high());
    });
    while (true) {
        Level& level = levels_.emplace_back();
        level.alive = std::vector<std::atomic<std::uint8_t>>(boxes.size());
        for (std::size_t i = 0; i < boxes.size(); ++i)
            level.alive[i].store(static_cast<std::uint8_t>(
                (1u << std::min(PointBoxes::count, filled - i * PointBoxes::count)) - 1));
        level.boxes = std::move(boxes);
        if (level.boxes.size() == 1) return;
        filled = level.boxes.size();
        boxes = std::vector<PointBoxes>(groupsOf(filled));
        for (std::size_t i = 0; i < filled; ++i)
            boxes[i / PointBoxes::count].set(i % PointBoxes::count, lowOfAll(level.boxes[i]),
                                             highOfAll(level.boxes[i]));
    }
}

void PointTree::gather(const CasterBox& around, const CasterPlanes* planes, Groups& found) const {
    found.clear();
    if (levels_.empty()) return;
    if (levels_.size() > 1) {
        gatherIn(levels_.size() - 1, 0, around, planes, found);
    } else { // a single group, without boxes around it
        found.groups.push_back(0);
        found.boxes.emplace_back().set(0, lowOfAll(levels_[0].boxes[0]),
                                       highOfAll(levels_[0].boxes[0]));
    }
    found.groups.resize(found.boxes.size() * PointBoxes::count, 0);
}

void PointTree::gatherIn(std::size_t level, std::size_t eight, const CasterBox& around,
                         const CasterPlanes* planes, Groups& found) const {
    const Level& of = levels_[level];
    unsigned met = of.alive[eight].load(std::memory_order_relaxed);
    if (met == 0) return;
    met &= of.boxes[eight].meeting(around);
    if (planes && met != 0) met &= of.boxes[eight].meeting(*planes);
    for (; met != 0; met &= met - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(met));
        const std::size_t child = eight * PointBoxes::count + i;
        if (level > 1) {
            gatherIn(level - 1, child, around, planes, found);
            continue;
        }
        const std::size_t at = found.groups.size() % PointBoxes::count;
        if (at == 0) found.boxes.emplace_back();
        found.boxes.back().set(at, of.boxes[eight].lowOf(i), of.boxes[eight].highOf(i));
        found.groups.push_back(static_cast<std::uint32_t>(child));
    }
}

void PointTree::settle(std::size_t box) {
    for (Level& level : levels_) {
        const auto bit = static_cast<std::uint8_t>(1u << (box % PointBoxes::count));
        const unsigned before = level.alive[box / PointBoxes::count].fetch_and(
            static_cast<std::uint8_t>(~bit), std::memory_order_relaxed);
        if ((before & ~static_cast<unsigned>(bit)) != 0 || (before & bit) == 0) return;
        box /= PointBoxes::count;
    }
}

} // namespace edgeshade
