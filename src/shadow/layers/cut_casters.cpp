#include "src/shadow/layers/cut_casters.hpp"

#include "preprocess/mesh/topology.hpp"

#include <array>

namespace edgeshade {
namespace {

/// Cuts the triangles of one batch.
class BatchCut {
  public:
    BatchCut(const Batch& source, const glm::dvec4& plane)
        : batch_(source), geometry_(*source.geometry),
          plane_(glm::transpose(source.worldFromBatch) * plane) {
        geometry_.normals.clear(); // used only for drawing surfaces
        geometry_.indices.clear();
        geometry_.groups.clear();
        geometry_.simplifiedCasters.reset();
    }

    void beginGroup(std::size_t material) {
        geometry_.groups.push_back(
            {material, static_cast<std::uint32_t>(geometry_.indices.size()), 0});
    }

    /// Adds a triangle in one piece or three; calls added(inside) for each.
    template <class Added>
    void add(const std::array<std::uint32_t, 3>& corners, Added added) {
        std::array<bool, 3> inside{};
        for (std::size_t c = 0; c < 3; ++c)
            inside[c] = isInside(corners[c]);
        const auto emit = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, bool isInside) {
            geometry_.indices.insert(geometry_.indices.end(), {a, b, c});
            geometry_.groups.back().indexCount += 3;
            added(isInside);
        };
        if (inside[0] == inside[1] && inside[1] == inside[2])
            return emit(corners[0], corners[1], corners[2], inside[0]);
        // The corner that is alone on its side, then the others in order.
        std::size_t alone = 0;
        while (inside[alone] == inside[(alone + 1) % 3] || inside[alone] == inside[(alone + 2) % 3])
            ++alone;
        const std::uint32_t a = corners[alone], b = corners[(alone + 1) % 3],
                            c = corners[(alone + 2) % 3];
        const std::uint32_t ab = cutEdge(a, b), ca = cutEdge(c, a);
        emit(a, ab, ca, inside[alone]);
        emit(ab, b, c, !inside[alone]);
        emit(ab, c, ca, !inside[alone]);
    }

    Batch take() {
        batch_.geometry = CopyOnWrite(std::move(geometry_));
        return std::move(batch_);
    }

  private:
    double height(std::uint32_t vertex) const {
        return glm::dot(plane_, glm::dvec4(geometry_.positions[vertex], 1.0));
    }
    bool isInside(std::uint32_t vertex) const { return height(vertex) >= 0.0; }

    /// A new vertex where the plane cuts an edge, computed from the lower of its two positions
    /// first.
    std::uint32_t cutEdge(std::uint32_t a, std::uint32_t b) {
        if (orderedBefore(geometry_.positions[b], geometry_.positions[a])) std::swap(a, b);
        const double share = height(a) / (height(a) - height(b));
        const auto between = [&](auto& values) {
            if (values.empty()) return;
            using Value = typename std::remove_reference_t<decltype(values)>::value_type;
            const auto low = values[a], high = values[b];
            Value mixed;
            for (glm::length_t i = 0; i < Value::length(); ++i)
                mixed[i] = static_cast<float>(low[i] + share * (double{high[i]} - low[i]));
            values.push_back(mixed + Value(0.0f)); // no -0
        };
        between(geometry_.positions);
        between(geometry_.texcoords);
        between(geometry_.colors);
        return static_cast<std::uint32_t>(geometry_.positions.size() - 1);
    }

    Batch batch_;
    Geometry geometry_;
    glm::dvec4 plane_; ///< in the batch's space
};

} // namespace

CutCasters cutCasters(const Scene& scene, bool castMasked, const glm::dvec4& plane) {
    CutCasters cut;
    cut.scene.materials = scene.materials;
    std::uint32_t caster = 0;
    for (const Batch& batch : scene.batches) {
        const Casters casters = castersOf(batch, scene.materials, castMasked);
        BatchCut pieces(batch, plane);
        for (const SurfaceGroup& group : casters.groups) {
            pieces.beginGroup(group.material);
            for (std::uint32_t i = group.firstIndex; i < group.firstIndex + group.indexCount;
                 i += 3) {
                pieces.add({casters.indices[i], casters.indices[i + 1], casters.indices[i + 2]},
                           [&](bool inside) {
                               cut.from.push_back(caster);
                               cut.inside.push_back(inside);
                           });
                ++caster;
            }
        }
        cut.scene.batches.push_back(pieces.take());
    }
    return cut;
}

} // namespace edgeshade
