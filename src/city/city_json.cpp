#include "src/city/city_json.hpp"

#include "preprocess/gltf/json_vectors.hpp"
#include "src/city/byte_text.hpp"
#include "src/city/json_text.hpp"
#include "src/city/lattice.hpp"
#include "src/city/polygon_triangles.hpp"
#include "src/city/tile_writer.hpp"

#include <charconv>
#include <cmath>
#include <map>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace edgeshade::city {
namespace {

using Json = nlohmann::ordered_json;
using Named = std::unordered_map<std::string, const Json*>;

/// Levels of parents above an object; CityJSON has two.
constexpr int deepestPart = 16;

/// Levels of arrays above the surfaces of a geometry; 0: it has none, or is of points and lines.
int levelsOf(const std::string& type) {
    if (type == "MultiSurface" || type == "CompositeSurface") return 1;
    if (type == "Solid") return 2;
    if (type == "MultiSolid" || type == "CompositeSolid") return 3;
    return 0;
}

SurfaceKind kindOf(const std::string& type) {
    if (type == "RoofSurface") return SurfaceKind::roof;
    if (type == "WallSurface") return SurfaceKind::wall;
    if (type == "GroundSurface") return SurfaceKind::ground;
    return SurfaceKind::other;
}

/// "2.2" as a number; a lod that isn't one is invalid.
double levelOf(const JsonField& lod) {
    const std::string text = lod.value().is_number() ? lod.value().dump() : lod.text();
    double level = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), level);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size() || !std::isfinite(level))
        lod.fail(" is '" + text + "', which is no level of detail");
    return level;
}

/// x = integer * scale + translate.
struct Transform {
    glm::dvec3 scale{1.0}, translate{0.0};

    explicit Transform(const JsonField& root) {
        const JsonField transform = root.member("transform");
        scale = vectorFrom(transform.member("scale"));
        translate = vectorFrom(transform.member("translate"));
    }
    glm::dvec3 placeOf(const JsonField& vertex) const {
        vertex.requireArray();
        if (vertex.size() != 3) vertex.fail(" is not three numbers");
        const auto at = [&](std::size_t i) {
            return static_cast<double>(vertex.item(i).integer());
        };
        return glm::dvec3(at(0), at(1), at(2)) * scale + translate;
    }
};

class Reading {
  public:
    Reading(const std::filesystem::path& path, std::optional<double> lod)
        : path_(path), lod_(lod), writer_(tile_) {}

    void readHeader(const JsonField& root) {
        const std::string type = root.member("type").text();
        if (type != "CityJSON")
            root.member("type").fail(" is '" + type + "', but must be 'CityJSON'");
        root.member("version").oneOf({"1.1", "2.0"});
        transform_.emplace(root);
        root.ifPresent("metadata", [&](const JsonField& metadata) {
            metadata.ifPresent("referenceSystem",
                               [&](const JsonField& system) { tile_.epsg = epsgOf(system); });
        });
    }

    /// Reads the objects of a file or a feature.
    void readObjects(const JsonField& root) {
        std::vector<glm::dvec3> places;
        root.member("vertices").forEachItem([&](const JsonField& vertex) {
            places.push_back(transform_->placeOf(vertex));
        });
        const JsonField objects = root.member("CityObjects");
        Named named;
        objects.forEachMember(
            [&](const JsonField& object) { named.emplace(object.key(), &object.value()); });
        objects.forEachMember([&](const JsonField& object) { readObject(named, object, places); });
    }

    CityTile result() {
        if (leftOut_ > 0)
            tile_.warnings.push_back("'" + path_.string() + "': " + std::to_string(leftOut_) +
                                     " objects have no surfaces of the level of detail.");
        return std::move(tile_);
    }

  private:
    /// "https://www.opengis.net/def/crs/EPSG/0/7415", or the URN of CityJSON 1.0.
    static int epsgOf(const JsonField& system) {
        const std::string text = system.text();
        const std::size_t end = text.find_last_of("/:");
        int code = 0;
        const char* const first = text.data() + (end == std::string::npos ? 0 : end + 1);
        const auto read = std::from_chars(first, text.data() + text.size(), code);
        if (text.find("EPSG") == std::string::npos || read.ec != std::errc() ||
            read.ptr != text.data() + text.size() || code <= 0)
            system.fail(" is '" + text + "', which names no EPSG code");
        return code;
    }

    /// The number of the object that this one's cells count for: its topmost parent.
    std::uint32_t rootOf(const Named& objects, const JsonField& object) {
        const Json* at = &object.value();
        std::string id = object.key();
        for (int above = 0;; ++above) {
            const auto parents = at->find("parents");
            if (!at->is_object() || parents == at->end() || !parents->is_array() ||
                parents->empty() || !parents->front().is_string())
                break;
            const std::string parent = parents->front().get<std::string>();
            const auto found = objects.find(parent);
            if (found == objects.end() || above == deepestPart)
                object.fail(".parents names '" + parent + "', which is not above it");
            at = found->second;
            id = parent;
        }
        const auto [entry, isNew] = numbers_.emplace(id, 0);
        if (isNew) {
            const auto type = at->find("type");
            const bool isBuilding = at->is_object() && type != at->end() && type->is_string() &&
                                    type->get<std::string>().starts_with("Building");
            entry->second = writer_.addObject(id, isBuilding);
        }
        return entry->second;
    }

