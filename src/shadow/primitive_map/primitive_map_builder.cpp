#include "src/shadow/primitive_map/primitive_map_builder.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
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

/// How many times as long a piece's list must be as that of what it is a piece of, for dividing it
/// too: pieces are many and small.
constexpr std::size_t longerForPieces = 3;

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

/// Sets the pair of this number in the texel that has it.
void setPair(glm::vec4& texel, std::size_t pair, const glm::vec2& to) {
    if (pair % 2 == 0) {
        texel.x = to.x;
        texel.y = to.y;
    } else {
        texel.z = to.x;
        texel.w = to.y;
    }
}

/// A map's records, one for each triangle and each texture, made on first use.
class Records {
  public:
    /// `records`: where they are added.
    Records(const Occluders& occluders, const CutoutTextures& textures, bool extended,
            std::vector<glm::vec4>& records)
        : occluders_(occluders), textures_(textures), extended_(extended), records_(records),
          recordOf_(occluders.all.size(), none), textureOf_(textures.size(), none) {}

    /// The occluder's name in an entry.
    float nameOf(std::uint32_t occluder) {
        const Occluder& of = occluders_.all[occluder];
        std::uint32_t& record = recordOf_[occluder];
        if (record == none) {
            const std::uint32_t texture = of.isSolid() ? none : textureRecord(of);
            record = next();
            if (extended_)
                addCorners(of, records_);
            else
                addRecord(of, records_);
            if (texture != none) addCutout(of, texture);
        }
        const auto name = static_cast<float>(record);
        return of.isSolid() ? name : -1.0f - name;
    }

    /// Whether a record is that of an alpha-tested or tinted triangle.
    bool hasCutouts() const { return hasCutouts_; }

  private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::uint32_t next() const { return static_cast<std::uint32_t>(records_.size() / 3); }

    std::uint32_t textureRecord(const Occluder& occluder) {
        const std::uint32_t material = occluders_.cutouts[occluder.cutout].material;
        std::uint32_t& record = textureOf_[material];
        if (record != none) return record;
        record = next();
        hasCutouts_ = true;
        const CutoutTexture& texture = textures_[material];
        const glm::ivec2 place = texture.own ? glm::ivec2(3 * record + 3, 0) : texture.place;
        if (texture.tint) records_.emplace_back(*texture.tint, -1.0f);
        records_.emplace_back(place, texture.size);
        records_.emplace_back(texture.cutoff, static_cast<int>(texture.wrapS),
                              static_cast<int>(texture.wrapT), texture.linear ? 1.0f : 0.0f);
        if (!texture.tint) records_.emplace_back(0.0f);
        if (texture.own) {
            records_.insert(records_.end(), texture.own->begin(), texture.own->end());
            records_.resize((records_.size() + 2) / 3 * 3, glm::vec4(0.0f));
        }
        return record;
    }

    void addCutout(const Occluder& of, std::uint32_t texture) {
        const CutoutPlanes& planes = occluders_.cutouts[of.cutout];
        if (textures_[planes.material].tint) {
            const auto taken = [&](std::size_t i) { return of.takesEdge[i] ? 1.0f : 0.0f; };
            records_.insert(records_.end(), {glm::vec4(taken(0), taken(1), taken(2), texture),
                                             glm::vec4(planes.u, 0.0f), glm::vec4(planes.v, 0.0f)});
            return;
        }
        records_.emplace_back(glm::vec3(planes.u), static_cast<float>(texture));
        records_.emplace_back(glm::vec3(planes.v), 0.0f);
        records_.emplace_back(glm::vec3(planes.alpha), 0.0f);
    }

    const Occluders& occluders_;
    const CutoutTextures& textures_;
    bool extended_, hasCutouts_ = false;
    std::vector<glm::vec4>& records_;
    std::vector<std::uint32_t> recordOf_, textureOf_;
};

} // namespace

