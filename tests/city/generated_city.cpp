#include "tests/city/generated_city.hpp"

#include "preprocess/base/file_io.hpp"
#include "preprocess/gltf/glb.hpp"
#include "src/city/geodetic.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

namespace edgeshade::city {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Ring = std::vector<glm::dvec3>;

constexpr double block = 32.0, spacing = 16.0, step = 0.125;

double rounded(double value) {
    return std::round(value / step) * step;
}

struct Face {
    Ring ring;
    Ring hole{};
    SurfaceKind kind = SurfaceKind::wall;
};

struct Object {
    std::string id;
    bool isTerrain = false;
    std::vector<Face> faces;
};

/// A prism's walls around a ring, counter-clockwise from above, outwards.
void addWalls(const Ring& ring, double low, double high, bool outwards, Object& to) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        glm::dvec3 a = ring[i], b = ring[(i + 1) % ring.size()];
        if (!outwards) std::swap(a, b);
        to.faces.push_back(
            {{{a.x, a.y, low}, {b.x, b.y, low}, {b.x, b.y, high}, {a.x, a.y, high}}});
    }
}

Ring rectangle(double west, double south, double east, double north, double z) {
    return {{west, south, z}, {east, south, z}, {east, north, z}, {west, north, z}};
}

Ring reversed(Ring ring) {
    std::ranges::reverse(ring);
    return ring;
}

class TileDrawing {
  public:
    TileDrawing(const GeneratedCity& city, int tileX, int tileY)
        : city_(city), x_(tileX), y_(tileY) {}

    double heightOf(double x, double y) const {
        if (city_.hills == 0.0) return 0.0;
        const double phase = city_.seed * 1.7;
        return rounded(0.25 * city_.hills *
                       (std::sin(x / 83.0 + phase) + std::sin(y / 61.0 + 2.0 * phase) +
                        std::sin((x + y) / 190.0) + 1.0));
    }

    std::vector<Object> objects() const {
        std::vector<Object> all{terrain()};
        for (int by = 0; by < city_.blocks; ++by)
            for (int bx = 0; bx < city_.blocks; ++bx)
                all.push_back(house(x_ * city_.blocks + bx, y_ * city_.blocks + by));
        return all;
    }

  private:
    std::string nameOf(const char* what, int x, int y) const {
        return std::string(what) + "-" + std::to_string(x) + "-" + std::to_string(y);
    }

    Object terrain() const {
        Object object{nameOf("terrain", x_, y_), true, {}};
        const double side = block * city_.blocks;
        for (double y = y_ * side; y < (y_ + 1) * side; y += spacing)
            for (double x = x_ * side; x < (x_ + 1) * side; x += spacing) {
                const auto at = [&](double dx, double dy) {
                    return glm::dvec3(x + dx, y + dy, heightOf(x + dx, y + dy));
                };
                object.faces.push_back({{at(0, 0), at(spacing, 0), at(spacing, spacing)}});
                object.faces.push_back({{at(0, 0), at(spacing, spacing), at(0, spacing)}});
            }
        return object;
    }

    Object house(int bx, int by) const {
        std::mt19937 random(city_.seed * 7919u + static_cast<unsigned>(bx) * 104729u +
                            static_cast<unsigned>(by) * 1299709u);
        const auto whole = [&](int low, int high) {
            return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
        };
        Object object{nameOf("house", bx, by), false, {}};
        const double west = bx * block + whole(3, 6), south = by * block + whole(3, 6);
        const double east = (bx + 1) * block - whole(3, 6), north = (by + 1) * block - whole(3, 6);
        double low = 1e9;
        for (const glm::dvec2& at : {glm::dvec2(west, south), glm::dvec2(east, south),
                                     glm::dvec2(west, north), glm::dvec2(east, north)})
            low = std::min(low, heightOf(at.x, at.y));
        low -= 8.0;
        const int kind = whole(0, 9);
        const double high = low + 8.0 + (kind == 0 ? whole(40, 110) : whole(6, 24));
        const Ring base = rectangle(west, south, east, north, low);
        object.faces.push_back({reversed(base), {}, SurfaceKind::ground});
        if (kind == 0 || kind > 6) {
            addWalls(base, low, high, true, object);
            object.faces.push_back(
                {rectangle(west, south, east, north, high), {}, SurfaceKind::roof});
        } else if (kind < 4) {
            const Ring yard = rectangle(west + 6, south + 6, east - 6, north - 6, high);
            object.faces.front().hole = rectangle(west + 6, south + 6, east - 6, north - 6, low);
            addWalls(base, low, high, true, object);
            addWalls(yard, low, high, false, object);
            object.faces.push_back(
                {rectangle(west, south, east, north, high), reversed(yard), SurfaceKind::roof});
        } else {
            addGables(west, south, east, north, low, high, object);
        }
        return object;
    }

