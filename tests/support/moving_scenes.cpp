#include "tests/support/moving_scenes.hpp"

#include <cmath>
#include <numbers>

namespace edgeshade::test {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// A closed capsule with normals from one point to another, whose poles are single points.
Shape capsule(const glm::vec3& from, const glm::vec3& to, float radius, int sides, int rings) {
    const glm::vec3 along = glm::normalize(to - from);
    const glm::vec3 aside = glm::normalize(
        glm::cross(along, std::abs(along.x) < 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1)));
    const glm::vec3 across = glm::cross(along, aside);
    const float length = glm::distance(from, to);
    Shape shape;
    const auto add = [&](float polar, float shift, float angle) {
        const glm::vec3 out = std::cos(angle) * aside + std::sin(angle) * across;
        const glm::vec3 normal = std::sin(polar) * out - std::cos(polar) * along;
        shape.normals.push_back(normal);
        shape.positions.push_back(from + shift * along + radius * normal);
    };
    add(0.0f, 0.0f, 0.0f);
    for (int ring = 0; ring < rings; ++ring) {
        // A quarter of the rings at either end, the others between them.
        const float at = static_cast<float>(ring + 1) / static_cast<float>(rings + 1);
        const float polar = at < 0.25f   ? 2.0f * pi * at
                            : at > 0.75f ? 2.0f * pi * (at - 0.5f)
                                         : 0.5f * pi;
        const float shift = length * glm::clamp(2.0f * at - 0.5f, 0.0f, 1.0f);
        for (int side = 0; side < sides; ++side)
            add(polar, shift, 2.0f * pi * static_cast<float>(side) / static_cast<float>(sides));
    }
    add(pi, length, 0.0f);
    const auto count = static_cast<std::uint32_t>(sides);
    const auto last = static_cast<std::uint32_t>(shape.positions.size() - 1);
    for (std::uint32_t side = 0; side < count; ++side) {
        const std::uint32_t next = (side + 1) % count;
        shape.indices.insert(shape.indices.end(), {0, 1 + next, 1 + side});
        for (std::uint32_t ring = 0; ring + 1 < static_cast<std::uint32_t>(rings); ++ring) {
            const std::uint32_t a = 1 + ring * count + side, b = 1 + ring * count + next;
            shape.indices.insert(shape.indices.end(), {a, b, a + count, b, b + count, a + count});
        }
        shape.indices.insert(shape.indices.end(), {last, last - count + side, last - count + next});
    }
    return shape;
}

void addFloor(GltfBuilder& gltf) {
    const int stone =
        gltf.addMaterial({{"pbrMetallicRoughness",
                           {{"baseColorFactor", {0.7, 0.7, 0.72, 1}}, {"metallicFactor", 0}}}});
    gltf.addNode({{"mesh", gltf.addShape(box({4.0f, 0.1f, 4.0f}))}, {"translation", {0, -0.1, 0}}});
    gltf.addNode(
        {{"mesh", gltf.addShape(box({0.2f, 0.8f, 0.2f}))}, {"translation", {1.3, 0.8, -0.9}}});
    for (Json& mesh : gltf.json["meshes"])
        mesh["primitives"][0]["material"] = stone;
}

/// Adds channels to animations.
class Animator {
  public:
    Animator(GltfBuilder& gltf, const std::string& name) : gltf_(gltf) {
        gltf.json["animations"].push_back(
            {{"name", name}, {"channels", Json::array()}, {"samplers", Json::array()}});
    }

    void add(int node, const std::string& path, const std::vector<float>& times,
             const std::vector<float>& values, const std::string& interpolation) {
        const int components = path == "weights" ? 1 : path == "rotation" ? 4 : 3;
        Json& animation = gltf_.json["animations"].back();
        const int input =
            gltf_.addArray(times, 1, {{"min", {times.front()}}, {"max", {times.back()}}});
        animation["samplers"].push_back({{"input", input},
                                         {"output", gltf_.addArray(values, components)},
                                         {"interpolation", interpolation}});
        animation["channels"].push_back({{"sampler", animation["samplers"].size() - 1},
                                         {"target", {{"node", node}, {"path", path}}}});
    }

