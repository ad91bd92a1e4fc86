#pragma once

#include "preprocess/scene/node_transform.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace edgeshade {

// What deforms: skinned and morphing meshes that an animation moves (glTF 2.0, 3.7.2.2, 3.7.3).
// The triangles stay as they are; where their corners are, and their normals, is worked out for
// each pose, always by poseBatch(): vertices of which all that moves them is alike are then at the
// same place to the last bit, in whatever pose.

/// How much a vertex goes with a joint.
struct Influence {
    std::uint32_t joint = 0; ///< of the skin's
    float weight = 0.0f;     ///< a vertex's need not add up to 1, but don't add up to 0

    bool operator==(const Influence&) const = default;
};

/// What the weights of a vertex add up to.
inline double totalWeight(std::span<const Influence> influences) {
    double total = 0.0;
    for (const Influence& influence : influences)
        total += influence.weight;
    return total;
}

/// Influences of a mesh's vertices, vertex by vertex, joints ascending; no vertices: not skinned.
struct Influences {
    std::vector<Influence> all;
    std::vector<std::uint32_t> firstOf; ///< by vertex; one more than there are vertices

    bool empty() const { return firstOf.empty(); }
    std::span<const Influence> of(std::size_t vertex) const {
        return std::span(all).subspan(firstOf[vertex], firstOf[vertex + 1] - firstOf[vertex]);
    }
};

/// How far vertices go where a morph target has weight 1; empty arrays move nothing.
struct MorphTarget {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec3> tangents;
};

/// A primitive's vertices as the file has them. Arrays are empty where it has none.
struct SourceMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents; ///< with the bitangent's sign
    std::vector<MorphTarget> targets;
    Influences influences;
};

/// A joint of a skin.
struct Joint {
    NodePlace place;
    glm::dmat4 jointFromMesh{1.0}; ///< the inverse bind matrix
};

/// A mesh at one place in a batch.
struct DeformedPart {
    std::size_t mesh = 0;            ///< of Deformation::meshes
    glm::dmat4 batchFromMesh{1.0};   ///< not used where joints place it
    int node = -1;                   ///< the glTF node whose morph weights count
    std::vector<double> restWeights; ///< one a morph target
    std::uint32_t firstVertex = 0;   ///< of the batch
    /// Flat triangles, three vertices of their own each: which vertex of the mesh each one is.
    /// Empty: the mesh's vertices, one for one.
    std::vector<std::uint32_t> corners;
};

/// What poses a batch.
struct Deformation {
    std::vector<SourceMesh> meshes;
    std::vector<Joint> joints; ///< of the skin that all parts have, or none has
    /// Of the node of a skinned mesh: where it mirrors, the back of triangles is their front (glTF
    /// 2.0, 3.7.4), whatever joints do. Nodes of all parts do so at the same times.
    NodePlace place;
    std::vector<DeformedPart> parts;

    bool isSkinned() const { return !joints.empty(); }

    /// Calls use(batch vertex, part, vertex of the part's mesh) for all.
    template <class Use>
    void forEachVertex(Use use) const {
        for (const DeformedPart& part : parts) {
            const bool flat = !part.corners.empty();
            const std::size_t count =
                flat ? part.corners.size() : meshes[part.mesh].positions.size();
            for (std::uint32_t i = 0; i < count; ++i)
                use(part.firstVertex + i, part, flat ? part.corners[i] : i);
        }
    }
};

/// One pose of a batch that deforms.
struct BatchShape {
    std::vector<glm::dmat4> batchFromMesh;    ///< by joint
    std::vector<std::vector<double>> weights; ///< of morph targets, by part

    bool operator==(const BatchShape&) const = default;
};

} // namespace edgeshade
