#include "src/shadow/plan/end_choice.hpp"

#include "src/shadow/plan/side_fill.hpp"
#include "src/shadow/plan/side_sample.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace edgeshade {
namespace {

/// Silhouette edges that tell what a cluster's sides take: with 16 sums come out the same, and
/// planning takes three times as long.
constexpr std::uint32_t mostSamples = 4;

constexpr double impossible = std::numeric_limits<double>::infinity();

/// What the sides of a cluster take by each choice: at infinity first, then by plane.
using EndCosts = std::vector<double>;

EndCosts costsOf(const BatchPlan& batch, const ClusterPlan& draw, const PlanView& view,
                 const FillMeter& meter, const FillWeights& weights) {
    const Box& bounds = batch.shadow->clusters[draw.clusters.first].bounds;
    EndCosts costs(view.ends.size() + 1, 0.0);
    for (std::size_t end = 0; end < view.ends.size(); ++end)
        if (!mayEndAt(bounds, view, end)) costs[end + 1] = impossible;
    for (const SampledEdge& edge : sampledEdges(batch, draw, mostSamples))
        for (std::size_t choice = 0; choice < costs.size(); ++choice) {
            if (costs[choice] == impossible) continue;
            const glm::dvec4 end = choice == 0 ? glm::dvec4(0, 0, 0, 1) : view.ends[choice - 1];
            costs[choice] += edge.weight * weights.of(sideFill(meter, edge.a, edge.b,
                                                               glm::dvec4(batch.light), end));
        }
    return costs;
}

/// Chooses for neighbours that could be drawn together: the least sum of what their sides take and
/// of the draws that changes from one to the next cost.
void chooseFor(std::span<ClusterPlan> neighbours, const std::vector<EndCosts>& costs,
               double change) {
    const std::size_t choices = costs.front().size();
    // What it takes up to each neighbour, by its choice, and what the one before chose for that.
    std::vector<double> total = costs.front();
    std::vector<std::vector<std::size_t>> before;
    for (std::size_t i = 1; i < neighbours.size(); ++i) {
        const auto cheapest =
            static_cast<std::size_t>(std::min_element(total.begin(), total.end()) - total.begin());
        std::vector<double> next(choices);
        before.emplace_back(choices);
        for (std::size_t choice = 0; choice < choices; ++choice) {
            const bool stays = total[choice] <= total[cheapest] + change;
            before.back()[choice] = stays ? choice : cheapest;
            next[choice] = (stays ? total[choice] : total[cheapest] + change) + costs[i][choice];
        }
        total = std::move(next);
    }
    auto choice =
        static_cast<std::size_t>(std::min_element(total.begin(), total.end()) - total.begin());
    for (std::size_t i = neighbours.size(); i-- > 0;) {
        neighbours[i].end = static_cast<int>(choice) - 1;
        if (i > 0) choice = before[i - 1][choice];
    }
}

/// Whether nothing but their ends may have them drawn apart.
bool areAlikeButForEnds(ClusterPlan a, const ClusterPlan& b) {
    a.end = b.end;
    return a.clusters.end() == b.clusters.first && a.drawnLike(b);
}

} // namespace

void chooseEnds(BatchPlan& batch, const PlanView& view, VolumeEnds ends, const FillMeter& meter,
                const FillWeights& weights) {
    std::vector<ClusterPlan>& drawn = batch.volumes.drawn;
    if (ends == VolumeEnds::atInfinity)
        for (ClusterPlan& draw : drawn)
            draw.end = -1;
    if (ends != VolumeEnds::byCost || !batch.silhouettes) return;
    for (std::size_t first = 0; first < drawn.size();) {
        std::size_t end = first + 1;
        while (end < drawn.size() && areAlikeButForEnds(drawn[end - 1], drawn[end]))
            ++end;
        if (!drawn[first].zFail()) {
            std::vector<EndCosts> costs;
            for (std::size_t i = first; i < end; ++i)
                costs.push_back(costsOf(batch, drawn[i], view, meter, weights));
            chooseFor(std::span(drawn).subspan(first, end - first), costs, weights.draw);
        }
        first = end;
    }
}

} // namespace edgeshade
