#pragma once

#include "src/shadow/layers/edge_vertices.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace edgeshade {

/// Divides a batch's segments on a face whose weights are above 0 into paths that rise from vertex
/// to vertex, one for each unit of a weight, and finds out how many start where (docs/method.md,
/// C48). Call begin(), add() of an Adding for all segments, then findStarts(). It keeps its memory.
class ChainPaths {
    /// A segment with a weight above 0.
    struct Rise {
        std::uint32_t lower, upper; ///< numbers of its ends
        std::uint32_t segment;
        int weight;
    };

  public:
    /// `vertices`: number of EdgeVertices::places. `most`: of segments.
    void begin(std::size_t vertices, std::size_t most) {
        if (rising_.size() < vertices) rising_.resize(vertices, 0);
        if (rises_.size() <= most) rises_.resize(most + 1);
        count_ = 0;
    }

    /// Adds segments as long as it lives, one of these at a time.
    class Adding {
      public:
        explicit Adding(ChainPaths& to) : to_(to), next_(to.rises_.data() + to.count_) {}
        Adding(const Adding&) = delete;
        Adding& operator=(const Adding&) = delete;
        ~Adding() { to_.count_ = static_cast<std::size_t>(next_ - to_.rises_.data()); }

        /// `lower`, `upper`: the numbers of its ends. `segment`: findStarts() tells about it so.
        void add(std::uint32_t lower, std::uint32_t upper, int weight, std::size_t segment) {
            // Without a branch, as nothing predicts it.
            *next_ = {lower, upper, static_cast<std::uint32_t>(segment), weight};
            next_ += weight > 0 ? 1 : 0;
        }

      private:
        ChainPaths& to_;
        Rise* next_;
    };

    /// Calls set(segment, starts) for all segments with weights above 0: `starts` paths start at
    /// its lower end. Of segments that share this end all but one have 0.
    template <class Set>
    void findStarts(Set set) {
        int* const rising = rising_.data();
        const std::span<const Rise> rises(rises_.data(), count_);
        for (const Rise& rise : rises) {
            rising[rise.lower] += rise.weight;
            rising[rise.upper] -= rise.weight;
        }
        for (const Rise& rise : rises) {
            int& lower = rising[rise.lower];
            set(rise.segment, std::max(lower, 0));
            lower = std::min(lower, 0);
            int& upper = rising[rise.upper]; // perhaps the same
            upper = std::max(upper, 0);
        }
    }

  private:
    std::vector<Rise> rises_; ///< the first count_
    std::size_t count_ = 0;
    /// By vertex: paths that rise from it, less those that rise to it. 0 outside of findStarts().
    std::vector<int> rising_;
};

} // namespace edgeshade