    void readObject(const Named& objects, const JsonField& object,
                    const std::vector<glm::dvec3>& places) {
        object.requireObject();
        const auto geometries = object.find("geometry");
        if (!geometries || geometries->size() == 0) return;
        const std::uint32_t number = rootOf(objects, object);
        double best = -1.0;
        geometries->forEachItem([&](const JsonField& geometry) {
            if (!isUsed(geometry)) return;
            const double level = levelOf(geometry.member("lod"));
            if (!lod_ || level <= *lod_) best = std::max(best, level);
        });
        if (best < 0.0) {
            ++leftOut_;
            return;
        }
        geometries->forEachItem([&](const JsonField& geometry) {
            if (isUsed(geometry) && levelOf(geometry.member("lod")) == best)
                readGeometry(geometry, number, places);
        });
    }

    static bool isUsed(const JsonField& geometry) {
        return levelsOf(geometry.member("type").text()) > 0;
    }

    void readGeometry(const JsonField& geometry, std::uint32_t object,
                      const std::vector<glm::dvec3>& places) {
        std::vector<SurfaceKind> kinds;
        const Json* values = nullptr;
        geometry.ifPresent("semantics", [&](const JsonField& semantics) {
            semantics.member("surfaces").forEachItem([&](const JsonField& surface) {
                kinds.push_back(kindOf(surface.member("type").text()));
            });
            values = &semantics.member("values").value();
        });
        readSurfaces(geometry.member("boundaries"), values,
                     levelsOf(geometry.member("type").text()), kinds, object, places);
    }

    /// `values`: numbers of semantics in arrays like those of boundaries; null: none.
    void readSurfaces(const JsonField& boundaries, const Json* values, int levels,
                      const std::vector<SurfaceKind>& kinds, std::uint32_t object,
                      const std::vector<glm::dvec3>& places) {
        boundaries.requireArray();
        for (std::size_t i = 0; i < boundaries.size(); ++i) {
            const Json* const value =
                values && values->is_array() && i < values->size() ? &values->at(i) : nullptr;
            if (levels > 1) {
                readSurfaces(boundaries.item(i), value, levels - 1, kinds, object, places);
                continue;
            }
            SurfaceKind kind = SurfaceKind::none;
            if (value && !value->is_null()) {
                if (!value->is_number_unsigned() || value->get<std::uint64_t>() >= kinds.size())
                    boundaries.item(i).fail(" has the semantics " + value->dump() +
                                            ", but there are " + std::to_string(kinds.size()));
                kind = kinds[value->get<std::size_t>()];
            }
            readSurface(boundaries.item(i), kind, object, places);
        }
    }

    void readSurface(const JsonField& surface, SurfaceKind kind, std::uint32_t object,
                     const std::vector<glm::dvec3>& places) {
        std::vector<std::vector<glm::dvec3>> rings;
        surface.forEachItem([&](const JsonField& ring) {
            std::vector<glm::dvec3>& corners = rings.emplace_back();
            ring.forEachItem([&](const JsonField& corner) {
                const auto index =
                    static_cast<std::size_t>(corner.indexInto(places.size(), "vertices"));
                corners.push_back(onLattice(places[index]));
            });
        });
        const std::string where = surface.where();
        for (const std::array<glm::dvec3, 3>& triangle : trianglesOf(rings))
            writer_.addTriangle(triangle, object, kind, where);
    }

    const std::filesystem::path& path_;
    std::optional<double> lod_;
    CityTile tile_;
    TileWriter writer_;
    std::optional<Transform> transform_;
    std::map<std::string, std::uint32_t> numbers_; ///< of objects, by name
    std::size_t leftOut_ = 0;
};

} // namespace

CityTile tileFromCityJson(const Bytes& bytes, const std::filesystem::path& path, bool isSequence,
                          std::optional<double> lod) {
    const std::string_view text = textOf(bytes);
    Reading reading(path, lod);
    if (!isSequence) {
        const Json json = jsonFrom(text, "'" + path.string() + "' is not valid JSON");
        const JsonField root(path, json);
        root.requireObject();
        reading.readHeader(root);
        reading.readObjects(root);
        return reading.result();
    }
    bool hasHeader = false;
    forEachLine(text, [&](std::string_view line, std::size_t number) {
        const std::string name = "line " + std::to_string(number);
        const Json json = jsonFrom(line, "'" + path.string() + "', " + name + " is not valid JSON");
        const JsonField root(path, json, name.c_str());
        root.requireObject();
        if (!std::exchange(hasHeader, true)) {
            reading.readHeader(root);
        } else if (root.member("type").text() != "CityJSONFeature") {
            root.member("type").fail(" is '" + root.member("type").text() +
                                     "', but must be 'CityJSONFeature'");
        }
        reading.readObjects(root);
    });
    if (!hasHeader) throw InputError("'" + path.string() + "' is empty.");
    return reading.result();
}

} // namespace edgeshade::city
