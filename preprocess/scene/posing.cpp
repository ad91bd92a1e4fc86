#include "preprocess/scene/posing.hpp"

#include "preprocess/base/vectors.hpp"
#include "preprocess/scene/vertex_transform.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <unordered_map>

namespace edgeshade {
namespace {

// The compiler's vector type: SSE, NEON or WebAssembly's SIMD from one source.
using Doubles = double __attribute__((vector_size(2 * sizeof(double))));

/// The upper three rows of an affine matrix, column by column.
struct Rows {
    std::array<Doubles, 6> lanes{};

    Rows() = default;
    explicit Rows(const glm::dmat4& matrix) {
        std::array<double, 12> values{};
        for (glm::length_t i = 0; i < 12; ++i)
            values[static_cast<std::size_t>(i)] = matrix[i / 3][i % 3];
        std::memcpy(lanes.data(), values.data(), sizeof lanes);
    }

    void add(const Rows& other, double weight) {
        const Doubles weights = {weight, weight};
        for (std::size_t i = 0; i < lanes.size(); ++i)
            lanes[i] += weights * other.lanes[i];
    }

    glm::dmat4 matrix(double scale) const {
        std::array<double, 12> values{};
        std::memcpy(values.data(), lanes.data(), sizeof lanes);
        glm::dmat4 result(1.0);
        for (glm::length_t i = 0; i < 12; ++i)
            result[i / 3][i % 3] = scale * values[static_cast<std::size_t>(i)];
        return result;
    }
};

/// A vertex after morphing, in the mesh's space.
struct Morphed {
    glm::dvec3 position{0.0}, normal{0.0}, tangent{0.0};
};

/// Sums morph targets (glTF 2.0, 3.7.2.2).
class Morph {
  public:
    Morph(const SourceMesh& mesh, const std::vector<double>& weights) : mesh_(mesh) {
        for (std::size_t t = 0; t < mesh.targets.size() && t < weights.size(); ++t)
            if (weights[t] != 0.0) active_.emplace_back(weights[t], &mesh.targets[t]);
    }

    Morphed at(std::size_t vertex) const {
        Morphed morphed{glm::dvec3(mesh_.positions[vertex])};
        if (!mesh_.normals.empty()) morphed.normal = glm::dvec3(mesh_.normals[vertex]);
        if (!mesh_.tangents.empty()) morphed.tangent = glm::dvec3(mesh_.tangents[vertex]);
        for (const auto& [weight, target] : active_) {
            add(morphed.position, weight, target->positions, vertex);
            add(morphed.normal, weight, target->normals, vertex);
            add(morphed.tangent, weight, target->tangents, vertex);
        }
        return morphed;
    }

  private:
    static void add(glm::dvec3& value, double weight, const std::vector<glm::vec3>& deltas,
                    std::size_t vertex) {
        if (!deltas.empty()) value += weight * glm::dvec3(deltas[vertex]);
    }

    const SourceMesh& mesh_;
    std::vector<std::pair<double, const MorphTarget*>> active_;
};

/// Transforms a part's vertices to the batch's space.
class PartPoser {
  public:
    PartPoser(const Batch& batch, const BatchShape& shape, std::size_t part)
        : part_(batch.deformation->parts[part]), mesh_(batch.deformation->meshes[part_.mesh]),
          morph_(mesh_, shape.weights[part]) {
        if (!mesh_.influences.empty())
            for (const glm::dmat4& matrix : shape.batchFromMesh)
                joints_.emplace_back(matrix);
    }

    Morphed morphed(std::size_t vertex) const { return morph_.at(vertex); }

    glm::dmat4 matrixOf(std::size_t vertex) const {
        if (mesh_.influences.empty()) return part_.batchFromMesh;
        Rows sum;
        const auto influences = mesh_.influences.of(vertex);
        for (const Influence& influence : influences)
            sum.add(joints_[influence.joint], influence.weight);
        return sum.matrix(1.0 / totalWeight(influences));
    }

    const SourceMesh& mesh() const { return mesh_; }

  private:
    const DeformedPart& part_;
    const SourceMesh& mesh_;
    Morph morph_;
    std::vector<Rows> joints_;
};

/// A batch's posed vertices.
struct Posed {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents;
};

bool posePart(const Batch& batch, const BatchShape& shape, std::size_t index, Posed& posed) {
    const DeformedPart& part = batch.deformation->parts[index];
    const PartPoser poser(batch, shape, index);
    const SourceMesh& mesh = poser.mesh();
    const bool flat = !part.corners.empty();
    std::vector<glm::vec3> ofMesh(flat ? mesh.positions.size() : 0);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Morphed morphed = poser.morphed(v);
        const glm::dmat4 matrix = poser.matrixOf(v);
        const glm::vec3 position =
            glm::vec3(glm::dvec3(matrix * glm::dvec4(morphed.position, 1.0))) + 0.0f;
        if (!isFinite(glm::dvec3(position))) return false;
        if (flat) {
            ofMesh[v] = position;
            continue;
        }
        const std::size_t to = part.firstVertex + v;
        posed.positions[to] = position;
        posed.normals[to] = transformedNormal(glm::dmat3(matrix), morphed.normal);
        if (!mesh.tangents.empty())
            posed.tangents[to] =
                transformedTangent(glm::dmat3(matrix), morphed.tangent, mesh.tangents[v].w);
    }
    for (std::size_t i = 0; i < part.corners.size(); ++i)
        posed.positions[part.firstVertex + i] = ofMesh[part.corners[i]];
    for (std::size_t i = part.firstVertex; i < part.firstVertex + part.corners.size(); i += 3) {
        const glm::vec3* const at = &posed.positions[i];
        const glm::vec3 normal = faceNormal(at[0], at[1], at[2]);
        std::fill_n(posed.normals.begin() + static_cast<std::ptrdiff_t>(i), 3, normal);
    }
    return true;
}

/// Compares vertices by everything that moves them.
class Movement {
  public:
    explicit Movement(const Deformation& deformation) : deformation_(deformation) {}

