#pragma once

#include "preprocess/scene/section.hpp"
#include "src/viewer/orbit.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeshade::viewer {

// Sizes of a plane's handle in window pixels.
inline constexpr double sectionDisc = 22.0;  ///< radius of its disc
inline constexpr double sectionArrow = 52.0; ///< length of its arrow, seen from the side
inline constexpr double sectionReach = 24.0; ///< farthest grab from its middle or its arrow: a
                                             ///< finger's width

/// The handle of one of a section's planes.
struct SectionHandle {
    glm::dvec3 place;  ///< on the plane, in the world
    glm::dvec3 normal; ///< unit length, towards the part that stays
};

/// One handle for each plane. Each lies next to the middle of the part of `whole` that stays.
std::vector<SectionHandle> sectionHandles(const Section& section, const Box& whole);

/// The tip of a handle's arrow in the world; `scale`: picture pixels per window pixel.
glm::dvec3 arrowTip(const SectionHandle& handle, const PictureView& view, double scale);

/// The plane whose handle is within reach of the pixel, and nearest; `scale` as above.
std::optional<std::size_t> sectionPlaneAt(const std::vector<SectionHandle>& handles,
                                          const glm::dvec2& pixel, const PictureView& view,
                                          double scale);

/// Corners of the polygon in which a plane meets a box, in order; fewer than 3: they don't meet.
std::vector<glm::dvec3> planeInBox(const glm::dvec4& plane, const Box& box);

/// Moves a plane along its normal with the pointer that holds its handle.
class SectionDrag {
  public:
    /// `pixel`: the place where the pointer grabbed it. `whole`: bounds of the uncut scene, which
    /// the plane doesn't leave by dragging.
    SectionDrag(std::size_t plane, const Section& section, const Box& whole,
                const PictureView& view, const glm::dvec2& pixel);

    /// The section with the plane at the pointer. A plane that faces the eye goes away from it as
    /// the pointer goes up.
    Section movedTo(const glm::dvec2& pixel, const Section& section, const PictureView& view) const;

  private:
    /// How far along the normal the pointer is.
    double along(const glm::dvec2& pixel, const PictureView& view) const;

    std::size_t plane_;
    glm::dvec4 start_;
    SectionHandle handle_;
    bool facing_;         ///< the normal points nearly along the view
    double held_ = 0.0;   ///< along() at the start
    double least_, most_; ///< of the way along the normal
};

/// A plane along an axis through the middle, which keeps the part away from the eye; null if the
/// section is one plane along that axis already.
std::optional<Section> sectionAlong(glm::length_t axis, const std::optional<Section>& section,
                                    const Box& whole, const glm::dvec3& eye);

/// A plane through the middle that faces the eye; null if the section is that plane.
std::optional<Section> sectionFacing(const std::optional<Section>& section, const Box& whole,
                                     const glm::dvec3& forward);

/// A box somewhat smaller than the scene; null if the section is a box.
std::optional<Section> sectionBoxOf(const std::optional<Section>& section, const Box& whole);

/// Keeps the other side of a section's only plane. Several planes stay: their other sides together
/// keep nothing of a box.
std::optional<Section> sectionFlipped(const std::optional<Section>& section);

/// Another meaning of shadows for the part that is cut away.
std::optional<Section> sectionWithOtherShadows(const std::optional<Section>& section);

} // namespace edgeshade::viewer
