#pragma once

#include "src/lab/eye_triangles.hpp"
#include "src/lab/light_set.hpp"
#include "src/shadow/lights/light.hpp"
#include "src/shadow/view/frustum.hpp"

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace edgeshade::lab {

/// What one pixel shows: nothing, or a surface and which lights reach it.
struct Answer {
    bool surface = false;
    LightSet lit;

    bool operator==(const Answer&) const = default;
};

/// What is judged: a scene, a view of it, lights, a picture size. `near`: surfaces nearer along the
/// viewing direction can't be seen, but cast.
struct Question {
    const Scene* scene = nullptr;
    bool castMasked = false;
    Frustum frustum; ///< orthographic: all that can be seen is before it, see standingBack()
    double near = 0.0;
    std::vector<Light> lights;
    int width = 1;
    int height = 1;
    bool cutoutsCast = false; ///< MASK surfaces cast what their alpha leaves
};

/// A line of sight, with world axes and the camera's position as origin.
struct PixelRay {
    glm::dvec3 origin;    ///< at depth 0: of a perspective the camera itself
    glm::dvec3 direction; ///< as long as makes the depth of at(t) t

    glm::dvec3 at(double depth) const { return origin + depth * direction; }
};

/// That of a picture point, x and y in pixels (centres at +0.5, rows down).
PixelRay pixelRay(const Question& question, double x, double y);

/// Alpha of alpha-tested surfaces, given by whoever has the textures.
struct AlphaLookup {
    /// At barycentric coordinates (u, v) of b and c.
    std::function<float(const EyeTriangle&, double u, double v)> at;

    /// The least and the most that a device's texture filter may make of it at a pixel: GLES 2
    /// leaves open how much smaller copies of a texture are taken (2.0.25, 3.7.7). `places`: the
    /// coordinates at the pixel's centre, one pixel to the right and one below. Null: what `at`
    /// says.
    std::function<glm::vec2(const EyeTriangle&, const std::array<glm::dvec2, 3>& places)> range;
};

/// Lit as in docs/method.md, C30, by casting rays: Embree in robust mode finds what a ray may
/// hit, double arithmetic decides. A surface never blocks itself, nor do triangles exactly in its
/// plane; one seen from the side turned away from a light is not lit by it, nor is what is out of
/// its range or its cone.
class Oracle {
  public:
    /// Throws Error(unavailable) where the program was built without Embree.
    Oracle(const Question& question, const AlphaLookup& alpha);
    ~Oracle();
    Oracle(const Oracle&) = delete;
    Oracle& operator=(const Oracle&) = delete;

    /// A surface on a ray.
    struct Hit {
        std::uint32_t triangle = 0;
        double depth = 0.0; ///< along the viewing direction
        double error = 0.0; ///< bound of the rounding in `depth`
    };

    /// An answer, and whether no rounding on the way to it can have changed it.
    struct Checked {
        Answer answer;
        bool certain = true;
    };

    /// The answer at a picture point. Thread-safe, as everything here is.
    Answer at(double x, double y) const { return checkedAt(x, y).answer; }
    Checked checkedAt(double x, double y) const;

    /// All surfaces that can be seen along the ray of a picture point if nothing is before them.
    std::vector<Hit> surfacesAt(double x, double y) const;

    /// The answer for a point at `hit.depth` on the ray of a picture point, taken to lie on the
    /// hit's triangle.
    Answer answerOn(const Hit& hit, double x, double y) const {
        return checkedOn(hit, x, y).answer;
    }

    /// Indices of all triangles that the ray from `origin` along `direction` may touch for
    /// t > 0 (t < 1 if `segment`), rounding allowed for: candidates for a more exact judge.
    std::vector<std::uint32_t> candidates(const glm::dvec3& origin, const glm::dvec3& direction,
                                          bool segment) const;

    /// Whether no caster lies in a direction from the camera's position, however far; `own`
    /// triangles, on which that is, and what lies in their planes do not count.
    bool isOpen(std::span<const std::uint32_t> own, const glm::dvec3& direction) const;

    const Question& question() const { return question_; }
    const std::vector<EyeTriangle>& triangles() const { return triangles_; }
    bool isCutOut(const EyeTriangle& triangle, double u, double v) const;
    /// Whether light passes the triangle there.
    bool isHole(const EyeTriangle& triangle, double u, double v) const;

    /// Whether a texture filter may decide if the triangle is cut out at a picture point, which is
    /// at `depth` at the farthest.
    bool isCutOutByFilter(const EyeTriangle& triangle, double x, double y, double depth) const;

    /// Whether a triangle blocks that light: it casts, and the light doesn't touch it
    /// (docs/method.md, C47).
    bool blocks(std::uint32_t triangle, std::size_t light) const;
    /// Whether the light doesn't light that surface because it touches or grazes it.
    bool isGrazed(std::uint32_t triangle, std::size_t light) const;

    /// The light relative to the camera's position, homogeneous.
    glm::dvec4 lightFromEye(std::size_t light) const;
    /// Where lines of sight come from, likewise: Frustum::eye().
    const glm::dvec4& eye() const { return eye_; }
    /// Which side of the triangle that is on, by the order of its corners; as large as normalOf()
    /// times a distance, or a direction of length 1.
    double eyeSide(const EyeTriangle& triangle) const;
    /// Its range; infinite for directional lights.
    double rangeOf(std::size_t light) const;
    /// Its cone; null where it has none.
    const Cone* coneOf(std::size_t light) const;

  private:
    struct Tree; ///< Embree's

    void visitSurfaces(const PixelRay& ray,
                       const std::function<void(const Hit&, bool certain)>& visit) const;
    Checked checkedOn(const Hit& hit, double x, double y) const;
    bool isBlocked(std::uint32_t own, const glm::dvec3& point, double pointError, std::size_t light,
                   bool& certain) const;
    void findTouched();

    /// A homogeneous point of the world relative to the camera's position.
    glm::dvec4 fromPosition(const glm::dvec4& point) const;

    Question question_;
    glm::dvec3 position_; ///< the camera's
    glm::dvec4 eye_;
    AlphaLookup alpha_;
    std::vector<EyeTriangle> triangles_;
    std::unique_ptr<Tree> tree_;
    std::vector<std::vector<glm::dvec4>> lightInBatch_; ///< by light and batch
    std::vector<std::vector<std::uint32_t>> touched_;   ///< by light, ascending
};

/// Answers at all pixel centres, rows top to bottom, on all cores. `progress` is called with the
/// share done, from one thread.
std::vector<Answer> traceAll(const Oracle& oracle, const std::function<void(double)>& progress);

} // namespace edgeshade::lab