    struct Vertex {
        const DeformedPart* part;
        std::uint32_t vertex;
    };

    /// Equal for vertices that move alike. It covers all that distinguishes others, so that no file
    /// can cause many collisions.
    std::uint64_t hashOf(const Vertex& of) const {
        const SourceMesh& mesh = meshOf(of);
        std::uint64_t hash = 0;
        const auto mix = [&hash](std::uint64_t bits) {
            hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 32;
        };
        const auto mixVector = [&mix](const glm::vec3& vector) {
            for (glm::length_t c = 0; c < 3; ++c)
                mix(glm::floatBitsToUint(vector[c] + 0.0f)); // -0 hashes as 0
        };
        mixVector(mesh.positions[of.vertex]);
        if (mesh.influences.empty())
            for (glm::length_t c = 0; c < 4; ++c)
                mixVector(glm::vec3(of.part->batchFromMesh[c]));
        else
            for (const Influence& influence : mesh.influences.of(of.vertex)) {
                mix(influence.joint);
                mix(glm::floatBitsToUint(influence.weight));
            }
        for (const MorphTarget& target : mesh.targets)
            mixVector(deltaOf(target, of.vertex));
        if (!mesh.targets.empty()) mix(static_cast<std::uint32_t>(of.part->node));
        return hash;
    }

    bool areAlike(const Vertex& a, const Vertex& b) const {
        const SourceMesh &meshA = meshOf(a), &meshB = meshOf(b);
        if (meshA.positions[a.vertex] != meshB.positions[b.vertex]) return false;
        if (meshA.influences.empty() != meshB.influences.empty()) return false;
        if (meshA.influences.empty()) {
            if (a.part->batchFromMesh != b.part->batchFromMesh) return false;
        } else {
            const auto ofA = meshA.influences.of(a.vertex), ofB = meshB.influences.of(b.vertex);
            if (!std::equal(ofA.begin(), ofA.end(), ofB.begin(), ofB.end())) return false;
        }
        return meshA.targets.size() == meshB.targets.size() &&
               (meshA.targets.empty() || (a.part->node == b.part->node && morphAlike(a, b)));
    }

  private:
    const SourceMesh& meshOf(const Vertex& of) const { return deformation_.meshes[of.part->mesh]; }

    static glm::vec3 deltaOf(const MorphTarget& target, std::uint32_t vertex) {
        return target.positions.empty() ? glm::vec3(0.0f) : target.positions[vertex];
    }

    bool morphAlike(const Vertex& a, const Vertex& b) const {
        const auto &ofA = meshOf(a).targets, &ofB = meshOf(b).targets;
        for (std::size_t t = 0; t < ofA.size(); ++t)
            if (deltaOf(ofA[t], a.vertex) != deltaOf(ofB[t], b.vertex)) return false;
        return true;
    }

    const Deformation& deformation_;
};

} // namespace

bool poseBatch(Batch& batch, const BatchShape& shape) {
    Posed posed{std::vector<glm::vec3>(batch.geometry->positions.size()),
                std::vector<glm::vec3>(batch.geometry->normals.size()),
                std::vector<glm::vec4>(batch.geometry->tangents.size())};
    for (std::size_t part = 0; part < batch.deformation->parts.size(); ++part)
        if (!posePart(batch, shape, part, posed)) return false;
    Geometry& geometry = batch.geometry.edit();
    geometry.positions = std::move(posed.positions);
    geometry.normals = std::move(posed.normals);
    geometry.tangents = std::move(posed.tangents);
    batch.shape = shape;
    return true;
}

std::vector<std::uint32_t> alikeVertices(const Batch& batch) {
    const Movement movement(*batch.deformation);
    std::vector<std::uint32_t> first(batch.geometry->positions.size());
    std::unordered_multimap<std::uint64_t, std::pair<Movement::Vertex, std::uint32_t>> known;
    known.reserve(first.size());
    batch.deformation->forEachVertex(
        [&](std::uint32_t vertex, const DeformedPart& part, std::uint32_t ofMesh) {
            const Movement::Vertex moved{&part, ofMesh};
            const std::uint64_t hash = movement.hashOf(moved);
            const auto [begin, end] = known.equal_range(hash);
            const auto found = std::find_if(begin, end, [&](const auto& entry) {
                return movement.areAlike(entry.second.first, moved);
            });
            first[vertex] = found != end ? found->second.second : vertex;
            if (found == end) known.emplace(hash, std::pair(moved, vertex));
        });
    return first;
}

} // namespace edgeshade