    /// Gabled roofs side by side.
    void addGables(double west, double south, double east, double north, double low, double high,
                   Object& object) const {
        addWalls(rectangle(west, south, east, north, low), low, high, true, object);
        for (int i = 0; i < city_.roofs; ++i) {
            const double from = rounded(west + (east - west) * i / city_.roofs),
                         to = rounded(west + (east - west) * (i + 1) / city_.roofs);
            const double middle = rounded(0.5 * (from + to)),
                         top = high + rounded(0.4 * (to - from));
            const glm::dvec3 a(from, south, high), b(to, south, high), c(to, north, high),
                d(from, north, high), e(middle, south, top), f(middle, north, top);
            object.faces.push_back({{a, e, f, d}, {}, SurfaceKind::roof});
            object.faces.push_back({{e, b, c, f}, {}, SurfaceKind::roof});
            object.faces.push_back({{a, b, e}});
            object.faces.push_back({{c, d, f}});
        }
    }

    const GeneratedCity& city_;
    int x_, y_;
};

std::vector<Object> objectsOf(const GeneratedCity& city, int x, int y) {
    return TileDrawing(city, x, y).objects();
}

/// Triangles of a face; a frame around a hole is four quads.
std::vector<std::array<glm::dvec3, 3>> trianglesOf(const Face& face) {
    std::vector<std::array<glm::dvec3, 3>> triangles;
    const auto addFan = [&](const Ring& ring) {
        for (std::size_t i = 1; i + 1 < ring.size(); ++i)
            triangles.push_back({ring[0], ring[i], ring[i + 1]});
    };
    if (face.hole.empty()) {
        addFan(face.ring);
        return triangles;
    }
    const auto nearest = [&](const glm::dvec3& to) {
        return *std::ranges::min_element(
            face.hole, {}, [&](const glm::dvec3& corner) { return glm::length(corner - to); });
    };
    for (std::size_t i = 0; i < face.ring.size(); ++i) {
        const glm::dvec3 a = face.ring[i], b = face.ring[(i + 1) % face.ring.size()];
        addFan({a, b, nearest(b), nearest(a)});
    }
    return triangles;
}

/// The vertices of a CityJSON file, each once.
class Vertices {
  public:
    int add(const glm::dvec3& place) {
        const std::array<long, 3> at = {std::lround(place.x / step), std::lround(place.y / step),
                                        std::lround(place.z / step)};
        const auto [found, isNew] = numbers_.emplace(at, static_cast<int>(all.size()));
        if (isNew) all.push_back({at[0], at[1], at[2]});
        return found->second;
    }
    Json all = Json::array();

  private:
    std::map<std::array<long, 3>, int> numbers_;
};

Json cityObjectOf(const Object& object, Vertices& vertices) {
    static constexpr const char* names[] = {"", "GroundSurface", "RoofSurface", "WallSurface", ""};
    Json faces = Json::array(), values = Json::array();
    for (const Face& face : object.faces) {
        Json rings = Json::array();
        for (const Ring* ring : {&face.ring, &face.hole}) {
            if (ring->empty()) continue;
            Json corners = Json::array();
            for (const glm::dvec3& corner : *ring)
                corners.push_back(vertices.add(corner));
            rings.push_back(std::move(corners));
        }
        faces.push_back(std::move(rings));
        values.push_back(static_cast<int>(face.kind) - 1);
    }
    if (object.isTerrain)
        return {{"type", "TINRelief"},
                {"geometry",
                 {{{"type", "CompositeSurface"}, {"lod", "1"}, {"boundaries", std::move(faces)}}}}};
    Json surfaces = Json::array();
    for (int i = 1; i <= 3; ++i)
        surfaces.push_back({{"type", names[i]}});
    return {{"type", "Building"},
            {"geometry",
             {{{"type", "Solid"},
               {"lod", "2.2"},
               {"semantics", {{"surfaces", surfaces}, {"values", {std::move(values)}}}},
               {"boundaries", {std::move(faces)}}}}}};
}

