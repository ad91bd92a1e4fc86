#include "src/shadow/primitive_map/primitive_map_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#ifndef __EMSCRIPTEN__
#include <thread>
#endif

namespace edgeshade {
namespace {

/// Texels along the edge of a part, which is built in one go.
constexpr int partSide = 64;

/// Pieces along each axis into which squares are divided, if allowed.
constexpr int pieces = 4;

/// Pieces are kept if their lists' mean length is at most this share of the whole's.
constexpr double worthDividing = 0.75;

/// Limit of tests of a footprint against a square (about 20 ns each): a base, and an addition for
/// each footprint.
constexpr std::size_t mostLooks = std::size_t{1} << 30, looksEach = 1000;

/// Most parts in which to look for long lists before building, those with the most casters.
constexpr std::size_t mostCrowdedParts = 4;

/// Added to the name of a list or a triangle: light-facing casters need no later entries.
constexpr float endsHere = 0.5f;

/// Rounds up, so that no depth before it counts as behind.
float roundedUp(double value) {
    if (!(value < neverDark)) return neverDark;
    const auto rounded = static_cast<float>(value);
    return rounded < value ? std::nextafter(rounded, neverDark) : rounded;
}

float roundedDown(double value) {
    const auto rounded = static_cast<float>(value);
    return rounded > value ? std::nextafter(rounded, -neverDark) : rounded;
}

void addRecord(const Occluder& occluder, std::vector<glm::vec4>& records) {
    const glm::vec3 plane(occluder.plane);
    for (std::size_t i = 0; i < 3; ++i)
        records.emplace_back(glm::vec3(occluder.edges[i]), plane[static_cast<glm::length_t>(i)]);
}

/// Adds corners in an order that neighbours share, so that both compute the same for an edge.
void addCorners(const Occluder& occluder, std::vector<glm::vec4>& records) {
    std::array<glm::vec3, 3> corners;
    std::copy(occluder.corners.begin(), occluder.corners.end(), corners.begin());
    std::sort(corners.begin(), corners.end(), [](const glm::vec3& a, const glm::vec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    });
    for (const glm::vec3& corner : corners)
        records.emplace_back(corner, 0.0f);
}

/// A map's records, one for each triangle and each texture, made on first use.
class Records {
  public:
    Records(const Occluders& occluders, const CutoutTextures& textures, PrimitiveMap& map)
        : occluders_(occluders), textures_(textures), map_(map),
          recordOf_(occluders.all.size(), none), textureOf_(textures.size(), none) {}

    /// The occluder's name in an entry.
    float nameOf(std::uint32_t occluder) {
        const Occluder& of = occluders_.all[occluder];
        std::uint32_t& record = recordOf_[occluder];
        if (record == none) {
            const std::uint32_t texture = of.isSolid() ? none : textureRecord(of);
            record = next();
            if (map_.extended)
                addCorners(of, map_.records);
            else
                addRecord(of, map_.records);
            if (texture != none) addCutout(of, texture);
        }
        const auto name = static_cast<float>(record);
        return of.isSolid() ? name : -1.0f - name;
    }

  private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::uint32_t next() const { return static_cast<std::uint32_t>(map_.records.size() / 3); }

    std::uint32_t textureRecord(const Occluder& occluder) {
        const std::uint32_t material = occluders_.cutouts[occluder.cutout].material;
        std::uint32_t& record = textureOf_[material];
        if (record != none) return record;
        record = next();
        map_.cutouts = true;
        const CutoutTexture& texture = textures_[material];
        const glm::ivec2 place = texture.own ? glm::ivec2(3 * record + 3, 0) : texture.place;
        if (texture.tint) map_.records.emplace_back(*texture.tint, -1.0f);
        map_.records.emplace_back(place, texture.size);
        map_.records.emplace_back(texture.cutoff, static_cast<int>(texture.wrapS),
                                  static_cast<int>(texture.wrapT), texture.linear ? 1.0f : 0.0f);
        if (!texture.tint) map_.records.emplace_back(0.0f);
        if (texture.own) {
            map_.records.insert(map_.records.end(), texture.own->begin(), texture.own->end());
            map_.records.resize((map_.records.size() + 2) / 3 * 3, glm::vec4(0.0f));
        }
        return record;
    }

    void addCutout(const Occluder& of, std::uint32_t texture) {
        const CutoutPlanes& planes = occluders_.cutouts[of.cutout];
        if (textures_[planes.material].tint) {
            const auto taken = [&](std::size_t i) { return of.takesEdge[i] ? 1.0f : 0.0f; };
            map_.records.insert(map_.records.end(),
                                {glm::vec4(taken(0), taken(1), taken(2), texture),
                                 glm::vec4(planes.u, 0.0f), glm::vec4(planes.v, 0.0f)});
            return;
        }
        map_.records.emplace_back(glm::vec3(planes.u), static_cast<float>(texture));
        map_.records.emplace_back(glm::vec3(planes.v), 0.0f);
        map_.records.emplace_back(glm::vec3(planes.alpha), 0.0f);
    }

