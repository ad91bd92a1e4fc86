#include "src/rays/box_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace edgeshade::rays {

/// A box, and the items or the two boxes in it.
struct PlainBoxNode {
    std::array<float, 3> low{}, high{};
    std::uint32_t first = 0; ///< item, or the first of two nodes
    std::uint16_t count = 0; ///< of items; 0: two nodes
    std::uint16_t axis = 0;  ///< along which the second node is farther
};

namespace {

using Node = PlainBoxNode;

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Components of a direction below this count as this: a ray of the tree's size moves by less than
/// any rounding.
constexpr float leastDirection = 1e-18f;
/// Depth from which on nodes are halved by number alone: 2^32 items make 32 levels more.
constexpr int deepestByArea = 32;
/// Nodes that wait at once: one for each level.
constexpr std::size_t mostWaiting = 2 * deepestByArea + 8;
constexpr std::size_t bins = 16;
/// Items that a leaf may have.
constexpr std::size_t leafSize = 2;

struct Item {
    BoxTree::FloatBox box;
    glm::vec3 middle; ///< twice
    std::uint32_t item;
};

BoxTree::FloatBox emptyBox() {
    return {glm::vec3(infinity), glm::vec3(-infinity)};
}

void grow(BoxTree::FloatBox& box, const BoxTree::FloatBox& by) {
    box.low = glm::min(box.low, by.low);
    box.high = glm::max(box.high, by.high);
}

/// Half of a box's surface; 0 if it is empty.
float areaOf(const BoxTree::FloatBox& box) {
    if (box.low.x > box.high.x) return 0.0f;
    const glm::vec3 size = box.high - box.low;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// Divides items along their longest extent where the boxes of both sides cost least (Wald 2007);
/// items.size(): their middles coincide.
std::size_t divided(std::span<Item> items, glm::length_t& axis) {
    glm::vec3 low(infinity), high(-infinity);
    for (const Item& item : items) {
        low = glm::min(low, item.middle);
        high = glm::max(high, item.middle);
    }
    const glm::vec3 size = high - low;
    axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    if (!(size[axis] > 0.0f)) return items.size();
    const float perBin = static_cast<float>(bins) / size[axis];
    const auto binOf = [&](const Item& item) {
        return std::min(static_cast<std::size_t>((item.middle[axis] - low[axis]) * perBin),
                        bins - 1);
    };
    std::array<BoxTree::FloatBox, bins> boxes;
    boxes.fill(emptyBox());
    std::array<std::size_t, bins> counts{};
    for (const Item& item : items) {
        const std::size_t bin = binOf(item);
        grow(boxes[bin], item.box);
        ++counts[bin];
    }
    std::array<float, bins> costAbove{};
    BoxTree::FloatBox box = emptyBox();
    std::size_t count = 0;
    for (std::size_t bin = bins; bin-- > 1;) {
        grow(box, boxes[bin]);
        count += counts[bin];
        costAbove[bin] = areaOf(box) * static_cast<float>(count);
    }
    box = emptyBox();
    count = 0;
    std::size_t best = 0;
    float least = infinity;
    for (std::size_t bin = 1; bin < bins; ++bin) {
        grow(box, boxes[bin - 1]);
        count += counts[bin - 1];
        const float cost = areaOf(box) * static_cast<float>(count) + costAbove[bin];
        if (count > 0 && count < items.size() && cost < least) {
            least = cost;
            best = bin;
        }
    }
    if (best == 0) return items.size();
    const auto end = std::partition(items.begin(), items.end(),
                                    [&](const Item& item) { return binOf(item) < best; });
    return static_cast<std::size_t>(end - items.begin());
}

/// Builds a node of items, which are those from `firstItem` on.
void build(std::vector<Node>& nodes, std::uint32_t node, std::span<Item> items,
           std::uint32_t firstItem, int depth) {
    BoxTree::FloatBox all = emptyBox();
    for (const Item& item : items)
        grow(all, item.box);
    nodes[node].low = {all.low.x, all.low.y, all.low.z};
    nodes[node].high = {all.high.x, all.high.y, all.high.z};
    if (items.size() <= leafSize) {
        nodes[node].first = firstItem;
        nodes[node].count = static_cast<std::uint16_t>(items.size());
        return;
    }
    glm::length_t axis = 0;
    std::size_t half = depth < deepestByArea ? divided(items, axis) : items.size();
    if (half == items.size()) half /= 2;
    const auto first = static_cast<std::uint32_t>(nodes.size());
    nodes.resize(nodes.size() + 2);
    nodes[node].first = first;
    nodes[node].axis = static_cast<std::uint16_t>(axis);
    build(nodes, first, items.first(half), firstItem, depth + 1);
    build(nodes, first + 1, items.subspan(half), firstItem + static_cast<std::uint32_t>(half),
          depth + 1);
}

/// A direction's reciprocals, and the planes of boxes that its rays meet first.
struct Slabs {
    std::array<float, 3> reciprocal;
    std::array<bool, 3> down;

    explicit Slabs(const glm::vec3& direction) {
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            const float d = direction[axis];
            reciprocal[i] =
                1.0f / (std::abs(d) < leastDirection ? std::copysign(leastDirection, d) : d);
            down[i] = std::signbit(d);
        }
    }
    float near(const Node& node, std::size_t axis) const {
        return down[axis] ? node.high[axis] : node.low[axis];
    }
    float far(const Node& node, std::size_t axis) const {
        return down[axis] ? node.low[axis] : node.high[axis];
    }
};

/// One ray's test of boxes.
class RayTest {
  public:
    explicit RayTest(const BoxTree::Ray& ray)
        : slabs(ray.along), end(ray.end), start_{ray.start.x, ray.start.y, ray.start.z} {}

