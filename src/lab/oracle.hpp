#pragma once

#include "src/lab/light_set.hpp"
#include "src/rays/surface_set.hpp"
#include "src/rays/surface_triangles.hpp"
#include "src/shadow/lights/light.hpp"
#include "src/shadow/view/frustum.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade::lab {

using rays::SurfaceTriangle;

/// The oracle's answer for a pixel: no surface, or a surface and the lights that reach it.
struct Answer {
    bool surface = false;
    LightSet lit;

    bool operator==(const Answer&) const = default;
};

/// A question to the oracle: a scene, a view of it, lights, a picture size. `near`: surfaces nearer
/// along the viewing direction are invisible, but cast.
struct Question {
    const Scene* scene = nullptr;
    bool castMasked = false;
    Frustum frustum; ///< orthographic: must have everything visible in front of it, see
                     ///< standingBack()
    double near = 0.0;
    std::vector<Light> lights;
    int width = 1;
    int height = 1;
    bool cutoutsCast = false; ///< MASK surfaces cast where their alpha leaves them
};

/// The picture point at a pixel's centre, x and y in pixels. `pixel`: rows top to bottom.
inline glm::dvec2 centerOf(const Question& question, std::size_t pixel) {
    const auto width = static_cast<std::size_t>(question.width);
    return {static_cast<double>(pixel % width) + 0.5, static_cast<double>(pixel / width) + 0.5};
}

/// A line of sight, in world axes with the camera's position as origin.
struct PixelRay {
    glm::dvec3 origin;    ///< at depth 0: in perspective the camera itself
    glm::dvec3 direction; ///< its length makes the depth of at(t) equal to t

    glm::dvec3 at(double depth) const { return origin + depth * direction; }
};

/// The line of sight of a picture point, x and y in pixels (centres at +0.5, rows down).
PixelRay pixelRay(const Question& question, double x, double y);

/// Alpha of alpha-tested surfaces, from the owner of the textures.
struct AlphaLookup {
    /// Alpha at barycentric coordinates (u, v) of b and c.
    std::function<float(const SurfaceTriangle&, double u, double v)> at;

    /// The lowest and the highest alpha that a device's texture filter may produce at a pixel: GLES
    /// 2 leaves the choice of mipmap levels open (2.0.25, 3.7.7). `places`: the coordinates at the
    /// pixel's centre, one pixel to the right and one below. Null: use `at`.
    std::function<glm::vec2(const SurfaceTriangle&, const std::array<glm::dvec2, 3>& places)> range;

    /// Whether the alpha of the triangle's material leaves out the surface there.
    bool cutsOut(const std::vector<Material>& materials, const SurfaceTriangle& triangle, double u,
                 double v) const {
        const Material& material = materials[triangle.material];
        return material.alphaMode == AlphaMode::mask && at(triangle, u, v) < material.alphaCutoff;
    }
};

/// Decides what is lit by casting rays, as defined in docs/method.md, C30. Embree in robust mode
/// finds the candidates, double arithmetic decides. A surface never blocks itself, nor do triangles
/// exactly in its plane. A light doesn't light a surface whose visible side faces away from it, nor
/// one out of its range or its cone.
class Oracle {
  public:
    Oracle(const Question& question, const AlphaLookup& alpha);
    Oracle(const Oracle&) = delete;
    Oracle& operator=(const Oracle&) = delete;

    /// A surface on a ray.
    struct Hit {
        std::uint32_t triangle = 0;
        double depth = 0.0; ///< along the viewing direction
        double error = 0.0; ///< bound of the rounding error in `depth`
    };

    /// An answer, and whether rounding certainly did not change it.
    struct Checked {
        Answer answer;
        bool certain = true;
    };

    /// The answer at a picture point. Thread-safe, like all members.
    Answer at(double x, double y) const { return checkedAt(x, y).answer; }
    Checked checkedAt(double x, double y) const;

    /// The first visible surface on the ray of a picture point, of surfaces at one depth the first
    /// triangle; and whether rounding certainly did not change it. Null: the ray meets none.
    struct First {
        std::optional<Hit> hit;
        bool certain = true;
        bool certainPlaces = true; ///< the same, except where alpha decides
    };
    First firstAt(double x, double y) const;