    /// Swings around an axis (0: x) by `degrees` either way, starting at `phase` (of a period).
    void swing(int node, int axis, float degrees, float phase, float seconds,
               const std::string& interpolation) {
        constexpr int keys = 8;
        std::vector<float> times, values;
        for (int key = 0; key <= keys; ++key) {
            const float at = static_cast<float>(key) / keys;
            const float turn = 2.0f * pi * (at + phase);
            times.push_back(at * seconds);
            const auto put = [&](float half, float scale) {
                glm::vec4 q(0.0f);
                q[axis] = scale * std::sin(half);
                q.w = scale == 1.0f ? std::cos(half) : 0.0f;
                values.insert(values.end(), {q.x, q.y, q.z, q.w});
            };
            const float half = 0.5f * glm::radians(degrees) * std::sin(turn);
            if (interpolation == "CUBICSPLINE") putTangent(values, axis, degrees, turn, seconds);
            put(half, 1.0f);
            if (interpolation == "CUBICSPLINE") putTangent(values, axis, degrees, turn, seconds);
        }
        add(node, "rotation", times, values, interpolation);
    }

  private:
    /// The derivative of the quaternion (sin h, cos h) with respect to time.
    static void putTangent(std::vector<float>& values, int axis, float degrees, float turn,
                           float seconds) {
        const float most = 0.5f * glm::radians(degrees);
        const float half = most * std::sin(turn);
        const float speed = most * std::cos(turn) * 2.0f * pi / seconds;
        glm::vec4 q(0.0f);
        q[axis] = std::cos(half) * speed;
        q.w = -std::sin(half) * speed;
        values.insert(values.end(), {q.x, q.y, q.z, q.w});
    }

    GltfBuilder& gltf_;
};

// The figure's joints.
enum Bone { hips, chest, head, armL, handL, armR, handR, legL, footL, legR, footR, boneCount };

struct BonePlace {
    int parent;
    glm::vec3 at; ///< in the world, in the bind pose
};

const BonePlace bones[boneCount] = {
    {-1, {0, 1.0f, 0}},         {hips, {0, 1.3f, 0}},      {chest, {0, 1.6f, 0}},
    {chest, {0.24f, 1.5f, 0}},  {armL, {0.55f, 1.5f, 0}},  {chest, {-0.24f, 1.5f, 0}},
    {armR, {-0.55f, 1.5f, 0}},  {hips, {0.12f, 0.95f, 0}}, {legL, {0.12f, 0.5f, 0}},
    {hips, {-0.12f, 0.95f, 0}}, {legR, {-0.12f, 0.5f, 0}}};

struct Limb {
    glm::vec3 from, to;
    float radius;
    Bone upper, lower;
};

const Limb limbs[] = {{{0, 1.0f, 0}, {0, 1.42f, 0}, 0.17f, hips, chest},
                      {{0, 1.66f, 0}, {0, 1.86f, 0}, 0.12f, chest, head},
                      {{0.26f, 1.5f, 0}, {0.85f, 1.5f, 0}, 0.06f, armL, handL},
                      {{-0.26f, 1.5f, 0}, {-0.85f, 1.5f, 0}, 0.06f, armR, handR},
                      {{0.12f, 0.92f, 0}, {0.12f, 0.1f, 0}, 0.09f, legL, footL},
                      {{-0.12f, 0.92f, 0}, {-0.12f, 0.1f, 0}, 0.09f, legR, footR}};

/// How much a point of a limb follows its lower bone.
float lowerShare(const Limb& limb, const glm::vec3& point) {
    const glm::vec3 along = glm::normalize(limb.to - limb.from);
    const float joint = glm::dot(bones[limb.lower].at - limb.from, along);
    const float at = glm::dot(point - limb.from, along);
    return glm::smoothstep(joint - 0.12f, joint + 0.12f, at);
}

