#include "preprocess/volumes/opposite_pairs.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

using Planes = std::vector<glm::vec4>;
using Triangles = std::vector<std::uint32_t>;

/// How similar two planes are; equal ones rank highest.
float likeness(const glm::vec4& p, const glm::vec4& q) {
    if (p == q) return 2.0f;
    return p.x * q.x + p.y * q.y + p.z * q.z;
}

OppositePair opposite(std::uint32_t forward, std::uint32_t backward) {
    return {{forward, false}, PairedTriangle{backward, false}};
}

/// Removes the most similar pair from `forward` and `backward`.
OppositePair takeMostAlike(const Planes& planes, Triangles& forward, Triangles& backward) {
    std::size_t bestI = 0, bestJ = 0;
    float best = -3.0f;
    for (std::size_t i = 0; i < forward.size(); ++i)
        for (std::size_t j = 0; j < backward.size(); ++j) {
            const float alike = likeness(planes[forward[i]], planes[backward[j]]);
            if (alike > best) {
                best = alike;
                bestI = i;
                bestJ = j;
            }
        }
    const OppositePair pair = opposite(forward[bestI], backward[bestJ]);
    forward.erase(forward.begin() + static_cast<std::ptrdiff_t>(bestI));
    backward.erase(backward.begin() + static_cast<std::ptrdiff_t>(bestJ));
    return pair;
}

void sortByPlane(const Planes& planes, Triangles& triangles) {
    std::sort(triangles.begin(), triangles.end(), [&](std::uint32_t s, std::uint32_t t) {
        const glm::vec4 &p = planes[s], &q = planes[t];
        return std::lexicographical_compare(&p.x, &p.x + 4, &q.x, &q.x + 4);
    });
}

} // namespace

void pairUp(const EdgeList& edges, const Edge& edge, const Planes& planes,
            std::vector<OppositePair>& pairs) {
    pairs.clear();
    if (edge.oppositeCount <= 2) {
        pairs.push_back(onlyPair(edges, edge));
        return;
    }
    const auto opposites = edges.oppositesOf(edge);
    const auto runsForward = edges.forwardOf(edge);
    Triangles forward, backward; // by direction through the edge
    for (std::size_t i = 0; i < opposites.size(); ++i)
        (runsForward[i] ? forward : backward).push_back(opposites[i].triangle);
    // Searching all of a large fan for each pair would take time cubic in its size.
    constexpr std::size_t largestSearch = 64;
    if (forward.size() > largestSearch || backward.size() > largestSearch)
        for (Triangles* side : {&forward, &backward})
            sortByPlane(planes, *side);
    while (!forward.empty() && !backward.empty()) {
        if (forward.size() > largestSearch || backward.size() > largestSearch) {
            pairs.push_back(opposite(forward.back(), backward.back()));
            forward.pop_back();
            backward.pop_back();
        } else {
            pairs.push_back(takeMostAlike(planes, forward, backward));
        }
    }
    // The remaining triangles all run the same way.
    for (; forward.size() > 1; forward.resize(forward.size() - 2))
        pairs.push_back({{forward[forward.size() - 1], false},
                         PairedTriangle{forward[forward.size() - 2], true}});
    for (; backward.size() > 1; backward.resize(backward.size() - 2))
        pairs.push_back({{backward[backward.size() - 1], true},
                         PairedTriangle{backward[backward.size() - 2], false}});
    if (!forward.empty()) pairs.push_back({{forward.front(), false}, std::nullopt});
    if (!backward.empty()) pairs.push_back({{backward.front(), true}, std::nullopt});
}

} // namespace edgeshade