    const Occluders& occluders_;
    const CutoutTextures& textures_;
    PrimitiveMap& map_;
    std::vector<std::uint32_t> recordOf_, textureOf_;
};

} // namespace

/// Subdivides a part's square to texels, and further to pieces of them.
class PrimitiveMapBuilder::PartBuilder {
  public:
    PartBuilder(PrimitiveMapBuilder& builder, Part& part)
        : builder_(builder), part_(part), tile_(builder.footprintsOf(part.tile)) {
        part_.texels.resize(static_cast<std::size_t>(part_.side) *
                            static_cast<std::size_t>(part_.side));
    }

    /// Fills the texels of a square within the part, from candidates that may touch it.
    void fill(int x, int y, int side, const std::vector<std::uint32_t>& candidates) {
        if (candidates.empty() || builder_.tooLarge_) return;
        const RaySquare square = builder_.squareOf(x, y, side);
        TexelOccluders found;
        findOccluders(tile_, candidates, square, builder_.settings_.othersReceive, found);
        builder_.charge(0, candidates.size());
        if (found.touching.empty()) return;
        if (side == 1) {
            Texel& texel = part_.texels[static_cast<std::size_t>(y - part_.y) *
                                            static_cast<std::size_t>(part_.side) +
                                        static_cast<std::size_t>(x - part_.x)];
            texel = settle({static_cast<double>(x), static_cast<double>(y)}, 1.0, found, 0);
            return;
        }
        const int step = std::max(1, side / pieces);
        for (int j = 0; j < side; j += step)
            for (int i = 0; i < side; i += step)
                fill(x + i, y + j, step, found.touching);
    }

  private:
    /// The reference for a texel, or a piece of one, with the occluders `found` in it.
    Texel settle(const glm::dvec2& at, double side, const TexelOccluders& found, int splits) {
        Texel texel;
        texel.darkBehind = found.darkBehind;
        const PrimitiveMapSettings& settings = builder_.settings_;
        if (found.listed.empty() || builder_.tooLarge_) return texel;
        const bool isLong = found.forCasters > settings.splitAbove && splits < settings.mostSplits;
        const Pieces divided = isLong ? piecesOf(at, side, found) : Pieces();
        if (!isLong || !areShorter(divided, found)) {
            texel.kind = Texel::Kind::list;
            texel.index = part_.lists.size();
            builder_.charge(found.listed.size(), 0);
            builder_.chargeList(found.listed.size());
            part_.lists.push_back({part_.listed.size(), found.listed.size(), found.forCasters});
            part_.listed.insert(part_.listed.end(), found.listed.begin(), found.listed.end());
            return texel;
        }
        texel.kind = Texel::Kind::block;
        texel.index = part_.blocks.size();
        part_.blocks.resize(part_.blocks.size() + divided.size());
        builder_.charge(divided.size(), 0);
        for (std::size_t i = 0; i < divided.size(); ++i) {
            const Texel piece = settle(placeOf(i, at, side), side / pieces, divided[i], splits + 1);
            part_.blocks[texel.index + i] = piece; // settling may have moved the blocks
        }
        return texel;
    }

    using Pieces = std::vector<TexelOccluders>; ///< row by row

    static glm::dvec2 placeOf(std::size_t piece, const glm::dvec2& at, double side) {
        return at + side / pieces * glm::dvec2(piece % pieces, piece / pieces);
    }

    Pieces piecesOf(const glm::dvec2& at, double side, const TexelOccluders& found) {
        Pieces divided(pieces * pieces);
        builder_.charge(0, divided.size() * found.touching.size());
        for (std::size_t i = 0; i < divided.size(); ++i) {
            const glm::dvec2 from = placeOf(i, at, side);
            findOccluders(tile_, found.touching, builder_.squareOf(from.x, from.y, side / pieces),
                          builder_.settings_.othersReceive, divided[i]);
        }
        return divided;
    }

    /// Whether dividing is worth its memory: where many triangles are behind each other, like
    /// leaves, pieces have as many of them as the whole.
    static bool areShorter(const Pieces& divided, const TexelOccluders& whole) {
        std::size_t sum = 0;
        for (const TexelOccluders& piece : divided)
            sum += piece.forCasters;
        return static_cast<double>(sum) <=
               worthDividing * static_cast<double>(divided.size() * whole.forCasters);
    }

