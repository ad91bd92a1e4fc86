#include "src/viewer/section_tool.hpp"

#include "src/scene/section_text.hpp"
#include "src/viewer/section_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgeshade::viewer {
namespace {

constexpr double facingSine = 0.2; // of the angle between a normal and the view
constexpr double margin = 0.01;    // of the scene's size, beyond it
constexpr double boxShare = 0.4;   // of the scene's extents, on either side of its middle
constexpr double thinnest = 1e-3;  // of the scene's size: half the box of a flat scene

double signedDistance(const glm::dvec4& plane, const glm::dvec3& point) {
    return glm::dot(glm::dvec3(plane), point) + plane.w;
}

glm::dvec3 projected(const glm::dvec3& point, const glm::dvec4& plane) {
    const glm::dvec3 normal(plane);
    return point - normal * (signedDistance(plane, point) / glm::dot(normal, normal));
}

double sizeOf(const Box& box) {
    return box.diagonal() > 0.0 ? box.diagonal() : 1.0;
}

double distanceToSegment(const glm::dvec2& point, const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dvec2 way = to - from;
    const double squared = glm::dot(way, way);
    const double at =
        squared > 0.0 ? std::clamp(glm::dot(point - from, way) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(point, from + at * way);
}

/// The other settings stay as they were.
Section withPlanes(const std::optional<Section>& section, std::vector<glm::dvec4> planes) {
    Section made = section.value_or(Section{{}, SectionShadows::cut, defaultFill()});
    made.planes = std::move(planes);
    return made;
}

glm::dvec4 planeThrough(const glm::dvec3& point, const glm::dvec3& normal) {
    return glm::dvec4(normal, -glm::dot(normal, point));
}

bool isAlong(const glm::dvec4& plane, glm::length_t axis) {
    glm::dvec3 others(plane);
    others[axis] = 0.0;
    return others == glm::dvec3(0.0);
}

} // namespace

std::vector<SectionHandle> sectionHandles(const Section& section, const Box& whole) {
    glm::dvec3 inside = whole.center();
    for (const glm::dvec4& plane : section.planes)
        if (signedDistance(plane, inside) < 0.0) inside = projected(inside, plane);
    std::vector<SectionHandle> handles;
    for (const glm::dvec4& plane : section.planes)
        handles.push_back({projected(inside, plane), glm::normalize(glm::dvec3(plane))});
    return handles;
}

glm::dvec3 arrowTip(const SectionHandle& handle, const PictureView& view, double scale) {
    const double pixel = view.pixelAt(view.depthOf(handle.place));
    return handle.place + handle.normal * (sectionArrow * scale * pixel);
}

std::optional<std::size_t> sectionPlaneAt(const std::vector<SectionHandle>& handles,
                                          const glm::dvec2& pixel, const PictureView& view,
                                          double scale) {
    std::optional<std::size_t> nearest;
    double reach = sectionReach * scale;
    for (std::size_t i = 0; i < handles.size(); ++i) {
        if (view.depthOf(handles[i].place) <= 0.0) continue;
        const glm::dvec2 middle = view.pixelOf(handles[i].place);
        const glm::dvec3 tip = arrowTip(handles[i], view, scale);
        const glm::dvec2 end = view.depthOf(tip) > 0.0 ? view.pixelOf(tip) : middle;
        const double distance = distanceToSegment(pixel, middle, end);
        if (distance > reach) continue;
        reach = distance;
        nearest = i;
    }
    return nearest;
}

std::vector<glm::dvec3> planeInBox(const glm::dvec4& plane, const Box& box) {
    std::vector<glm::dvec3> corners;
    if (box.empty()) return corners;
    for (int from = 0; from < 8; ++from)
        for (const int bit : {1, 2, 4}) {
            if ((from & bit) != 0) continue;
            const glm::dvec3 a = box.corner(from), b = box.corner(from | bit);
            const double atA = signedDistance(plane, a), atB = signedDistance(plane, b);
            if ((atA < 0.0) == (atB < 0.0)) continue;
            corners.push_back(a + (b - a) * (atA / (atA - atB)));
        }
    if (corners.size() < 3) return {};
    glm::dvec3 middle(0.0);
    for (const glm::dvec3& corner : corners)
        middle += corner / static_cast<double>(corners.size());
    const glm::dvec3 normal = glm::normalize(glm::dvec3(plane));
    const glm::dvec3 right = corners.front() - middle, up = glm::cross(normal, right);
    const auto angle = [&](const glm::dvec3& corner) {
        return std::atan2(glm::dot(corner - middle, up), glm::dot(corner - middle, right));
    };
    std::sort(corners.begin(), corners.end(),
              [&](const glm::dvec3& a, const glm::dvec3& b) { return angle(a) < angle(b); });
    return corners;
}

SectionDrag::SectionDrag(std::size_t plane, const Section& section, const Box& whole,
                         const PictureView& view, const glm::dvec2& pixel)
    : plane_(plane), start_(section.planes[plane]), handle_(sectionHandles(section, whole)[plane]) {
    const glm::dvec3 sight = glm::normalize(handle_.place - view.camera.from);
    facing_ = glm::length(glm::cross(sight, handle_.normal)) < facingSine;
    held_ = along(pixel, view);
    least_ = 0.0;
    most_ = 0.0;
    if (whole.empty()) return;
    const double beyond = margin * sizeOf(whole);
    for (int i = 0; i < 8; ++i) {
        const double at = glm::dot(whole.corner(i) - handle_.place, handle_.normal);
        least_ = std::min(least_, at - beyond);
        most_ = std::max(most_, at + beyond);
    }
}

double SectionDrag::along(const glm::dvec2& pixel, const PictureView& view) const {
    if (facing_) {
        const double away = glm::dot(handle_.normal, view.forward()) < 0.0 ? -1.0 : 1.0;
        return -pixel.y * away * view.pixelAt(std::max(view.depthOf(handle_.place), 0.0));
    }
    // The point of the handle's axis that is nearest to the pointer's ray.
    const Ray ray = view.rayThrough(pixel);
    const glm::dvec3 from = ray.from - handle_.place;
    const double cosine = glm::dot(ray.direction, handle_.normal);
    const double sineSquared = std::max(1.0 - cosine * cosine, 0.25 * facingSine * facingSine);
    return (glm::dot(from, handle_.normal) - cosine * glm::dot(from, ray.direction)) / sineSquared;
}

Section SectionDrag::movedTo(const glm::dvec2& pixel, const Section& section,
                             const PictureView& view) const {
    Section moved = section;
    if (plane_ >= moved.planes.size()) return moved;
    const double way = std::clamp(along(pixel, view) - held_, least_, most_);
    const double w = start_.w - way * glm::length(glm::dvec3(start_));
    if (std::isfinite(w)) moved.planes[plane_] = glm::dvec4(glm::dvec3(start_), w);
    return moved;
}

std::optional<Section> sectionAlong(glm::length_t axis, const std::optional<Section>& section,
                                    const Box& whole, const glm::dvec3& eye) {
    if (section && section->planes.size() == 1 && isAlong(section->planes.front(), axis))
        return std::nullopt;
    const glm::dvec3 middle = whole.center();
    glm::dvec3 normal(0.0);
    normal[axis] = eye[axis] > middle[axis] ? -1.0 : 1.0;
    return withPlanes(section, {planeThrough(middle, normal)});
}

std::optional<Section> sectionFacing(const std::optional<Section>& section, const Box& whole,
                                     const glm::dvec3& forward) {
    const glm::dvec3 middle = whole.center();
    const std::vector<glm::dvec4> planes = {planeThrough(middle, forward)};
    if (section && section->planes == planes) return std::nullopt;
    return withPlanes(section, planes);
}

std::optional<Section> sectionBoxOf(const std::optional<Section>& section, const Box& whole) {
    if (section && section->planes.size() == 6) return std::nullopt;
    const glm::dvec3 middle = whole.center();
    const glm::dvec3 extent = whole.empty() ? glm::dvec3(0.0) : whole.high - whole.low;
    const glm::dvec3 half = boxShare * extent + thinnest * sizeOf(whole);
    return withPlanes(section, sectionBox(middle - half, middle + half));
}

std::optional<Section> sectionFlipped(const std::optional<Section>& section) {
    if (!section || section->planes.size() != 1) return section;
    return withPlanes(section, {-section->planes.front()});
}

std::optional<Section> sectionWithOtherShadows(const std::optional<Section>& section) {
    if (!section) return section;
    Section other = *section;
    other.shadows =
        section->shadows == SectionShadows::cut ? SectionShadows::whole : SectionShadows::cut;
    return other;
}

} // namespace edgeshade::viewer
