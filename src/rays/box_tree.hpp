#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

namespace edgeshade::rays {

/// Rays of one packet.
inline constexpr std::size_t packetSize = 16;

/// A set of a packet's rays, a bit each.
using Lanes = std::uint16_t;

/// A tree of boxes in coordinates of at most about 1. It finds every box that a ray of floats
/// meets, and some that it misses; docs/method.md, C56, says by how little. Embree's where there is
/// Embree (embree_box_tree.cpp), else one of this program's own (plain_box_tree.cpp). Thread-safe
/// once built.
class BoxTree {
  public:
    struct FloatBox {
        glm::vec3 low, high;
    };
    /// A ray of length 1 for each unit of `end`.
    struct Ray {
        glm::vec3 start, along;
        float end;
    };
    /// Where rays start.
    struct Origins {
        alignas(64) float x[packetSize], y[packetSize], z[packetSize];
    };
    /// Tests a box's item; returns the rays whose search is over.
    using Test = Lanes (*)(void* state, std::uint32_t item);

    /// `boxOf`: of each item, asked while building alone.
    BoxTree(std::vector<std::uint32_t> items, const std::function<FloatBox(std::uint32_t)>& boxOf);
    ~BoxTree();
    BoxTree(BoxTree&&) noexcept;
    BoxTree& operator=(BoxTree&&) noexcept;

    const std::vector<std::uint32_t>& items() const;

    /// Calls visit(item) for all boxes that the ray meets, in any order, until it returns true.
    void visit(const Ray& ray, const std::function<bool(std::uint32_t)>& visit) const;

    /// Calls visit(item) for all boxes that the ray meets before the least value that visit() has
    /// returned so far, near ones first, more or less.
    void visitInOrder(const Ray& ray, const std::function<float(std::uint32_t)>& visit) const;

    /// Calls test(state, item) for all boxes that rays in one direction, of length 1, meet, until
    /// the search of all of them is over. `rays`: those of the packet that search.
    void visitPacket(const Origins& origins, const glm::vec3& direction, Lanes rays, Test test,
                     void* state) const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace edgeshade::rays