    PrimitiveMapBuilder& builder_;
    Part& part_;
    TileFootprints tile_;
};

PrimitiveMapBuilder::PrimitiveMapBuilder(const Light& light,
                                         const std::vector<PlacedCasters>& casters,
                                         const PrimitiveMapSettings& settings)
    : settings_(settings) {
    const auto tiles = tilesFor(light, casters, settings.receivers);
    if (!tiles) {
        tiles_.tiles = {glm::dmat3(1.0)};
        settings_.size = 4;
    } else {
        tiles_ = *tiles;
        occluders_ = occludersOf(light, tiles_, casters);
    }
    prints_.resize(tiles_.tiles.size());
    for (std::size_t tile = 0; tile < prints_.size(); ++tile) {
        for (std::size_t i = 0; i < occluders_.all.size(); ++i) {
            auto print =
                footprintOf(occluders_.all[i], static_cast<std::uint32_t>(i), tiles_, tile);
            if (print) prints_[tile].prints.push_back(*print);
        }
        divideIntoParts(tile);
    }
    const auto size = static_cast<std::size_t>(settings_.size);
    charge(tiles_.tiles.size() * size * size, 0);
}

void PrimitiveMapBuilder::charge(std::size_t listed, std::size_t looks) {
    listed_ += listed;
    looks_ += looks;
    if (listed_ * sizeof(glm::vec2) > settings_.mostBytes ||
        looks_ > mostLooks + looksEach * occluders_.all.size())
        tooLarge_ = true;
}

void PrimitiveMapBuilder::chargeList(std::size_t triangles) {
    if (triangles <= settings_.longestWanted) return;
    tooLong_ = triangles;
    tooLarge_ = true;
}

void PrimitiveMapBuilder::lookForLongLists() {
    if (settings_.mostSplits > 0) return; // a piece of a texel may have a shorter list
    std::vector<const Part*> crowded;
    for (const Part& part : parts_)
        if (part.candidates.size() > settings_.longestWanted) crowded.push_back(&part);
    std::stable_sort(crowded.begin(), crowded.end(), [](const Part* a, const Part* b) {
        return a->candidates.size() > b->candidates.size();
    });
    if (crowded.size() > mostCrowdedParts) crowded.resize(mostCrowdedParts);
    for (const Part* part : crowded)
        if (tooLong_ == 0) lookForLongLists(*part);
}

/// Descends to a texel, each time into the piece touched by the most casters.
void PrimitiveMapBuilder::lookForLongLists(const Part& part) {
    const TileFootprints tile = footprintsOf(part.tile);
    TexelOccluders densest, piece;
    densest.touching = part.candidates;
    int left = part.x, low = part.y;
    for (int side = part.side; side > 1;) {
        const std::vector<std::uint32_t> candidates = std::move(densest.touching);
        const int fromX = left, fromY = low, whole = side;
        side = std::max(1, side / pieces);
        densest = {};
        for (int y = fromY; y < fromY + whole; y += side)
            for (int x = fromX; x < fromX + whole; x += side) {
                findOccluders(tile, candidates, squareOf(x, y, side), settings_.othersReceive,
                              piece);
                if (piece.touching.size() < densest.touching.size()) continue;
                std::swap(densest, piece);
                left = x;
                low = y;
            }
    }
    chargeList(densest.listed.size());
}

TileFootprints PrimitiveMapBuilder::footprintsOf(std::size_t tile) const {
    return {occluders_.all, prints_[tile].prints, tiles_.directional, TileSpread(tiles_, tile)};
}

/// The arguments are in texels of the tile.
RaySquare PrimitiveMapBuilder::squareOf(double x, double y, double side) const {
    const double scale = 2.0 / settings_.size;
    const glm::dvec2 low(x * scale - 1.0, y * scale - 1.0);
    return RaySquare{low, low + side * scale}.grownBy(mapRounding);
}

void PrimitiveMapBuilder::divideIntoParts(std::size_t tile) {
    const std::vector<Footprint>& prints = prints_[tile].prints;
    const int side = std::min(partSide, settings_.size);
    const int perRow = settings_.size / side;
    const std::size_t first = parts_.size();
    for (int y = 0; y < settings_.size; y += side)
        for (int x = 0; x < settings_.size; x += side) {
            Part& part = parts_.emplace_back();
            part.tile = tile;
            part.x = x;
            part.y = y;
            part.side = side;
        }
    // Maps rays to parts; the result extends slightly beyond the footprint.
    const double scale = 0.5 * perRow;
    const auto partAt = [&](double at) {
        return static_cast<int>(std::clamp(std::floor((at + 1.0) * scale), 0.0, perRow - 1.0));
    };
    const TileSpread tileSpread(tiles_, tile);
    for (std::uint32_t i = 0; i < prints.size(); ++i) {
        RaySquare rays{prints[i].low, prints[i].high};
        if (prints[i].nearLight) rays = {glm::dvec2(-1.0), glm::dvec2(1.0)};
        const RaySquare reached = tileSpread.reaching(rays, prints[i].depths.low);
        const glm::dvec2 low = reached.low - 2.0 * mapRounding;
        const glm::dvec2 high = reached.high + 2.0 * mapRounding;
        for (int y = partAt(low.y); y <= partAt(high.y); ++y)
            for (int x = partAt(low.x); x <= partAt(high.x); ++x)
                parts_[first + static_cast<std::size_t>(y * perRow + x)].candidates.push_back(i);
    }
}

void PrimitiveMapBuilder::buildPart(std::size_t index) {
    Part& part = parts_[index];
    PartBuilder(*this, part).fill(part.x, part.y, part.side, part.candidates);
    part.candidates = {};
}

std::optional<PrimitiveMap> PrimitiveMapBuilder::join() {
    if (tooLarge_) return std::nullopt;
    PrimitiveMap map;
    map.tiles = tiles_;
    map.size = settings_.size;
    map.extended = tiles_.shape.has_value();
    const auto size = static_cast<std::size_t>(settings_.size);
    // The arrays take most of a map's memory: none grows step by step, and parts are let go of.
    std::size_t blocks = 0, listed = 0;
    for (const Part& part : parts_) {
        blocks += part.blocks.size();
        listed += part.listed.size();
    }
    map.header.reserve(tiles_.tiles.size() * size * size + blocks);
    map.entries.reserve(1 + listed);
    map.entries.emplace_back(0.0f); // so that 0 names no list
    map.header.resize(tiles_.tiles.size() * size * size, glm::vec2(neverDark, 0.0f));
    Records records(occluders_, settings_.cutouts, map);
    std::size_t lists = 0;
    for (Part& from : parts_) {
        const Part part = std::move(from);
        const std::vector<Footprint>& prints = prints_[part.tile].prints;
        std::vector<float> listAt(part.lists.size());
        lists += part.lists.size();
        for (std::size_t l = 0; l < part.lists.size(); ++l) {
            const List& list = part.lists[l];
            listAt[l] =
                static_cast<float>(map.entries.size()) + (list.forCasters == 0 ? endsHere : 0.0f);
            map.longestList = std::max(map.longestList, list.count);
            const std::size_t end = list.first + list.count;
            for (std::size_t i = list.first; i < end; ++i) {
                const float name = records.nameOf(prints[part.listed[i].print].occluder);
                const float next =
                    i + 1 < end ? roundedDown(part.listed[i + 1].nearest) : neverDark;
                const bool isLast = i + 1 == list.first + list.forCasters;
                map.entries.emplace_back(name + (isLast ? endsHere : 0.0f), next);
            }
        }
        const std::size_t firstBlock = map.header.size();
        const auto texelOf = [&](const Texel& texel) {
            const float reference = texel.kind == Texel::Kind::list ? listAt[texel.index]
                                    : texel.kind == Texel::Kind::block
                                        ? -static_cast<float>(firstBlock + texel.index)
                                        : 0.0f;
            return glm::vec2(roundedUp(texel.darkBehind), reference);
        };
        for (const Texel& texel : part.blocks)
            map.header.push_back(texelOf(texel));
        for (std::size_t i = 0; i < part.texels.size(); ++i) {
            const auto side = static_cast<std::size_t>(part.side);
            const std::size_t x = static_cast<std::size_t>(part.x) + i % side;
            const std::size_t y = static_cast<std::size_t>(part.y) + i / side;
            map.header[(part.tile * size + y) * size + x] = texelOf(part.texels[i]);
        }
    }
    if (lists > 0)
        map.meanList = static_cast<double>(map.entries.size() - 1) / static_cast<double>(lists);
    const std::size_t most = std::max({map.header.size(), map.entries.size(), map.records.size()});
    if (map.bytes() > settings_.mostBytes || most > mostReferences) return std::nullopt;
    return map;
}

void PrimitiveMapBuilder::buildAllParts() {
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t part = next++; part < partCount(); part = next++)
            buildPart(part);
    };
#ifndef __EMSCRIPTEN__
    std::vector<std::jthread> threads; // joined before `next` and `work` are destroyed
    const unsigned others = std::max(1u, std::thread::hardware_concurrency()) - 1;
    for (unsigned i = 0; i < others; ++i)
        threads.emplace_back(work);
#endif
    work();
}

} // namespace edgeshade
