#include "src/shadow/scissors/scissored_plan.hpp"

#include "src/shadow/plan/side_fill.hpp"
#include "src/shadow/plan/side_sample.hpp"
#include "src/shadow/scissors/cluster_scissors.hpp"

#include <algorithm>
#include <span>

namespace edgeshade {
namespace {

/// Silhouette edges that tell what a cluster's sides take.
constexpr std::uint32_t mostSamples = 4;

/// Edges of a group that are looked at where it grows.
constexpr std::size_t mostAsked = 64;

/// Where a frame's volumes are drawn, and what that takes.
struct FillTask {
    glm::dmat4 clipFromWorld;
    int width, height;
    FillWeights weights;

    FillTask(const FrameView& view, const DepthSlice& slice, const FillWeights& of)
        : clipFromWorld(view.clipFromView(slice) * view.frustum.viewFromWorld), width(view.width),
          height(view.height), weights(of) {}

    /// In nanoseconds, of sides of a batch in a rectangle of pixels.
    double of(std::span<const SampledEdge> edges, const BatchPlan& batch, const ClusterPlan& draw,
              const PixelRectangle& within) const {
        const FillMeter meter(clipFromWorld * batch.worldFromBatch, width, height, within);
        const glm::dvec4 end(endOf(draw, batch.ends));
        double cost = 0.0;
        for (const SampledEdge& edge : edges)
            cost += edge.weight *
                    weights.of(sideFill(meter, edge.a, edge.b, glm::dvec4(batch.light), end));
        return cost;
    }
};

/// One cluster of those that a plan draws alike.
ClusterPlan oneOf(const ClusterPlan& alike, std::uint32_t cluster) {
    ClusterPlan one = alike;
    one.clusters = {cluster, 1};
    return one;
}

/// Puts neighbouring clusters that are drawn alike into groups with a rectangle each.
class Groups {
  public:
    Groups(const BatchPlan& batch, const FillTask& task) : batch_(batch), task_(task) {}

    /// The next cluster, with its rectangle.
    void add(const ClusterPlan& next) {
        std::vector<SampledEdge> edges = sampledEdges(batch_, next, mostSamples);
        const double cost = task_.of(edges, batch_, next, *next.scissor);
        if (!tryJoin(next, edges, cost)) {
            groups_.push_back(next);
            edges_ = std::move(edges);
            cost_ = cost;
            open_ = true;
        }
    }
    /// Clusters that are drawn as they were.
    void addAsItIs(const ClusterPlan& next) {
        groups_.push_back(next);
        open_ = false;
    }
    std::vector<ClusterPlan> take() { return std::move(groups_); }

  private:
    bool tryJoin(const ClusterPlan& next, const std::vector<SampledEdge>& edges, double cost) {
        if (!open_) return false;
        ClusterPlan& last = groups_.back();
        const PixelRectangle both = united(*last.scissor, *next.scissor);
        ClusterPlan like = next;
        like.scissor = last.scissor;
        if (last.clusters.end() != next.clusters.first || !last.drawnLike(like)) return false;
        std::vector<SampledEdge> all = edges_;
        all.insert(all.end(), edges.begin(), edges.end());
        const double together = task_.of(all, batch_, last, both);
        if (together > cost_ + cost + task_.weights.draw) return false;
        ++last.clusters.count;
        last.scissor = both;
        edges_ = std::move(all);
        cost_ = together;
        if (edges_.size() > mostAsked) thinOut();
        return true;
    }

    /// Has every other edge stand for two.
    void thinOut() {
        std::vector<SampledEdge> some;
        for (std::size_t i = 0; i < edges_.size(); i += 2) {
            some.push_back(edges_[i]);
            some.back().weight *= 2.0;
        }
        edges_ = std::move(some);
    }

    const BatchPlan& batch_;
    const FillTask& task_;
    std::vector<ClusterPlan> groups_;
    bool open_ = false;              ///< whether the last group may grow
    std::vector<SampledEdge> edges_; ///< of it
    double cost_ = 0.0;              ///< likewise
};

/// Adds some to those left out; both are in order.
void addLeftOut(const std::vector<LeftOut>& some, std::vector<LeftOut>& all) {
    const auto middle = all.insert(all.end(), some.begin(), some.end());
    std::inplace_merge(all.begin(), middle, all.end(), [](const LeftOut& a, const LeftOut& b) {
        return a.clusters.first < b.clusters.first;
    });
}

void scissorBatch(BatchPlan& batch, const VisiblePoints& visible, const FillTask& task) {
    const ClusterScissors scissors(batch, visible);
    Groups groups(batch, task);
    std::vector<LeftOut> unseen;
    for (const ClusterPlan& alike : batch.volumes.drawn) {
        if (alike.start != 0) {
            groups.addAsItIs(alike);
            continue;
        }
        for (std::uint32_t c = alike.clusters.first; c < alike.clusters.end(); ++c) {
            ClusterPlan one = oneOf(alike, c);
            one.scissor = scissors.of(batch.shadow->clusters[c]);
            if (one.scissor->empty())
                leaveOut(unseen, c, LeftOut::Why::noReceiver);
            else
                groups.add(one);
        }
    }
    batch.volumes.drawn = groups.take();
    addLeftOut(unseen, batch.volumes.leftOut);
}

} // namespace

double estimatedFill(const CountPlan& plan, const FrameView& view, const DepthSlice& slice,
                     const PixelRectangle& reach, const FillWeights& weights) {
    const FillTask task(view, slice, weights);
    double cost = 0.0;
    for (const BatchPlan& batch : plan.batches) {
        if (!batch.silhouettes) continue;
        for (const ClusterPlan& alike : batch.volumes.drawn)
            for (std::uint32_t c = alike.clusters.first; c < alike.clusters.end(); ++c) {
                const ClusterPlan one = oneOf(alike, c);
                cost += task.of(sampledEdges(batch, one, mostSamples), batch, one, reach);
            }
    }
    return cost;
}

void scissorPlan(CountPlan& plan, const VisiblePoints& visible,
                 const std::vector<Material>& materials, const FrameView& view,
                 const DepthSlice& slice, const FillWeights& weights) {
    if (plan.fullyShadowed) return;
    const FillTask task(view, slice, weights);
    plan.draws = {};
    for (std::size_t i = 0; i < plan.batches.size(); ++i) {
        BatchPlan& batch = plan.batches[i];
        if (batch.silhouettes) scissorBatch(batch, visible, task);
        appendDraws(batch, i, materials, plan.draws);
    }
}

} // namespace edgeshade