/// Subdivides a part's square to texels, and further to pieces of them.
class PrimitiveMapBuilder::PartBuilder {
  public:
    PartBuilder(PrimitiveMapBuilder& builder, Part& part)
        : builder_(builder), part_(part), tile_(builder.footprintsOf(part.tile)),
          divided_(static_cast<std::size_t>(builder.settings_.mostSplits)) {
        part_.texels.resize(static_cast<std::size_t>(part_.side) *
                            static_cast<std::size_t>(part_.side));
    }

    /// Fills the part's texels.
    void fill() {
        fill(part_.x, part_.y, part_.side, part_.candidates, part_.candidates.size(), 0);
    }

  private:
    static constexpr std::size_t squares = pieces * pieces;
    using Candidates = std::vector<std::uint32_t>;
    using Found = std::array<TexelOccluders, squares>; ///< of pieces, row by row
    using Divided = std::array<Candidates, squares>;   ///< the same

    /// Fills the texels of a square within the part. `candidates`: all that may touch it, of
    /// `looks` that were examined. `depth`: of the division.
    void fill(int x, int y, int side, const Candidates& candidates, std::size_t looks,
              std::size_t depth) {
        if (looks == 0 || builder_.tooLarge_ || !builder_.isWanted(part_.tile, x, y, side)) return;
        if (filled_.size() == depth) filled_.push_back(std::make_unique<Filled>());
        auto& [found, divided] = *filled_[depth];
        findOccluders(tile_, candidates, builder_.squareOf(x, y, side),
                      builder_.settings_.othersReceive, found);
        builder_.charge(0, looks);
        if (found.touching.empty()) return;
        if (side == 1) {
            Texel& texel = part_.texels[static_cast<std::size_t>(y - part_.y) *
                                            static_cast<std::size_t>(part_.side) +
                                        static_cast<std::size_t>(x - part_.x)];
            texel = settle({static_cast<double>(x), static_cast<double>(y)}, 1.0, found, 0);
            return;
        }
        const int step = std::max(1, side / pieces);
        divide({x, y}, step, found.touching, divided);
        for (int j = 0; j < side; j += step)
            for (int i = 0; i < side; i += step) {
                const auto piece = static_cast<std::size_t>(j / step * pieces + i / step);
                fill(x + i, y + j, step, divided[piece], found.touching.size(), depth + 1);
            }
    }

    /// The candidates that each of 4 x 4 squares may touch, by their boxes alone.
    void divide(const glm::dvec2& at, double step, const Candidates& candidates,
                Divided& divided) const {
        for (Candidates& of : divided)
            of.clear();
        std::array<RaySquare, pieces> diagonal; // the columns' x, and the rows' y
        for (int i = 0; i < pieces; ++i)
            diagonal[static_cast<std::size_t>(i)] =
                builder_.squareOf(at.x + i * step, at.y + i * step, step);
        for (const std::uint32_t candidate : candidates) {
            const Footprint& print = tile_.prints[candidate];
            unsigned columns = 0, rows = 0;
            for (unsigned i = 0; i < pieces; ++i) {
                const RaySquare& square = diagonal[i];
                const auto misses = [&](glm::length_t axis) {
                    return !tile_.spread.any() && (print.high[axis] < square.low[axis] ||
                                                   print.low[axis] > square.high[axis]);
                };
                columns |= misses(0) ? 0u : 1u << i;
                rows |= misses(1) ? 0u : 1u << i;
            }
            for (unsigned row = 0; row < pieces; ++row)
                for (unsigned column = 0; column < pieces; ++column)
                    if ((rows >> row & columns >> column & 1u) != 0)
                        divided[row * pieces + column].push_back(candidate);
        }
    }

