#pragma once

#include "src/gl/instancing.hpp"
#include "src/gl/program.hpp"
#include "src/render/volumes/proposals.hpp"
#include "src/scene/adapted_buffers.hpp"
#include "src/scene/textures.hpp"
#include "src/shadow/plan/side_records.hpp"

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgeshade {

/// Variants of the programs for adapted records.
struct AdaptedSidesVariant {
    bool pair = false; ///< records of two planes
    bool sun = false;
    bool cap = false; ///< fans of caps in place of sides

    auto operator<=>(const AdaptedSidesVariant&) const = default;
};

/// The programs. `extraDefines` and `extraAttributes` are for tests and debug views.
gl::Program makeAdaptedSidesProgram(const AdaptedSidesVariant& variant,
                                    const std::vector<std::string>& extraDefines = {},
                                    const std::vector<std::string>& extraAttributes = {});
gl::Program makeAdaptedCapsProgram(bool nearDiscard, bool alphaTest,
                                   const std::vector<std::string>& extraDefines = {},
                                   const std::vector<std::string>& extraAttributes = {});

/// What debug views colour volumes with.
struct VolumeTints {
    glm::vec4 before; ///< sides counted once before surfaces (z-pass)
    glm::vec4 behind; ///< sides counted once behind them (z-fail)
    glm::vec4 twice;  ///< sides counted twice
    glm::vec4 caps;
};

/// Draws shadow volumes from adapted records; what they do to the stencil is the caller's state.
class AdaptedVolumes {
  public:
    /// `instancing` must be there unless the layout is notInstanced. `defines`: of sides' shaders.
    AdaptedVolumes(SidesLayout layout, std::optional<gl::Instancing> instancing,
                   std::vector<std::string> defines = {}, std::optional<VolumeTints> tints = {});

    /// Draws the sides that count so often. `proposed`: the records to draw, null for all of them.
    /// `end`: the plane at which volumes end, (0, 0, 0, 1) for infinity. All is in the batch's
    /// space.
    void drawSides(const AdaptedBuffers& buffers, const ProposedRecords* proposed,
                   const VolumeDraw& draw, Times times, const glm::vec4& end,
                   const glm::vec4& light, const glm::mat4& clipFromObject);
    /// Draws the fans of caps of such sides, where clusters take them.
    void drawFannedCaps(const AdaptedBuffers& buffers, const ProposedRecords* proposed,
                        const VolumeDraw& draw, Times times, const glm::vec4& light,
                        const glm::mat4& clipFromObject);
    /// Draws the other clusters' caps.
    void drawCaps(const AdaptedBuffers& buffers, const ProposedRecords* proposed,
                  const VolumeDraw& draw, const std::vector<Material>& materials,
                  const Textures& textures, const glm::vec4& light,
                  const glm::mat4& clipFromObject);

  private:
    enum class CapKind { front, back, both };

    /// The program, in use, with what all variants need.
    gl::Program& sidesProgram(const AdaptedSidesVariant& variant, const VolumeDraw& draw,
                              Times times, const glm::vec4& end, const glm::vec4& light,
                              const glm::mat4& clipFromObject);
    /// Records as quads or, of their first three corners, as triangles.
    void drawRecords(const AdaptedBuffers& buffers, const ProposedRecords* proposed,
                     const SideRecords& records, bool triangles);
    void drawGroup(const CapBuffers& buffers, bool copied, const RecordRange& caps, CapKind kind,
                   bool holes);
    gl::Program& capsProgram(bool nearDiscard, bool alphaTest);

    std::optional<gl::Instancing> instancing_;
    std::optional<VolumeTints> tints_;
    std::vector<std::string> sidesDefines_, capsDefines_;
    gl::Buffer quadCorners_;     ///< instanced: 0..3
    gl::Buffer capCorners_;      ///< instanced: 0..5
    gl::Buffer quadIndices_;     ///< of one quad; not instanced: of as many as 16 bits reach
    gl::Buffer triangleIndices_; ///< the same of their first triangles
    std::map<AdaptedSidesVariant, gl::Program> sides_;
    std::map<std::pair<bool, bool>, gl::Program> caps_;
};

} // namespace edgeshade