Json headerOf(const GeneratedCity& city) {
    return {{"type", "CityJSON"},
            {"version", "2.0"},
            {"transform",
             {{"scale", {step, step, step}},
              {"translate", {city.corner.x, city.corner.y, city.corner.z}}}},
            {"metadata", {{"referenceSystem", "https://www.opengis.net/def/crs/EPSG/0/25832"}}},
            {"CityObjects", Json::object()},
            {"vertices", Json::array()}};
}

std::string tileName(int x, int y, const char* ending) {
    return "tile-" + std::to_string(x) + "-" + std::to_string(y) + ending;
}

template <class Use>
void forEachTile(const GeneratedCity& city, const Use& use) {
    for (int y = 0; y < city.tiles; ++y)
        for (int x = 0; x < city.tiles; ++x)
            use(x, y);
}

/// A tile as a GLB with +Y up, relative to `origin`, with a node for each object.
Bytes glbOf(const std::vector<Object>& objects, const glm::dvec3& origin) {
    Bytes binary;
    Json nodes = Json::array(), meshes = Json::array(), views = Json::array(),
         accessors = Json::array(), roots = Json::array();
    for (const Object& object : objects) {
        glm::dvec3 low(1e9), high(-1e9);
        const std::size_t start = binary.size();
        int count = 0;
        for (const Face& face : object.faces)
            for (const std::array<glm::dvec3, 3>& triangle : trianglesOf(face))
                for (const glm::dvec3& corner : triangle) {
                    const glm::dvec3 at = corner - origin, y(at.x, at.z, -at.y);
                    low = glm::min(low, y);
                    high = glm::max(high, y);
                    for (glm::length_t c = 0; c < 3; ++c) {
                        const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(y[c]));
                        for (unsigned b = 0; b < 32; b += 8)
                            binary.push_back(static_cast<std::uint8_t>(bits >> b));
                    }
                    ++count;
                }
        views.push_back(
            {{"buffer", 0}, {"byteOffset", start}, {"byteLength", binary.size() - start}});
        accessors.push_back({{"bufferView", views.size() - 1},
                             {"componentType", 5126},
                             {"count", count},
                             {"type", "VEC3"},
                             {"min", {low.x, low.y, low.z}},
                             {"max", {high.x, high.y, high.z}}});
        Json primitive;
        primitive["attributes"]["POSITION"] = accessors.size() - 1;
        meshes.push_back({{"primitives", Json::array({primitive})}});
        roots.push_back(nodes.size());
        nodes.push_back({{"name", object.id},
                         {"mesh", meshes.size() - 1},
                         {"translation", {origin.x, origin.z, -origin.y}}});
    }
    const Json json = {{"asset", {{"version", "2.0"}}},
                       {"scene", 0},
                       {"scenes", {{{"nodes", roots}}}},
                       {"nodes", nodes},
                       {"meshes", meshes},
                       {"accessors", accessors},
                       {"bufferViews", views},
                       {"buffers", {{{"byteLength", binary.size()}}}}};
    return joinGlb(json.dump(), std::move(binary));
}

glm::dvec3 originOf(const GeneratedCity& city, int x, int y) {
    const double side = block * city.blocks;
    return {(x + 0.5) * side, (y + 0.5) * side, 0.0};
}

void append(Bytes& bytes, std::uint64_t number, unsigned count) {
    for (unsigned b = 0; b < count; ++b)
        bytes.push_back(static_cast<std::uint8_t>(number >> 8 * b));
}

Bytes b3dmOf(const Bytes& glb, const glm::dvec3& center) {
    std::string table =
        Json{{"BATCH_LENGTH", 0}, {"RTC_CENTER", {center.x, center.y, center.z}}}.dump();
    table.resize((table.size() + 7) / 8 * 8, ' ');
    while ((28 + table.size()) % 8 != 0)
        table += ' ';
    Bytes bytes = {'b', '3', 'd', 'm'};
    append(bytes, 1, 4);
    append(bytes, 28 + table.size() + glb.size(), 4);
    append(bytes, table.size(), 4);
    append(bytes, 0, 4);
    append(bytes, 0, 4);
    append(bytes, 0, 4);
    bytes.insert(bytes.end(), table.begin(), table.end());
    bytes.insert(bytes.end(), glb.begin(), glb.end());
    return bytes;
}