    /// The reference for a texel, or a piece of one, with the occluders `found` in it.
    Texel settle(const glm::dvec2& at, double side, const TexelOccluders& found, int splits) {
        Texel texel;
        texel.darkBehind = roundedUp(found.darkBehind);
        const PrimitiveMapSettings& settings = builder_.settings_;
        if (found.listed.empty() || builder_.tooLarge_) return texel;
        const bool isLong = splits < settings.mostSplits && found.forCasters > longestWhole(splits);
        const Found* const divided = isLong ? &piecesOf(at, side, found, splits) : nullptr;
        if (!divided || !areShorter(*divided, found)) {
            texel.reference = static_cast<std::int32_t>(part_.lists.size() + 1);
            addList(found);
            return texel;
        }
        const std::size_t block = part_.blocks.size();
        texel.reference = -static_cast<std::int32_t>(block + 1);
        part_.blocks.resize(block + squares);
        builder_.charge(squares, 0);
        for (std::size_t i = 0; i < squares; ++i) {
            const Texel piece =
                settle(placeOf(i, at, side), side / pieces, (*divided)[i], splits + 1);
            part_.blocks[block + i] = piece; // settling may have moved the blocks
        }
        return texel;
    }

    /// Length of the longest list that is not divided, of a piece after so many splits.
    std::size_t longestWhole(int splits) const {
        std::size_t length = builder_.settings_.splitAbove;
        for (int i = 0; i < splits; ++i)
            length *= longerForPieces;
        return length;
    }

    void addList(const TexelOccluders& found) {
        const std::size_t count = found.listed.size();
        builder_.charge(count, 0);
        builder_.chargeList(count);
        part_.lists.push_back({static_cast<std::uint32_t>(part_.entries.size()),
                               static_cast<std::uint32_t>(count),
                               static_cast<std::uint32_t>(found.forCasters)});
        for (std::size_t i = 0; i < count; ++i)
            part_.entries.push_back(
                {found.listed[i].print,
                 i + 1 < count ? roundedDown(found.listed[i + 1].nearest) : neverDark});
    }

    static glm::dvec2 placeOf(std::size_t piece, const glm::dvec2& at, double side) {
        return at + side / pieces * glm::dvec2(piece % pieces, piece / pieces);
    }

    /// The result is valid until the next call with as many splits.
    const Found& piecesOf(const glm::dvec2& at, double side, const TexelOccluders& found,
                          int splits) {
        auto& of = divided_[static_cast<std::size_t>(splits)];
        if (!of) of = std::make_unique<Found>();
        builder_.charge(0, squares * found.touching.size());
        divide(at, side / pieces, found.touching, candidates_);
        for (std::size_t i = 0; i < squares; ++i) {
            const glm::dvec2 from = placeOf(i, at, side);
            findOccluders(tile_, candidates_[i], builder_.squareOf(from.x, from.y, side / pieces),
                          builder_.settings_.othersReceive, (*of)[i]);
        }
        return *of;
    }

    /// Whether dividing is worth its memory: where many triangles are behind each other, like
    /// leaves, pieces have as many of them as the whole.
    static bool areShorter(const Found& divided, const TexelOccluders& whole) {
        std::size_t sum = 0;
        for (const TexelOccluders& piece : divided)
            sum += piece.forCasters;
        return static_cast<double>(sum) <=
               worthDividing * static_cast<double>(divided.size() * whole.forCasters);
    }

