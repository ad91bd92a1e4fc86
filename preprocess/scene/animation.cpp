#include "preprocess/scene/animation.hpp"

#include "preprocess/scene/posing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace edgeshade {
namespace {

/// A time's place between two keyframes.
struct Span {
    std::size_t before;
    std::size_t after; ///< equal to `before` outside the keyframes' range
    double fraction;   ///< 0 at `before`, 1 at `after`
    double seconds;    ///< between the two
};

Span spanAt(const std::vector<float>& times, double seconds) {
    const auto next = std::upper_bound(times.begin(), times.end(), seconds);
    const auto after = static_cast<std::size_t>(next - times.begin());
    if (after == 0) return {0, 0, 0.0, 0.0};
    if (after == times.size()) return {after - 1, after - 1, 0.0, 0.0};
    const double start = times[after - 1];
    const double length = times[after] - start;
    return {after - 1, after, (seconds - start) / length, length};
}

glm::dvec3 vectorAt(const std::vector<float>& values, std::size_t element) {
    const float* v = &values[3 * element];
    return {v[0], v[1], v[2]};
}

glm::dquat quaternionAt(const std::vector<float>& values, std::size_t element) {
    const float* v = &values[4 * element];
    return {v[3], v[0], v[1], v[2]}; // (w, x, y, z)
}

/// The spline between two keyframes, a Hermite cubic (glTF 2.0, C.5). `load` reads one element.
template <class Load>
auto splineAt(const std::vector<float>& values, const Span& span, Load load) {
    const double t = span.fraction, t2 = t * t, t3 = t2 * t;
    const auto value = load(values, 3 * span.before + 1);
    const auto outTangent = load(values, 3 * span.before + 2);
    const auto nextInTangent = load(values, 3 * span.after);
    const auto nextValue = load(values, 3 * span.after + 1);
    return value * (2.0 * t3 - 3.0 * t2 + 1.0) + outTangent * (span.seconds * (t3 - 2.0 * t2 + t)) +
           nextValue * (3.0 * t2 - 2.0 * t3) + nextInTangent * (span.seconds * (t3 - t2));
}

glm::dvec3 vectorAt(const Keyframes& keyframes, double seconds) {
    const Span span = spanAt(*keyframes.times, seconds);
    const std::vector<float>& values = *keyframes.values;
    switch (keyframes.interpolation) {
    case Interpolation::step:
        return vectorAt(values, span.before);
    case Interpolation::linear:
        return glm::mix(vectorAt(values, span.before), vectorAt(values, span.after), span.fraction);
    default:
        return splineAt(values, span, [](auto& all, std::size_t e) { return vectorAt(all, e); });
    }
}

/// Unit length; no rotation where a spline passes through zero.
glm::dquat rotationAt(const Keyframes& keyframes, double seconds) {
    const Span span = spanAt(*keyframes.times, seconds);
    const std::vector<float>& values = *keyframes.values;
    const auto unitAt = [&](std::size_t e) { return glm::normalize(quaternionAt(values, e)); };
    switch (keyframes.interpolation) {
    case Interpolation::step:
        return unitAt(span.before);
    case Interpolation::linear: // the shorter way round (C.4)
        return glm::normalize(glm::slerp(unitAt(span.before), unitAt(span.after), span.fraction));
    default:
        return glm::normalize(
            splineAt(values, span, [](auto& all, std::size_t e) { return quaternionAt(all, e); }));
    }
}

/// One value per morph target.
std::vector<double> weightsAt(const Keyframes& keyframes, std::size_t count, double seconds) {
    const Span span = spanAt(*keyframes.times, seconds);
    const std::vector<float>& values = *keyframes.values;
    std::vector<double> weights(count);
    for (std::size_t w = 0; w < count; ++w) {
        const auto load = [&](auto& all, std::size_t e) {
            return static_cast<double>(all[count * e + w]);
        };
        switch (keyframes.interpolation) {
        case Interpolation::step:
            weights[w] = load(values, span.before);
            break;
        case Interpolation::linear:
            weights[w] =
                glm::mix(load(values, span.before), load(values, span.after), span.fraction);
            break;
        default:
            weights[w] = splineAt(values, span, load);
        }
    }
    return weights;
}

bool fitsFloats(const glm::dmat4& matrix) {
    constexpr double most = std::numeric_limits<float>::max();
    for (glm::length_t c = 0; c < 4; ++c)
        for (glm::length_t r = 0; r < 4; ++r)
            if (!(std::abs(matrix[c][r]) <= most)) return false; // catches NaN too
    return true;
}

/// Whether the matrix flattens what it transforms, except for rounding: compares its determinant
/// with the largest possible for columns of these lengths.
bool flattens(const glm::dmat3& matrix) {
    constexpr double flatShare = 1e-14;
    const double most = glm::length(matrix[0]) * glm::length(matrix[1]) * glm::length(matrix[2]);
    return std::abs(glm::determinant(matrix)) <= flatShare * most;
}

/// Whether drawing in floats can use the matrix and its inverse.
bool isDrawable(const glm::dmat4& worldFromBatch) {
    return fitsFloats(worldFromBatch) && !flattens(glm::dmat3(worldFromBatch)) &&
           fitsFloats(glm::inverse(worldFromBatch));
}

/// A node's transform to the world.
struct WorldPlace {
    glm::dmat4 exact{1.0};
    glm::dmat4 unflattened{1.0}; ///< as if no node scaled by 0
};

/// World transforms of the animated nodes; key -1 is the world itself.
using WorldPlaces = std::map<int, WorldPlace>;

WorldPlaces placesAt(const Animation& animation, const Scene& scene, double seconds) {
    // Nodes come after those above them, so that each finds its parent.
    WorldPlaces worldFromAnimated = {{-1, WorldPlace()}};
    for (const AnimatedNode& animatedNode : scene.animatedNodes) {
        WorldPlace local{animatedNode.parentFromAnimated,
                         animatedNode.parentFromAnimatedUnflattened};
        if (const auto motion = animation.motions.find(animatedNode.node);
            motion != animation.motions.end()) {
            const NodeTransform moved = motion->second.at(seconds);
            const bool flatForGood = local.exact == local.unflattened && !motion->second.scale;
            local = {flatForGood ? moved.unflattened() : moved.matrix(), moved.unflattened()};
        }
        const WorldPlace& ancestor = worldFromAnimated.at(animatedNode.above);
        worldFromAnimated[animatedNode.node] = {
            ancestor.exact * animatedNode.aboveFromParent * local.exact,
            ancestor.unflattened * animatedNode.aboveFromParentUnflattened * local.unflattened};
    }
    return worldFromAnimated;
}

/// Null for static nodes, which keep their rest transform to the last bit.
std::optional<WorldPlace> worldFromNode(const NodePlace& place,
                                        const WorldPlaces& worldFromAnimated) {
    if (place.animatedNode < 0) return std::nullopt;
    const WorldPlace& ancestor = worldFromAnimated.at(place.animatedNode);
    return WorldPlace{ancestor.exact * place.animatedFromNode,
                      ancestor.unflattened * place.unflattened};
}

/// The transform of a skinned batch. Joints place its vertices in the world. If the mesh's node
/// mirrors, the transform mirrors too, which turns triangles over and leaves them in place.
glm::dmat4 worldFromSkinned(const Batch& batch, const WorldPlaces& places) {
    const NodePlace& place = batch.deformation->place;
    const glm::dmat3 worldFromMesh(places.at(place.animatedNode).exact * place.animatedFromNode);
    if (!(glm::determinant(worldFromMesh) < 0.0)) return batch.nodeFromBatch;
    return glm::scale(batch.nodeFromBatch, glm::dvec3(-1.0, 1.0, 1.0));
}

glm::dmat4 worldFromBatchAt(const Batch& batch, const WorldPlaces& places) {
    if (batch.node >= 0) return places.at(batch.node).exact * batch.nodeFromBatch;
    const bool skinned = batch.deforms() && batch.deformation->isSkinned();
    return skinned ? worldFromSkinned(batch, places) : batch.worldFromBatch;
}

BatchShape shapeAt(const Batch& batch, const Animation& animation, const WorldPlaces& places,
                   const glm::dmat4& worldFromBatch, double seconds) {
    BatchShape shape;
    if (!batch.deforms()) return shape;
    const glm::dmat4 batchFromWorld = glm::inverse(worldFromBatch);
    for (const Joint& joint : batch.deformation->joints)
        shape.batchFromMesh.push_back(batchFromWorld * places.at(joint.place.animatedNode).exact *
                                      joint.place.animatedFromNode * joint.jointFromMesh);
    for (const DeformedPart& part : batch.deformation->parts) {
        const auto weights = animation.weights.find(part.node);
        shape.weights.push_back(
            weights == animation.weights.end()
                ? part.restWeights
                : weightsAt(*weights->second, part.restWeights.size(), seconds));
    }
    return shape;
}

void move(SceneCamera& camera, const WorldPlace& place) {
    const auto origin = originOf(place.exact);
    const auto turn = turnOf(place.exact, place.unflattened);
    if (!origin || !turn) return;
    camera.worldFromCamera = glm::dmat4(*turn);
    camera.worldFromCamera[3] = glm::dvec4(*origin, 1.0);
}

void move(SceneLight& light, const WorldPlace& place) {
    const auto origin = originOf(place.exact);
    const auto forward = forwardOf(place.exact, place.unflattened);
    const bool needsTurn = light.kind != SceneLight::Kind::point;
    if (!origin || (needsTurn && !forward)) return;
    light.position = *origin;
    if (needsTurn) light.direction = *forward;
}

} // namespace

