#include "preprocess/mesh/triangle_crossing.hpp"

#include "preprocess/base/box.hpp"

#include <algorithm>
#include <utility>

namespace edgeshade {
namespace {

/// A few rounding units of products of coordinates, relative.
constexpr double rounding = 1e-14;

/// Most tests per triangle of pairs whose boxes overlap; its neighbours are about six of them.
constexpr std::size_t pairsOfTriangle = 256;

bool overlap(const Box& one, const Box& other) {
    return glm::all(glm::lessThanEqual(one.low, other.high)) &&
           glm::all(glm::lessThanEqual(other.low, one.high));
}

Box boxAround(const TriangleCorners& corners) {
    Box box;
    for (const glm::dvec3& corner : corners)
        box.add(corner);
    return box;
}

/// The interval of a triangle along an axis.
std::pair<double, double> along(const glm::dvec3& axis, const TriangleCorners& corners,
                                const glm::dvec3& from) {
    const double a = glm::dot(axis, corners[0] - from), b = glm::dot(axis, corners[1] - from),
                 c = glm::dot(axis, corners[2] - from);
    return {std::min({a, b, c}), std::max({a, b, c})};
}

/// Whether two triangles share more than a contact: no plane separates them, where both may touch
/// it (separating axes, Gottschalk et al. 1996).
bool cross(const TriangleCorners& one, const TriangleCorners& other) {
    const glm::dvec3& from = one[0];
    double size = 0.0;
    for (const TriangleCorners* corners : {&one, &other})
        for (const glm::dvec3& corner : *corners)
            size = std::max(size, glm::length(corner - from));
    const auto parts = [&](const glm::dvec3& axis) {
        const double slack = rounding * size * glm::length(axis);
        const auto [low, high] = along(axis, one, from);
        const auto [otherLow, otherHigh] = along(axis, other, from);
        return high <= otherLow + slack || otherHigh <= low + slack;
    };
    const auto edge = [](const TriangleCorners& of, int i) { return of[(i + 1) % 3] - of[i]; };
    const glm::dvec3 normal = glm::cross(edge(one, 0), edge(one, 1)),
                     otherNormal = glm::cross(edge(other, 0), edge(other, 1));
    const auto [low, high] = along(normal, other, from);
    const double slack = rounding * size * glm::length(normal);
    const bool flat = low >= -slack && high <= slack;
    if (!flat) {
        if (parts(normal) || parts(otherNormal)) return false;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                if (const glm::dvec3 axis = glm::cross(edge(one, i), edge(other, j));
                    glm::dot(axis, axis) > 0.0 && parts(axis))
                    return false;
        return true;
    }
    for (int i = 0; i < 3; ++i)
        for (const TriangleCorners* corners : {&one, &other})
            if (parts(glm::cross(normal, edge(*corners, i)))) return false;
    return true;
}

/// A binary tree of triangles, split in halves, with boxes around them.
class CrossingSearch {
  public:
    explicit CrossingSearch(std::vector<TriangleCorners> triangles)
        : triangles_(std::move(triangles)), pairsLeft_(pairsOfTriangle * triangles_.size()) {
        boxes_.resize(4 * triangles_.size() + 4);
        fill(whole());
    }

    bool mayCross() { return crossWithin(whole()); }

  private:
    static constexpr std::size_t few = 4;
    struct Part {
        std::size_t number, first, end; ///< the root has number 1
        bool isLeaf() const { return end - first <= few; }
        Part half(bool second) const {
            const std::size_t middle = first + (end - first) / 2;
            return second ? Part{2 * number + 1, middle, end} : Part{2 * number, first, middle};
        }
    };

    Part whole() const { return {1, 0, triangles_.size()}; }

    void fill(const Part& part) {
        Box& box = boxes_[part.number];
        for (std::size_t i = part.first; i < part.end; ++i)
            for (const glm::dvec3& corner : triangles_[i])
                box.add(corner);
        if (part.isLeaf()) return;
        const Part second = part.half(true);
        const glm::dvec3 size = box.high - box.low;
        const glm::length_t axis = size.x >= size.y && size.x >= size.z ? 0
                                   : size.y >= size.z                   ? 1
                                                                        : 2;
        const auto place = [&](const TriangleCorners& of) {
            return of[0][axis] + of[1][axis] + of[2][axis];
        };
        const auto at = [&](std::size_t i) {
            return triangles_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(at(part.first), at(second.first), at(part.end),
                         [&](const TriangleCorners& one, const TriangleCorners& other) {
                             return place(one) < place(other);
                         });
        fill(part.half(false));
        fill(second);
    }

    /// Returns true also when the budget of pairs is spent.
    bool meet(std::size_t i, std::size_t j) {
        if (!overlap(boxAround(triangles_[i]), boxAround(triangles_[j]))) return false;
        if (pairsLeft_ == 0) return true;
        --pairsLeft_;
        return cross(triangles_[i], triangles_[j]);
    }

    bool crossWithin(const Part& part) {
        if (!part.isLeaf()) {
            const Part first = part.half(false), second = part.half(true);
            return crossWithin(first) || crossWithin(second) || crossBetween(first, second);
        }
        for (std::size_t i = part.first; i < part.end; ++i)
            for (std::size_t j = i + 1; j < part.end; ++j)
                if (meet(i, j)) return true;
        return false;
    }

    bool crossBetween(const Part& one, const Part& other) {
        if (!overlap(boxes_[one.number], boxes_[other.number])) return false;
        if (one.isLeaf() && other.isLeaf()) {
            for (std::size_t i = one.first; i < one.end; ++i)
                for (std::size_t j = other.first; j < other.end; ++j)
                    if (meet(i, j)) return true;
            return false;
        }
        const bool divideOne =
            !one.isLeaf() && (other.isLeaf() || one.end - one.first >= other.end - other.first);
        const Part& divided = divideOne ? one : other;
        const Part& kept = divideOne ? other : one;
        return crossBetween(divided.half(false), kept) || crossBetween(divided.half(true), kept);
    }

    std::vector<TriangleCorners> triangles_;
    std::vector<Box> boxes_; ///< by number
    std::size_t pairsLeft_;
};

} // namespace

bool mayCross(std::vector<TriangleCorners> triangles) {
    return CrossingSearch(std::move(triangles)).mayCross();
}

} // namespace edgeshade
