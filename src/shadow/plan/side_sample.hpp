#pragma once

#include "src/shadow/plan/batch_plan.hpp"

#include <vector>

namespace edgeshade {

/// A silhouette edge of a cluster, in its batch's space, that stands for some of them.
struct SampledEdge {
    glm::dvec3 a, b;
    double weight; ///< how many
};

/// At most so many silhouette edges of a cluster, evenly taken from those that may be some.
/// `draw`: of one cluster; the batch's silhouettes must be known.
std::vector<SampledEdge> sampledEdges(const BatchPlan& batch, const ClusterPlan& draw,
                                      std::uint32_t most);

} // namespace edgeshade