    /// Indices, ascending, of all triangles that may be the first visible surface on the ray of a
    /// picture point, rounding included: candidates for a more exact judge.
    std::vector<std::uint32_t> firstCandidates(double x, double y) const;

    /// All visible surfaces on the ray of a picture point, as if none hid another.
    std::vector<Hit> surfacesAt(double x, double y) const;

    /// The answer for a point at `hit.depth` on the ray of a picture point, assumed to lie on the
    /// hit's triangle.
    Answer answerOn(const Hit& hit, double x, double y) const {
        return checkedOn(hit, x, y).answer;
    }

    /// Indices of all triangles that the ray from `origin` along `direction` may touch for t > 0 (t
    /// < 1 if `segment`), rounding included: candidates for a more exact judge.
    std::vector<std::uint32_t> candidates(const glm::dvec3& origin, const glm::dvec3& direction,
                                          bool segment) const;

    /// Whether no caster lies in a direction from a point, relative to the camera's position, at
    /// any distance. Ignores the `own` triangles, on which the point lies, and triangles in their
    /// planes.
    bool isOpen(const glm::dvec3& point, std::span<const std::uint32_t> own,
                const glm::dvec3& direction) const;

    /// The camera's position, in the world.
    const glm::dvec3& position() const { return position_; }
    const Question& question() const { return question_; }
    const std::vector<SurfaceTriangle>& triangles() const { return surfaces_->triangles; }
    /// The triangles, for other rays.
    const std::shared_ptr<const rays::SurfaceSet>& surfaces() const { return surfaces_; }
    bool isCutOut(const SurfaceTriangle& triangle, double u, double v) const;
    /// Whether light passes through the triangle at these coordinates.
    bool isHole(const SurfaceTriangle& triangle, double u, double v) const;

    /// The same where the line from `origin` meets the triangle.
    bool isHoleAt(std::uint32_t triangle, const glm::dvec3& origin,
                  const glm::dvec3& direction) const;

    /// Whether the texture filter may decide if the triangle is cut out at a picture point, at a
    /// depth of at most `depth`.
    bool isCutOutByFilter(const SurfaceTriangle& triangle, double x, double y, double depth) const;

    /// Whether a triangle blocks that light: it casts, and the light doesn't touch it
    /// (docs/method.md, C47).
    bool blocks(std::uint32_t triangle, std::size_t light) const;
    /// Whether the surface isn't lit because the light touches or grazes it.
    bool isGrazed(std::uint32_t triangle, std::size_t light) const;

    /// The light relative to the camera's position, homogeneous.
    glm::dvec4 lightFromEye(std::size_t light) const;
    /// Origin of lines of sight relative to the camera's position, homogeneous: Frustum::eye().
    const glm::dvec4& eye() const { return eye_; }
    /// The side of the triangle that the eye is on, by the order of its corners; the value is
    /// normalOf()'s length times a distance, or times a direction of length 1.
    double eyeSide(const SurfaceTriangle& triangle) const;
    /// The light's range; infinite for directional lights.
    double rangeOf(std::size_t light) const;
    /// The light's cone; null if it has none.
    const Cone* coneOf(std::size_t light) const;

  private:
    /// A visible triangle that a line of sight may meet: depth is infinite if it doesn't.
    struct Sighting {
        Hit hit;
        bool certain;      ///< whether it is met, certainly
        bool certainPlace; ///< the same, except where alpha decides
    };
    std::optional<Sighting> sightingOf(std::uint32_t triangle, const PixelRay& ray) const;
    Checked checkedOn(const Hit& hit, double x, double y) const;
    bool isBlocked(std::uint32_t own, const glm::dvec3& point, double pointError, std::size_t light,
                   bool& certain) const;
    void findTouched();

    /// A homogeneous point of the world, made relative to the camera's position.
    glm::dvec4 fromPosition(const glm::dvec4& point) const;

    Question question_;
    glm::dvec3 position_; ///< of the camera
    glm::dvec4 eye_;
    AlphaLookup alpha_;
    std::shared_ptr<const rays::SurfaceSet> surfaces_;
    std::vector<std::vector<glm::dvec4>> lightInBatch_; ///< by light and batch
    std::vector<std::vector<std::uint32_t>> touched_;   ///< by light, ascending
};

/// Answers at all pixel centres, rows top to bottom, on all cores.
std::vector<Answer> traceAll(const Oracle& oracle);

} // namespace edgeshade::lab
