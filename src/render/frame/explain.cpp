#include "src/render/frame/explain.hpp"

#include <sstream>

namespace edgeshade {
namespace {

/// "3 things", "1 thing".
std::string counted(std::size_t count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string clustersOf(const RecordRange& clusters) {
    return counted(clusters.count, "cluster") + " from " + std::to_string(clusters.first);
}

std::size_t trianglesOf(const AdaptedShadow& shadow, const RecordRange& clusters) {
    std::size_t triangles = 0;
    for (std::uint32_t c = clusters.first; c < clusters.end(); ++c)
        triangles += shadow.clusters[c].caps.count;
    return triangles;
}

const char* wordsFor(Counted counted) {
    switch (counted) {
    case Counted::lightFacing:
        return "light-facing triangles alone: closed, and around eye and light alike";
    case Counted::all:
        break;
    }
    return "all triangles: open, or eye, near plane or light may be within";
}

const char* wordsFor(CapsNeeded caps) {
    switch (caps) {
    case CapsNeeded::no:
        return "z-pass without caps";
    case CapsNeeded::holesAlone:
        return "z-pass with front caps in the holes of casters";
    case CapsNeeded::seenThrough:
        return "z-fail with caps: casters have holes";
    case CapsNeeded::nearPlaneMet:
        return "z-fail with caps: a triangle may cross the near plane";
    case CapsNeeded::outlineMet:
        return "z-fail with caps: a shadow's outline may run through the near rectangle";
    case CapsNeeded::uncertain:
        break;
    }
    return "z-fail with caps: what stands between near plane and light can't be told for certain";
}

const char* wordsFor(LeftOut::Why why) {
    switch (why) {
    case LeftOut::Why::outsideView:
        return "their volumes miss the view";
    case LeftOut::Why::tooDeep:
        return "their volumes begin behind all that is visible";
    case LeftOut::Why::tooFar:
        break;
    }
    return "they are out of the light's range";
}

} // namespace

std::string explain(const LightPlan& plan, const std::vector<PlacedShadow>& casters) {
    std::ostringstream text;
    text << "the count starts at " << plan.start() << "\n";
    for (std::size_t i = 0; i < plan.batches.size(); ++i) {
        const AdaptedShadow& shadow = *casters[i].shadow;
        text << "batch " << plan.batches[i].batch << ": "
             << counted(shadow.caps.size(), "casting triangle") << " in "
             << counted(shadow.clusters.size(), "cluster") << "\n";
        if (const auto& sealed = plan.batches[i].volumes.sealed) {
            text << "  cluster " << *sealed << " is closed, with eye and light on different sides: "
                 << "all that is visible is in its shadow, and no volumes are drawn\n";
            continue;
        }
        for (const VolumeDraw& draw : plan.batches[i].volumes.draws) {
            text << "  drawn: " << clustersOf(draw.clusters) << ", "
                 << counted(trianglesOf(shadow, draw.clusters), "triangle") << "; "
                 << wordsFor(draw.caps);
            if (draw.end >= 0) text << ", ending beyond what is visible";
            if (draw.start != 0)
                text << ", the near rectangle within " << counted(draw.start, "volume");
            if (draw.zFail())
                text << (draw.frontCaps ? "" : ", no front caps in view")
                     << (draw.backCaps ? "" : ", no back caps in view")
                     << (draw.nearDiscard ? ", cut where the near plane cuts" : "")
                     << (draw.fannedCaps ? ", as fans of silhouette edges where these are fewer"
                                         : "");
            text << "; " << wordsFor(draw.counted) << "\n";
        }
        for (const LeftOut& left : plan.batches[i].volumes.leftOut)
            text << "  left out: " << clustersOf(left.clusters) << ", "
                 << counted(trianglesOf(shadow, left.clusters), "triangle") << "; "
                 << wordsFor(left.why) << "\n";
    }
    return text.str();
}

} // namespace edgeshade
