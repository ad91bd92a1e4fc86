#pragma once

#include "preprocess/scene/node_transform.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace edgeshade {

// Deforming meshes: skinned and morphing ones that an animation moves (glTF 2.0, 3.7.2.2, 3.7.3).
// Their triangles stay the same. poseBatch() computes their vertices and normals for every pose.
// Vertices that are moved by exactly the same data are therefore at the same place, to the last
// bit, in every pose.

/// A joint's influence on a vertex.
struct Influence {
    std::uint32_t joint = 0; ///< index in the skin
    float weight = 0.0f;     ///< a vertex's weights need not sum to 1, but never sum to 0

    bool operator==(const Influence&) const = default;
};

/// Sum of a vertex's weights.
inline double totalWeight(std::span<const Influence> influences) {
    double total = 0.0;
    for (const Influence& influence : influences)
        total += influence.weight;
    return total;
}

/// Influences of a mesh's vertices, vertex by vertex, joints ascending; empty if the mesh isn't
/// skinned.
struct Influences {
    std::vector<Influence> all;
    std::vector<std::uint32_t> firstOf; ///< by vertex, with the end appended

    bool empty() const { return firstOf.empty(); }
    std::span<const Influence> of(std::size_t vertex) const {
        return std::span(all).subspan(firstOf[vertex], firstOf[vertex + 1] - firstOf[vertex]);
    }
};

/// Displacement of vertices at weight 1 of a morph target; an empty array moves nothing.
struct MorphTarget {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec3> tangents;
};

/// A primitive's vertices as in the file; arrays are empty if it has none.
struct SourceMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents; ///< with the bitangent's sign in w
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
    std::size_t mesh = 0;            ///< index in Deformation::meshes
    glm::dmat4 batchFromMesh{1.0};   ///< unused if joints place it
    int node = -1;                   ///< the glTF node that has its morph weights
    std::vector<double> restWeights; ///< one per morph target
    std::uint32_t firstVertex = 0;   ///< in the batch
    /// For flat triangles, which have three vertices of their own each: the mesh's vertex for each
    /// of the batch's. Empty: the batch has the mesh's vertices one for one.
    std::vector<std::uint32_t> corners;
};

/// Everything that poses a batch.
struct Deformation {
    std::vector<SourceMesh> meshes;
    std::vector<Joint> joints; ///< of the skin, which all parts share or none has
    /// Place of a skinned mesh's node. Where it mirrors, the back of a triangle is its front (glTF
    /// 2.0, 3.7.4), whatever joints do. The nodes of all parts mirror at the same times.
    NodePlace place;
    std::vector<DeformedPart> parts;

    bool isSkinned() const { return !joints.empty(); }

    /// Calls use(batch vertex, part, vertex of the part's mesh) for every vertex.
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

/// One pose of a deforming batch.
struct BatchShape {
    std::vector<glm::dmat4> batchFromMesh;    ///< by joint
    std::vector<std::vector<double>> weights; ///< of morph targets, by part

    bool operator==(const BatchShape&) const = default;
};

} // namespace edgeshade