/// The height of a triangle over a point; nothing: it isn't over it.
std::optional<double> heightOver(const std::array<glm::dvec3, 3>& triangle, double x, double y) {
    const auto& [a, b, c] = triangle;
    const auto weight = [&](const glm::dvec3& from, const glm::dvec3& to) {
        return (from.x - x) * (to.y - y) - (from.y - y) * (to.x - x);
    };
    const double ofA = weight(b, c), ofB = weight(c, a), ofC = weight(a, b), sum = ofA + ofB + ofC;
    if (sum == 0.0 || ofA / sum < 0.0 || ofB / sum < 0.0 || ofC / sum < 0.0) return std::nullopt;
    return (ofA * a.z + ofB * b.z + ofC * c.z) / sum;
}

/// A GeoTIFF of floats in one strip (TIFF 6.0, GeoTIFF 1.1).
Bytes tiffOf(const std::vector<float>& pixels, unsigned width, unsigned height, double pixel,
             double west, double north) {
    struct Tag {
        unsigned number, type;
        std::vector<double> values;
    };
    const std::vector<Tag> tags = {
        {256, 4, {double(width)}},
        {257, 4, {double(height)}},
        {258, 3, {32}},
        {259, 3, {1}},
        {262, 3, {1}},
        {273, 4, {8}},
        {277, 3, {1}},
        {278, 4, {double(height)}},
        {279, 4, {4.0 * width * height}},
        {339, 3, {3}},
        {33550, 12, {pixel, pixel, 0}},
        {33922, 12, {0, 0, 0, west, north, 0}},
        {34735, 3, {1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 25832}}};
    Bytes bytes = {'I', 'I', 42, 0};
    append(bytes, 8 + 4 * pixels.size(), 4);
    for (const float value : pixels)
        append(bytes, std::bit_cast<std::uint32_t>(value), 4);
    const std::size_t after = bytes.size() + 2 + 12 * tags.size() + 4;
    Bytes longer;
    append(bytes, tags.size(), 2);
    for (const Tag& tag : tags) {
        const unsigned size = tag.type == 3 ? 2 : tag.type == 4 ? 4 : 8;
        Bytes values;
        for (const double value : tag.values)
            append(values,
                   tag.type == 12 ? std::bit_cast<std::uint64_t>(value)
                                  : static_cast<std::uint64_t>(value),
                   size);
        append(bytes, tag.number, 2);
        append(bytes, tag.type, 2);
        append(bytes, tag.values.size(), 4);
        if (values.size() <= 4) {
            values.resize(4, 0);
            bytes.insert(bytes.end(), values.begin(), values.end());
        } else {
            append(bytes, after + longer.size(), 4);
            longer.insert(longer.end(), values.begin(), values.end());
        }
    }
    append(bytes, 0, 4);
    bytes.insert(bytes.end(), longer.begin(), longer.end());
    return bytes;
}

} // namespace

void GeneratedCity::writeCityJson(const fs::path& folder, bool inOneFile) const {
    Json json = headerOf(*this);
    Vertices vertices;
    const auto write = [&](const std::string& name) {
        json["vertices"] = std::move(vertices.all);
        writeFile(folder / name, std::string_view(json.dump()));
        json = headerOf(*this);
        vertices = Vertices();
    };
    forEachTile(*this, [&](int x, int y) {
        for (const Object& object : objectsOf(*this, x, y))
            json["CityObjects"][object.id] = cityObjectOf(object, vertices);
        if (!inOneFile) write(tileName(x, y, ".city.json"));
    });
    if (inOneFile) write("city.city.json");
}

void GeneratedCity::writeCityJsonSequence(const fs::path& folder) const {
    std::string text = headerOf(*this).dump() + "\n";
    forEachTile(*this, [&](int x, int y) {
        for (const Object& object : objectsOf(*this, x, y)) {
            Vertices vertices;
            Json feature = {{"type", "CityJSONFeature"}, {"id", object.id}};
            feature["CityObjects"][object.id] = cityObjectOf(object, vertices);
            feature["vertices"] = std::move(vertices.all);
            text += feature.dump() + "\n";
        }
    });
    writeFile(folder / "city.city.jsonl", std::string_view(text));
}