    bool meets(const Node& node) const {
        float enters = 0.0f, leaves = end;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            enters =
                std::max(enters, (slabs.near(node, axis) - start_[axis]) * slabs.reciprocal[axis]);
            leaves =
                std::min(leaves, (slabs.far(node, axis) - start_[axis]) * slabs.reciprocal[axis]);
        }
        return enters <= leaves;
    }

    const Slabs slabs;
    float end; ///< of the ray

  private:
    std::array<float, 3> start_;
};

/// A packet's test of boxes.
class PacketTest {
  public:
    PacketTest(const BoxTree::Origins& origins, const glm::vec3& direction, Lanes rays)
        : slabs(direction), origins_(origins) {
        end(static_cast<Lanes>(~rays));
    }

    /// Whether a ray that still searches meets the box.
    bool meets(const Node& node) const {
        const auto [rx, ry, rz] = slabs.reciprocal;
        const float x0 = slabs.near(node, 0), y0 = slabs.near(node, 1), z0 = slabs.near(node, 2),
                    x1 = slabs.far(node, 0), y1 = slabs.far(node, 1), z1 = slabs.far(node, 2);
        float room[packetSize];
        for (std::size_t i = 0; i < packetSize; ++i) {
            const float ex = (x0 - origins_.x[i]) * rx, ey = (y0 - origins_.y[i]) * ry,
                        ez = (z0 - origins_.z[i]) * rz, lx = (x1 - origins_.x[i]) * rx,
                        ly = (y1 - origins_.y[i]) * ry, lz = (z1 - origins_.z[i]) * rz;
            const float exy = ex > ey ? ex : ey, ez0 = ez > 0.0f ? ez : 0.0f,
                        lxy = lx < ly ? lx : ly;
            room[i] = (lxy < lz ? lxy : lz) - (exy > ez0 ? exy : ez0) + over_[i];
        }
        float most = room[0];
        for (std::size_t i = 1; i < packetSize; ++i)
            most = room[i] > most ? room[i] : most;
        return most >= 0.0f;
    }

    /// Rays whose search is over.
    void end(Lanes rays) {
        for (std::size_t i = 0; i < packetSize; ++i)
            over_[i] = (rays >> i & 1) != 0 ? -infinity : 0.0f;
    }

    const Slabs slabs;

  private:
    const BoxTree::Origins& origins_;
    alignas(64) float over_[packetSize]; ///< 0, or -infinity: its search is over
};

} // namespace

struct BoxTree::Data {
    std::vector<Node> nodes;
    std::vector<std::uint32_t> items; ///< in the order of leaves

    /// Calls use(item) for items in boxes that the test meets, near ones first, until it returns
    /// true.
    template <class Test, class Use>
    void search(const Test& test, const Use& use) const {
        if (nodes.empty()) return;
        std::array<std::uint32_t, mostWaiting> waiting;
        std::size_t count = 0;
        waiting[count++] = 0;
        while (count > 0) {
            const Node& node = nodes[waiting[--count]];
            if (!test.meets(node)) continue;
            if (node.count == 0) {
                const std::uint32_t farther = test.slabs.down[node.axis] ? 0 : 1;
                waiting[count++] = node.first + farther;
                waiting[count++] = node.first + (1 - farther);
                continue;
            }
            for (std::uint32_t i = 0; i < node.count; ++i)
                if (use(items[node.first + i])) return;
        }
    }
};

BoxTree::BoxTree(std::vector<std::uint32_t> items,
                 const std::function<FloatBox(std::uint32_t)>& boxOf)
    : data_(std::make_unique<Data>()) {
    std::vector<Item> sorted;
    sorted.reserve(items.size());
    for (const std::uint32_t item : items) {
        const FloatBox box = boxOf(item);
        sorted.push_back({box, box.low + box.high, item});
    }
    if (!sorted.empty()) {
        data_->nodes.reserve(2 * sorted.size());
        data_->nodes.emplace_back();
        build(data_->nodes, 0, sorted, 0, 0);
    }
    for (std::size_t i = 0; i < sorted.size(); ++i)
        items[i] = sorted[i].item;
    data_->items = std::move(items);
}
BoxTree::~BoxTree() = default;
BoxTree::BoxTree(BoxTree&&) noexcept = default;
BoxTree& BoxTree::operator=(BoxTree&&) noexcept = default;

const std::vector<std::uint32_t>& BoxTree::items() const {
    return data_->items;
}

void BoxTree::visit(const Ray& ray, const std::function<bool(std::uint32_t)>& visit) const {
    data_->search(RayTest(ray), visit);
}

void BoxTree::visitInOrder(const Ray& ray, const std::function<float(std::uint32_t)>& visit) const {
    RayTest test(ray);
    data_->search(test, [&](std::uint32_t item) {
        test.end = std::min(test.end, visit(item));
        return false;
    });
}

void BoxTree::visitPacket(const Origins& origins, const glm::vec3& direction, Lanes rays, Test test,
                          void* state) const {
    PacketTest packet(origins, direction, rays);
    auto over = static_cast<Lanes>(~rays);
    data_->search(packet, [&](std::uint32_t item) {
        const Lanes now = test(state, item);
        if ((now & ~over) == 0) return false;
        over |= now;
        packet.end(over);
        return over == static_cast<Lanes>(~0u);
    });
}

} // namespace edgeshade::rays