int addFigureMesh(GltfBuilder& gltf, int sides, int rings) {
    Shape body;
    std::vector<std::uint8_t> joints;
    std::vector<float> weights;
    for (const Limb& limb : limbs) {
        const Shape part = capsule(limb.from, limb.to, limb.radius, sides, rings);
        const auto base = static_cast<std::uint32_t>(body.positions.size());
        for (std::size_t v = 0; v < part.positions.size(); ++v) {
            body.positions.push_back(part.positions[v]);
            body.normals.push_back(part.normals[v]);
            const float share = lowerShare(limb, part.positions[v]);
            joints.insert(joints.end(), {static_cast<std::uint8_t>(limb.upper),
                                         static_cast<std::uint8_t>(limb.lower), 0, 0});
            weights.insert(weights.end(), {1.0f - share, share, 0, 0});
        }
        for (const std::uint32_t index : part.indices)
            body.indices.push_back(base + index);
    }
    Json primitive = gltf.primitiveOf(body);
    primitive["attributes"]["JOINTS_0"] = gltf.addArray(joints, 4);
    primitive["attributes"]["WEIGHTS_0"] = gltf.addArray(weights, 4);
    primitive["material"] =
        gltf.addMaterial({{"pbrMetallicRoughness",
                           {{"baseColorFactor", {0.75, 0.32, 0.2, 1}}, {"metallicFactor", 0}}}});
    return gltf.addMesh(primitive);
}

} // namespace

GltfBuilder walkingFigure(int sides, int rings) {
    GltfBuilder gltf;
    addFloor(gltf);
    const int first = static_cast<int>(gltf.json["nodes"].size());
    std::vector<float> inverseBind;
    Json joints = Json::array();
    for (int bone = 0; bone < boneCount; ++bone) {
        const BonePlace& place = bones[bone];
        const glm::vec3 local = place.parent < 0 ? place.at : place.at - bones[place.parent].at;
        Json node = {{"translation", {local.x, local.y, local.z}}};
        for (int child = bone + 1; child < boneCount; ++child)
            if (bones[child].parent == bone) node["children"].push_back(first + child);
        joints.push_back(gltf.addNode(node, place.parent < 0));
        inverseBind.insert(inverseBind.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -place.at.x,
                                               -place.at.y, -place.at.z, 1});
    }
    gltf.json["skins"] = {
        {{"joints", joints}, {"inverseBindMatrices", gltf.addArray(inverseBind, 16)}}};
    gltf.addNode({{"mesh", addFigureMesh(gltf, sides, rings)}, {"skin", 0}});

    const auto node = [first](Bone bone) { return first + bone; };
    Animator walk(gltf, "walk");
    for (const auto& [bone, degrees, phase] :
         {std::tuple(legL, 35.0f, 0.0f), std::tuple(legR, 35.0f, 0.5f),
          std::tuple(footL, 30.0f, 0.25f), std::tuple(footR, 30.0f, 0.75f)})
        walk.swing(node(bone), 0, degrees, phase, 1.0f, "LINEAR");
    walk.swing(node(armL), 2, 60.0f, 0.6f, 1.0f, "LINEAR");
    walk.swing(node(armR), 2, 60.0f, 0.1f, 1.0f, "LINEAR");
    walk.swing(node(chest), 1, 15.0f, 0.0f, 1.0f, "LINEAR");
    walk.add(node(hips), "translation", {0, 0.5f, 1},
             {0,    0, 0, 0, 1.0f, 0,    0, 0.2f, 0,    0, 0, 0, 0, 1.06f,
              0.1f, 0, 0, 0, 0,    0.2f, 0, 0,    1.0f, 0, 0, 0, 0},
             "CUBICSPLINE");
    Animator wave(gltf, "wave");
    wave.swing(node(armL), 2, 80.0f, 0.0f, 2.0f, "CUBICSPLINE");
    wave.swing(node(handL), 1, 70.0f, 0.3f, 2.0f, "CUBICSPLINE");
    wave.swing(node(head), 2, 25.0f, 0.0f, 2.0f, "CUBICSPLINE");
    Animator jump(gltf, "jump");
    jump.add(node(hips), "translation", {0, 0.5f}, {0, 1.0f, 0, 0, 1.5f, 0}, "STEP");
    jump.swing(node(legL), 0, 50.0f, 0.0f, 1.0f, "STEP");
    return gltf;
}