    PrimitiveMapBuilder& builder_;
    Part& part_;
    TileFootprints tile_;
    // Kept from call to call, so that few need memory of their own.
    struct Filled {
        TexelOccluders found;
        Divided divided;
    };
    std::vector<std::unique_ptr<Filled>> filled_; ///< by depth of the division
    std::vector<std::unique_ptr<Found>> divided_; ///< by number of splits
    Divided candidates_;
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
        if (settings_.lookingUp)
            wanted_.emplace_back(tiles_, tile, settings_.size, *settings_.lookingUp);
        if (prints_.size() == 1) prints_[tile].prints.reserve(occluders_.all.size());
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
    // A piece of a texel may have a shorter list, and a texel that nobody asks has none.
    if (settings_.mostSplits > 0 || settings_.lookingUp) return;
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

bool PrimitiveMapBuilder::isWanted(std::size_t tile, int x, int y, int side) const {
    return wanted_.empty() || wanted_[tile].anyIn(x, y, side);
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
    if (!isWanted(part.tile, part.x, part.y, part.side)) part.candidates = {};
    if (part.candidates.empty()) return; // join() takes its texels to have nothing
    PartBuilder(*this, part).fill();
    part.candidates = {};
    // The parts' arrays take as much memory as the map; what they grew by is free for the next one.
    part.blocks.shrink_to_fit();
    part.lists.shrink_to_fit();
    part.entries.shrink_to_fit();
}

std::optional<PrimitiveMap> PrimitiveMapBuilder::join() {
    if (tooLarge_) return std::nullopt;
    PrimitiveMap map;
    map.tiles = tiles_;
    map.size = settings_.size;
    map.extended = tiles_.shape.has_value();
    const auto size = static_cast<std::size_t>(settings_.size);
    // The arrays take most of a map's memory: none grows step by step, and parts are let go of.
    std::size_t blocks = 0, entries = 0;
    for (const Part& part : parts_) {
        blocks += part.blocks.size();
        entries += part.entries.size();
    }
    map.headers = tiles_.tiles.size() * size * size + blocks;
    std::vector<glm::vec4> records;
    records.reserve(3 * occluders_.all.size());
    map.texels.reserve(map.entriesBegin() + entries / 2 + 1 + records.capacity());
    map.texels.resize(map.entriesBegin(), glm::vec4(0.0f));
    const auto setHeader = [&](std::size_t at, const glm::vec2& pair) {
        setPair(map.texels[at / 2], at, pair);
    };
    const auto addEntry = [&](const glm::vec2& pair) {
        if (map.entries % 2 == 0) map.texels.emplace_back(0.0f);
        setPair(map.texels.back(), map.entries++, pair);
    };
    addEntry(glm::vec2(0.0f)); // so that 0 names no list
    for (std::size_t i = 0; i < map.headers - blocks; ++i)
        setHeader(i, {neverDark, 0.0f});
    Records names(occluders_, settings_.cutouts, map.extended, records);
    std::size_t lists = 0, nextBlock = map.headers - blocks;
    for (Part& from : parts_) {
        const Part part = std::move(from);
        const std::vector<Footprint>& prints = prints_[part.tile].prints;
        std::vector<float> listAt(part.lists.size());
        lists += part.lists.size();
        for (std::size_t l = 0; l < part.lists.size(); ++l) {
            const List& list = part.lists[l];
            listAt[l] = static_cast<float>(map.entries) + (list.forCasters == 0 ? endsHere : 0.0f);
            map.longestList = std::max<std::size_t>(map.longestList, list.count);
            for (std::uint32_t i = 0; i < list.count; ++i) {
                const Entry& entry = part.entries[list.first + i];
                const float name = names.nameOf(prints[entry.print].occluder);
                const bool isLast = i + 1 == list.forCasters;
                addEntry({name + (isLast ? endsHere : 0.0f), entry.next});
            }
        }
        const std::size_t firstBlock = nextBlock;
        const auto pairOf = [&](const Texel& texel) {
            const std::int32_t at = texel.reference;
            float reference = 0.0f;
            if (at > 0) reference = listAt[static_cast<std::size_t>(at - 1)];
            if (at < 0)
                reference = -static_cast<float>(firstBlock + static_cast<std::size_t>(-1 - at));
            return glm::vec2(texel.darkBehind, reference);
        };
        for (const Texel& texel : part.blocks)
            setHeader(nextBlock++, pairOf(texel));
        for (std::size_t i = 0; i < part.texels.size(); ++i) {
            const auto side = static_cast<std::size_t>(part.side);
            const std::size_t x = static_cast<std::size_t>(part.x) + i % side;
            const std::size_t y = static_cast<std::size_t>(part.y) + i / side;
            setHeader((part.tile * size + y) * size + x, pairOf(part.texels[i]));
        }
    }
    map.cutouts = names.hasCutouts();
    map.texels.insert(map.texels.end(), records.begin(), records.end());
    if (lists > 0) map.meanList = static_cast<double>(map.entries - 1) / static_cast<double>(lists);
    const std::size_t most = std::max({map.headers, map.entries, map.records()});
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