void GeneratedCity::writeGltf(const fs::path& folder) const {
    forEachTile(*this, [&](int x, int y) {
        writeFile(folder / tileName(x, y, ".glb"),
                  glbOf(objectsOf(*this, x, y), originOf(*this, x, y)));
    });
}

void GeneratedCity::writeTileset(const fs::path& folder, const sun::Place& place) const {
    const glm::dmat4 ecef = ecefFromEastNorthUp(ecefOf(place, corner.z));
    Json transform = Json::array(), children = Json::array();
    for (glm::length_t i = 0; i < 16; ++i)
        transform.push_back(ecef[i / 4][i % 4]);
    const double reach = side();
    const Json box = {0.5 * reach, 0.5 * reach, 64, 0.5 * reach, 0, 0,
                      0,           0.5 * reach, 0,  0,           0, 128};
    forEachTile(*this, [&](int x, int y) {
        const bool isB3dm = (x + y) % 2 == 1;
        const std::string name = tileName(x, y, isB3dm ? ".b3dm" : ".glb");
        const glm::dvec3 origin = originOf(*this, x, y);
        // A b3dm says its place by RTC_CENTER, a GLB by its nodes.
        const glm::dvec3 center = isB3dm ? origin : glm::dvec3(0.0);
        std::vector<Object> objects = objectsOf(*this, x, y);
        for (Object& object : objects)
            for (Face& face : object.faces)
                for (Ring* ring : {&face.ring, &face.hole})
                    for (glm::dvec3& at : *ring)
                        at -= center;
        const Bytes glb = glbOf(objects, origin - center);
        writeFile(folder / name, isB3dm ? b3dmOf(glb, center) : glb);
        children.push_back({{"boundingVolume", {{"box", box}}},
                            {"geometricError", 0},
                            {"content", {{"uri", name}}}});
    });
    const Json json = {{"asset", {{"version", "1.1"}}},
                       {"geometricError", 100},
                       {"root",
                        {{"transform", transform},
                         {"boundingVolume", {{"box", box}}},
                         {"geometricError", 50},
                         {"refine", "REPLACE"},
                         {"children", children}}}};
    writeFile(folder / "tileset.json", std::string_view(json.dump()));
}

void GeneratedCity::writeRaster(const fs::path& folder, double pixel, unsigned parts) const {
    const auto count = static_cast<unsigned>(std::lround(side() / pixel));
    std::vector<float> heights(std::size_t{count} * count, -1e9f);
    forEachTile(*this, [&](int tileX, int tileY) {
        for (const Object& object : objectsOf(*this, tileX, tileY))
            for (const Face& face : object.faces)
                for (const std::array<glm::dvec3, 3>& triangle : trianglesOf(face)) {
                    Box box;
                    for (const glm::dvec3& corner_ : triangle)
                        box.add(corner_);
                    const auto cell = [&](double at) {
                        return std::clamp(static_cast<int>(at / pixel), 0,
                                          static_cast<int>(count) - 1);
                    };
                    for (int y = cell(box.low.y); y <= cell(box.high.y); ++y)
                        for (int x = cell(box.low.x); x <= cell(box.high.x); ++x)
                            if (const auto height =
                                    heightOver(triangle, (x + 0.5) * pixel, (y + 0.5) * pixel)) {
                                float& best =
                                    heights[(count - 1 - static_cast<unsigned>(y)) * count +
                                            static_cast<unsigned>(x)];
                                best = std::max(best, static_cast<float>(*height + corner.z));
                            }
                }
    });
    const unsigned width = count / parts;
    for (unsigned part = 0; part < parts; ++part) {
        std::vector<float> own;
        for (unsigned row = 0; row < count; ++row)
            for (unsigned column = 0; column < width; ++column)
                own.push_back(heights[std::size_t{row} * count + part * width + column]);
        writeFile(
            folder / ("surface-" + std::to_string(part + 1) + ".tif"),
            tiffOf(own, width, count, pixel, corner.x + part * width * pixel, corner.y + side()));
    }
}

std::size_t GeneratedCity::triangles() const {
    std::size_t count = 0;
    forEachTile(*this, [&](int x, int y) {
        for (const Object& object : objectsOf(*this, x, y))
            for (const Face& face : object.faces)
                count += trianglesOf(face).size();
    });
    return count;
}

} // namespace edgeshade::city
