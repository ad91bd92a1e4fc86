#pragma once

#include "preprocess/base/parallel.hpp"
#include "src/shadow/irregular/lanes.hpp"

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace edgeshade {

/// The part of a light's face that a PointTree's own coordinates, mostly -1 to 1, represent: rays
/// (u, v) and heights towards the light.
struct PointFrame {
    glm::dvec3 middle{0.0};
    glm::dvec3 half{1.0}; ///< from there to a coordinate of 1
    glm::dvec3 scale = 1.0 / half;

    glm::dvec3 of(const glm::dvec3& place) const { return (place - middle) * scale; }
};

/// A pixel of a picture, counted from its lower left.
struct Pixel {
    std::uint16_t column = 0, row = 0;

    Pixel() = default;
    Pixel(int column_, int row_)
        : column(static_cast<std::uint16_t>(column_)), row(static_cast<std::uint16_t>(row_)) {}
    auto operator<=>(const Pixel&) const = default;
};

/// A visible point, in a PointFrame.
struct FacePoint {
    glm::vec3 at{0.0f}; ///< u, v and height
    Pixel pixel;
};

/// Bounds of a caster in a PointFrame: its rays, and its greatest height. Points that it may shade
/// are within these rays, and no higher.
struct CasterBox {
    static constexpr float infinity = std::numeric_limits<float>::infinity();
    float u0 = infinity, u1 = -infinity, v0 = infinity, v1 = -infinity, highest = -infinity;

    void add(const CasterBox& other) {
        u0 = std::min(u0, other.u0);
        u1 = std::max(u1, other.u1);
        v0 = std::min(v0, other.v0);
        v1 = std::max(v1, other.v1);
        highest = std::max(highest, other.highest);
    }
};

/// The points with a u + b v + c height + d >= 0.
struct HalfSpace {
    float a = 0.0f, b = 0.0f, c = 0.0f, d = 0.0f;
};

/// A triangle's edges as seen by the light, positive inside, and the half space behind its plane.
using CasterPlanes = std::array<HalfSpace, 4>;

/// Eight boxes in a PointFrame.
struct PointBoxes {
    static constexpr std::size_t count = 8, parts = count / laneCount;
    std::array<Lanes, parts> u0, u1, v0, v1, h0, h1;

    PointBoxes();
    void set(std::size_t i, const glm::vec3& low, const glm::vec3& high);
    glm::vec3 lowOf(std::size_t i) const;
    glm::vec3 highOf(std::size_t i) const;
    /// One bit for each box that may hold points shaded by a caster within `box`.
    unsigned meeting(const CasterBox& box) const;
    /// One bit for each box that reaches the positive side of every plane.
    unsigned meeting(const CasterPlanes& planes) const;
};

/// The visible points of a face, sorted so that neighbours as seen by the light are adjacent, in
/// leaves of 16. There are boxes around 8 leaves, around 8 of these, and so on. Points found to be
/// in shadow aren't tested again. Several threads may search at once.
class PointTree {
  public:
    static constexpr std::size_t leafSize = 16;

    /// Replaces the tree. `parts`: the points, as found by several threads; at least one part.
    void build(const PointFrame& frame, std::span<const std::vector<FacePoint>> parts,
               Threads threads = {});

    const PointFrame& frame() const { return frame_; }
    bool empty() const { return levels_.empty(); }

    /// Groups of leaves, with the boxes around them.
    struct Groups {
        std::vector<PointBoxes> boxes;
        std::vector<std::uint32_t> groups; ///< by box

        void clear() {
            boxes.clear();
            groups.clear();
        }
    };
    /// Gathers all groups with points that casters within the box may shade. `planes`: those of a
    /// single caster, or null.
    void gather(const CasterBox& around, const CasterPlanes* planes, Groups& found) const;

    /// Finds the points behind a caster whose box is within that of gather(). Calls planes() once
    /// if the box holds points, isShadowed(pixel) for points that may be behind it, and mark(pixel)
    /// once for each that is.
    template <class Planes, class IsShadowed, class Mark>
    void find(const Groups& among, const CasterBox& box, Planes planes, IsShadowed isShadowed,
              Mark mark) {
        const CasterPlanes* by = nullptr;
        for (std::size_t b = 0; b < among.boxes.size(); ++b)
            for (unsigned met = among.boxes[b].meeting(box); met != 0; met &= met - 1) {
                const std::size_t group =
                    among.groups[b * PointBoxes::count +
                                 static_cast<std::size_t>(std::countr_zero(met))];
                unsigned leaves = levels_[0].alive[group].load(std::memory_order_relaxed);
                if (leaves != 0) leaves &= levels_[0].boxes[group].meeting(box);
                if (leaves != 0 && by) leaves &= levels_[0].boxes[group].meeting(*by);
                for (; leaves != 0; leaves &= leaves - 1) {
                    const std::size_t leaf = group * PointBoxes::count +
                                             static_cast<std::size_t>(std::countr_zero(leaves));
                    unsigned points =
                        leaves_[leaf].within(box) &
                        ~static_cast<unsigned>(found_[leaf].load(std::memory_order_relaxed));
                    if (points == 0) continue;
                    if (!by) by = &planes();
                    points &= leaves_[leaf].within(*by);
                    if (points != 0) ask(leaf, points, isShadowed, mark);
                }
            }
    }

  private:
    struct Leaf {
        static constexpr std::size_t parts = leafSize / laneCount;
        std::array<Lanes, parts> u, v, height;
        std::array<Pixel, leafSize> pixels;

        glm::vec3 low() const;
        glm::vec3 high() const;
        unsigned within(const CasterBox& box) const;
        unsigned within(const CasterPlanes& planes) const;
    };
    struct Level {
        std::vector<PointBoxes> boxes;
        /// For each group of eight boxes, one bit for each box with points not yet found.
        std::vector<std::atomic<std::uint8_t>> alive;
    };
    static constexpr unsigned all = (1u << leafSize) - 1;

    void buildLevels(Threads threads);
    void gatherIn(std::size_t level, std::size_t eight, const CasterBox& around,
                  const CasterPlanes* planes, Groups& found) const;
    void settle(std::size_t leaf);

    template <class IsShadowed, class Mark>
    void ask(std::size_t leaf, unsigned points, IsShadowed& isShadowed, Mark& mark) {
        unsigned found = 0;
        for (; points != 0; points &= points - 1) {
            const int i = std::countr_zero(points);
            if (isShadowed(leaves_[leaf].pixels[static_cast<std::size_t>(i)])) found |= 1u << i;
        }
        if (found == 0) return;
        const unsigned before =
            found_[leaf].fetch_or(static_cast<std::uint16_t>(found), std::memory_order_relaxed);
        for (unsigned fresh = found & ~before; fresh != 0; fresh &= fresh - 1)
            mark(leaves_[leaf].pixels[static_cast<std::size_t>(std::countr_zero(fresh))]);
        if ((before | found) == all && before != all) settle(leaf);
    }

    PointFrame frame_;
    std::vector<Leaf> leaves_;
    std::vector<std::atomic<std::uint16_t>> found_; ///< by leaf, one bit for each point
    std::vector<Level> levels_;                     ///< leaves' boxes come first
};

} // namespace edgeshade
