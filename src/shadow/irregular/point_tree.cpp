#include "src/shadow/irregular/point_tree.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

constexpr std::uint32_t cellBits = 8; ///< of a face, along each side

/// Every other bit of a byte's is 0.
std::uint32_t spread(std::uint32_t bits) {
    bits = (bits | bits << 4) & 0x0F0Fu;
    bits = (bits | bits << 2) & 0x3333u;
    return (bits | bits << 1) & 0x5555u;
}

/// The cell that a point is in, along a curve that fills the face (Morton order).
std::uint32_t cellOf(const FacePoint& point) {
    const auto step = [](float at) {
        constexpr float most = (1u << cellBits) - 1;
        return static_cast<std::uint32_t>(
            std::clamp((at + 1.0f) * 0.5f * (1u << cellBits), 0.0f, most));
    };
    return spread(step(point.u)) | spread(step(point.v)) << 1;
}

/// The points, cell by cell, in each as they were.
std::vector<FacePoint> byCell(std::span<const FacePoint> points) {
    std::vector<std::uint16_t> cells(points.size());
    std::vector<std::uint32_t> next(1u << (2 * cellBits), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        cells[i] = static_cast<std::uint16_t>(cellOf(points[i]));
        ++next[cells[i]];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& of : next) {
        const std::uint32_t count = of;
        of = sum;
        sum += count;
    }
    std::vector<FacePoint> sorted(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        sorted[next[cells[i]]++] = points[i];
    return sorted;
}

std::size_t groupsOf(std::size_t count) {
    return (count + PointBoxes::count - 1) / PointBoxes::count;
}

template <class Parts>
float laneAt(const Parts& parts, std::size_t i) {
    return parts[i / laneCount][i % laneCount];
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

void PointBoxes::add(std::size_t i, float u, float v, float height) {
    setLane(u0, i, std::min(laneAt(u0, i), u));
    setLane(u1, i, std::max(laneAt(u1, i), u));
    setLane(v0, i, std::min(laneAt(v0, i), v));
    setLane(v1, i, std::max(laneAt(v1, i), v));
    setLane(h0, i, std::min(laneAt(h0, i), height));
    setLane(h1, i, std::max(laneAt(h1, i), height));
}

void PointBoxes::add(std::size_t i, const PointBoxes& others, std::size_t other) {
    add(i, laneAt(others.u0, other), laneAt(others.v0, other), laneAt(others.h0, other));
    add(i, laneAt(others.u1, other), laneAt(others.v1, other), laneAt(others.h1, other));
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

void PointTree::build(const FaceFrame& frame, std::span<const FacePoint> points) {
    frame_ = frame;
    levels_.clear();
    if (points.empty()) return;
    const std::vector<FacePoint> sorted = byCell(points);
    const std::size_t count = sorted.size(), leaves = (count + leafSize - 1) / leafSize;
    leaves_.resize(leaves);
    found_ = std::vector<std::atomic<std::uint16_t>>(leaves);
    std::vector<PointBoxes> boxes(groupsOf(leaves));
    for (std::size_t leaf = 0; leaf < leaves; ++leaf) {
        Leaf& of = leaves_[leaf];
        float u0 = infinity, u1 = -infinity, v0 = infinity, v1 = -infinity, h0 = infinity,
              h1 = -infinity;
        for (std::size_t i = 0; i < leafSize; ++i) {
            const std::size_t at = leaf * leafSize + i;
            // The last leaf is filled up with its last point, found already.
            const FacePoint& point = sorted[std::min(at, count - 1)];
            if (at >= count)
                found_[leaf].store(static_cast<std::uint16_t>(found_[leaf].load() | 1u << i));
            setLane(of.u, i, point.u);
            setLane(of.v, i, point.v);
            setLane(of.height, i, point.height);
            of.pixels[i] = point.pixel;
            u0 = std::min(u0, point.u);
            u1 = std::max(u1, point.u);
            v0 = std::min(v0, point.v);
            v1 = std::max(v1, point.v);
            h0 = std::min(h0, point.height);
            h1 = std::max(h1, point.height);
        }
        PointBoxes& group = boxes[leaf / PointBoxes::count];
        group.add(leaf % PointBoxes::count, u0, v0, h0);
        group.add(leaf % PointBoxes::count, u1, v1, h1);
    }
    for (std::size_t filled = leaves;;) {
        Level& level = levels_.emplace_back();
        level.alive = std::vector<std::atomic<std::uint8_t>>(boxes.size());
        for (std::size_t i = 0; i < filled; ++i)
            level.alive[i / PointBoxes::count].fetch_or(
                static_cast<std::uint8_t>(1u << i % PointBoxes::count), std::memory_order_relaxed);
        std::vector<PointBoxes> coarser(groupsOf(boxes.size()));
        for (std::size_t i = 0; i < filled; ++i) {
            const std::size_t eight = i / PointBoxes::count;
            coarser[eight / PointBoxes::count].add(eight % PointBoxes::count, boxes[eight],
                                                   i % PointBoxes::count);
        }
        level.boxes = std::move(boxes);
        if (level.boxes.size() == 1) break;
        filled = level.boxes.size();
        boxes = std::move(coarser);
    }
}

void PointTree::gather(const CasterBox& around, const CasterPlanes* planes, Groups& found) const {
    found.boxes.clear();
    found.groups.clear();
    if (levels_.empty()) return;
    if (levels_.size() == 1) {
        // One group, around which there is no box.
        found.groups.push_back(0);
        for (std::size_t i = 0; i < PointBoxes::count; ++i)
            found.boxes.resize(1), found.boxes[0].add(0, levels_[0].boxes[0], i);
    } else {
        gatherIn(levels_.size() - 1, 0, around, planes, found);
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
        found.boxes.back().add(at, of.boxes[eight], i);
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