GltfBuilder morphingBall(int sides, int rings) {
    GltfBuilder gltf;
    addFloor(gltf);
    const glm::vec3 center(0, 0.9f, 0);
    Shape ball = capsule(center - glm::vec3(0, 1e-3f, 0), center + glm::vec3(0, 1e-3f, 0), 0.6f,
                         sides, rings);
    std::vector<glm::vec3> spike, twist, insideOut, twistNormals;
    for (std::size_t v = 0; v < ball.positions.size(); ++v) {
        const glm::vec3 from = ball.positions[v] - center;
        spike.push_back(from * 2.0f * std::pow(glm::max(ball.normals[v].x, 0.0f), 6.0f));
        const float angle = 2.5f * from.y;
        const glm::vec3 turned(std::cos(angle) * from.x + std::sin(angle) * from.z, from.y * 1.2f,
                               std::cos(angle) * from.z - std::sin(angle) * from.x);
        twist.push_back(turned - from);
        const glm::vec3& n = ball.normals[v];
        twistNormals.push_back(glm::vec3(std::cos(angle) * n.x + std::sin(angle) * n.z, n.y,
                                         std::cos(angle) * n.z - std::sin(angle) * n.x) -
                               n);
        insideOut.push_back(-2.0f * from);
    }
    Json primitive = gltf.primitiveOf(ball);
    primitive["targets"] = {
        {{"POSITION", gltf.addVectors(spike)}},
        {{"POSITION", gltf.addVectors(twist)}, {"NORMAL", gltf.addVectors(twistNormals)}},
        {{"POSITION", gltf.addVectors(insideOut)}}};
    primitive["material"] =
        gltf.addMaterial({{"pbrMetallicRoughness",
                           {{"baseColorFactor", {0.2, 0.45, 0.7, 1}}, {"metallicFactor", 0}}}});
    const int ballMesh = gltf.addMesh(primitive);
    gltf.json["meshes"][ballMesh]["weights"] = {0, 0, 0};

    Shape flag; // open, with flat triangles, since it has no normals
    std::vector<glm::vec3> waved, rolled;
    constexpr std::uint32_t columns = 10, rows = 6;
    for (std::uint32_t y = 0; y <= rows; ++y)
        for (std::uint32_t x = 0; x <= columns; ++x) {
            const float along = 0.1f * static_cast<float>(x);
            flag.positions.emplace_back(-1.9f + along, 1.2f + 0.1f * static_cast<float>(y), -0.6f);
            waved.emplace_back(0.0f, 0.0f, 0.15f * std::sin(7.0f * along));
            rolled.emplace_back(0.3f * std::sin(4.0f * along) - along, 0.0f,
                                0.3f - 0.3f * std::cos(4.0f * along));
        }
    for (std::uint32_t y = 0; y < rows; ++y)
        for (std::uint32_t x = 0; x < columns; ++x) {
            const std::uint32_t i = (columns + 1) * y + x;
            flag.indices.insert(flag.indices.end(),
                                {i, i + 1, i + columns + 2, i, i + columns + 2, i + columns + 1});
        }
    Json cloth = gltf.primitiveOf(flag);
    cloth["targets"] = {{{"POSITION", gltf.addVectors(waved)}},
                        {{"POSITION", gltf.addVectors(rolled)}}};
    cloth["material"] = primitive["material"];
    const int ballNode = gltf.addNode({{"mesh", ballMesh}});
    const int flagNode = gltf.addNode(
        {{"mesh", gltf.addMesh(cloth)}, {"weights", {0.5, 0}}, {"scale", {1, 1, 1.2}}});

    Animator morph(gltf, "morph");
    morph.add(ballNode, "weights", {0, 0.5f, 1, 1.5f, 2},
              {0, 0, 0, 1, 0.3f, 0, 0.2f, 1, 0.5f, 0, 0.6f, 1.1f, 0, 0, 0}, "LINEAR");
    morph.add(flagNode, "weights", {0, 1, 2}, {-1, 0, 1, 1, -1, 0}, "LINEAR");
    Animator splines(gltf, "splines");
    splines.add(ballNode, "weights", {0, 2},
                {0, 0, 0, 0, 0, 0, 1, 3, -1, -1, 2, 0, 0.5f, 0.5f, 0.5f, 0, 0, 0}, "CUBICSPLINE");
    splines.add(flagNode, "weights", {0, 1}, {1, 0, 0, 1}, "STEP");
    return gltf;
}

} // namespace edgeshade::test
