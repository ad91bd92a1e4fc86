#include "preprocess/opposite_pairs.hpp"

#include "preprocess/components.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

using Planes = std::vector<glm::vec4>;

/// How much alike two planes are, flat ones most of all.
float likeness(const glm::vec4& p, const glm::vec4& q) {
    if (p == q) return 2.0f;
    return p.x * q.x + p.y * q.y + p.z * q.z;
}

/// Takes out of `forward` and `backward` the two that are most alike.
OppositePair takeMostAlike(Planes& forward, Planes& backward) {
    std::size_t bestI = 0, bestJ = 0;
    float best = -3.0f;
    for (std::size_t i = 0; i < forward.size(); ++i)
        for (std::size_t j = 0; j < backward.size(); ++j) {
            const float alike = likeness(forward[i], backward[j]);
            if (alike > best) {
                best = alike;
                bestI = i;
                bestJ = j;
            }
        }
    const OppositePair pair{forward[bestI], backward[bestJ]};
    forward.erase(forward.begin() + static_cast<std::ptrdiff_t>(bestI));
    backward.erase(backward.begin() + static_cast<std::ptrdiff_t>(bestJ));
    return pair;
}

} // namespace

void pairUp(const WeldedMesh& mesh, const EdgeList& edges, const Edge& edge,
            const std::vector<glm::vec4>& planes, std::vector<OppositePair>& pairs) {
    pairs.clear();
    // Nearly all edges are of one triangle, or of two that run opposite ways.
    const auto opposites = edges.oppositesOf(edge);
    const auto runsForward = [&](const Opposite& opposite) {
        return directionIn(mesh.triangles[opposite.triangle], edge) > 0;
    };
    if (opposites.size() <= 2) {
        const glm::vec4 &p = planes[opposites.front().triangle],
                        &q = planes[opposites.back().triangle];
        const bool first = runsForward(opposites.front());
        if (opposites.size() == 1)
            pairs.push_back({first ? p : -p, std::nullopt});
        else if (const bool second = runsForward(opposites.back()); first == second)
            pairs.push_back(first ? OppositePair{q, -p} : OppositePair{-q, p});
        else
            pairs.push_back(first ? OppositePair{p, q} : OppositePair{q, p});
        return;
    }
    Planes forward, backward; // by the way their triangles run through the edge
    for (const Opposite& opposite : opposites)
        (runsForward(opposite) ? forward : backward).push_back(planes[opposite.triangle]);
    // Searching the whole of a large fan for each pair would take the cube of its size.
    constexpr std::size_t largestSearch = 64;
    if (forward.size() > largestSearch || backward.size() > largestSearch)
        for (Planes* side : {&forward, &backward})
            std::sort(side->begin(), side->end(), [](const glm::vec4& p, const glm::vec4& q) {
                return std::lexicographical_compare(&p.x, &p.x + 4, &q.x, &q.x + 4);
            });
    while (!forward.empty() && !backward.empty()) {
        if (forward.size() > largestSearch || backward.size() > largestSearch) {
            pairs.push_back({forward.back(), backward.back()});
            forward.pop_back();
            backward.pop_back();
        } else {
            pairs.push_back(takeMostAlike(forward, backward));
        }
    }
    // What is left runs one way.
    for (; forward.size() > 1; forward.resize(forward.size() - 2))
        pairs.push_back({forward[forward.size() - 1], -forward[forward.size() - 2]});
    for (; backward.size() > 1; backward.resize(backward.size() - 2))
        pairs.push_back({-backward[backward.size() - 1], backward[backward.size() - 2]});
    if (!forward.empty()) pairs.push_back({forward.front(), std::nullopt});
    if (!backward.empty()) pairs.push_back({-backward.front(), std::nullopt});
}

} // namespace edgeshade