NodeTransform NodeMotion::at(double seconds) const {
    NodeTransform transform = rest;
    if (translation) transform.translation = vectorAt(*translation, seconds);
    if (rotation) transform.rotation = rotationAt(*rotation, seconds);
    if (scale) transform.scale = vectorAt(*scale, seconds);
    return transform;
}

Pose poseAt(const Animation& animation, const Scene& scene, double seconds) {
    const WorldPlaces places = placesAt(animation, scene, seconds);
    Pose pose{{}, {}, scene.cameras, scene.lights};
    for (const Batch& batch : scene.batches) {
        auto& worldFromBatch = pose.worldFromBatch.emplace_back(worldFromBatchAt(batch, places));
        pose.shapes.push_back(shapeAt(batch, animation, places, *worldFromBatch, seconds));
        if (batch.node >= 0 && !isDrawable(*worldFromBatch)) worldFromBatch.reset();
    }
    for (SceneCamera& camera : pose.cameras)
        if (const auto world = worldFromNode(camera.place, places)) move(camera, *world);
    for (SceneLight& light : pose.lights)
        if (const auto world = worldFromNode(light.place, places)) move(light, *world);
    return pose;
}

std::vector<Placed> place(Scene& scene, const Pose& pose) {
    scene.cameras = pose.cameras;
    scene.lights = pose.lights;
    std::vector<Placed> all;
    for (std::size_t b = 0; b < pose.worldFromBatch.size(); ++b) {
        Batch& batch = scene.batches[b];
        Placed& placed = all.emplace_back();
        placed.visible = pose.worldFromBatch[b].has_value();
        batch.hidden = !placed.visible;
        if (!placed.visible) continue;
        batch.worldFromBatch = *pose.worldFromBatch[b];
        if (!batch.deforms() || batch.shape == pose.shapes[b]) continue;
        placed.visible = placed.reshaped = poseBatch(batch, pose.shapes[b]);
        batch.hidden = !placed.visible;
    }
    return all;
}

} // namespace edgeshade
