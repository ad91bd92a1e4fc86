#include "src/hours/surfaces/surface_part_file.hpp"

#include "src/hours/part_file.hpp"
#include "src/hours/part_json.hpp"
#include "src/hours/settings.hpp"
#include "src/hours/surfaces/cell_arrays.hpp"

#include <cmath>

namespace edgeshade::hours {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t surfacesVersion = 1;
constexpr const char* surfacesKey = "edgeshade_sunhours_surfaces_part";

Json arraysJson(const CellArrays& arrays) {
    Json json;
    forEachArray([&](const ArrayName& name, auto array) {
        Json& group = json[name.group];
        group["count"] = (arrays.*array).size() / name.components;
        group[name.member] = packed(std::span(arrays.*array));
    });
    return json;
}

CellArrays arraysFrom(const JsonField& root, const std::filesystem::path& path) {
    CellArrays arrays;
    std::uint64_t bytes = 0;
    forEachArray([&](const ArrayName& name, auto array) {
        auto& values = arrays.*array;
        using Value = typename std::remove_reference_t<decltype(values)>::value_type;
        const JsonField group = root.member(name.group), count = group.member("count"),
                        member = group.member(name.member);
        const std::size_t size = name.components * count.wholeNumber(mostBytesOfPart);
        bytes += size * sizeof(Value);
        if (bytes > mostBytesOfPart)
            count.fail(" makes more than the " + std::to_string(mostBytesOfPart) +
                       " bytes of a part");
        values = unpacked<Value>(member, path, size);
        if constexpr (std::is_floating_point_v<Value>)
            for (std::size_t i = 0; i < size; ++i)
                if (!std::isfinite(values[i]))
                    member.fail(" of " + std::string(name.element) + " " +
                                std::to_string(i / name.components) + " is not finite");
    });
    return arrays;
}

/// Checks that everything that arrays refer to exists.
class Checks {
  public:
    Checks(const JsonField& root, const SurfaceRun& run) : root_(root), run_(run) {}

    void check(const CellArrays& arrays) const {
        std::size_t chosen = 0;
        for (std::size_t t = 0; t < arrays.node.size(); ++t) {
            if (arrays.chosen[t] > 1)
                fail("triangles", "chosen", t, arrays.chosen[t], "is neither 0 nor 1");
            if (arrays.chosen[t] == 0) continue;
            ++chosen;
            if (!run_.nodes.contains(arrays.node[t]))
                fail("triangles", "node", t, arrays.node[t], "has no name");
            if (!run_.materials.contains(arrays.material[t]))
                fail("triangles", "material", t, arrays.material[t], "has no name");
        }
        const std::size_t faces = arrays.firstCorner.size(),
                          corners = arrays.faceCorners.size() / 3;
        for (std::size_t i = 0; i < arrays.area.size(); ++i) {
            if (arrays.area[i] < 0.0) fail("cells", "area", i, arrays.area[i], "is below 0");
            if (arrays.triangle[i] >= chosen)
                fail("cells", "triangle", i, arrays.triangle[i], "is no chosen triangle's number");
            if (arrays.state[i] > static_cast<std::uint8_t>(CellState::within))
                fail("cells", "state", i, arrays.state[i], "is neither 0 nor 1 nor 2");
            if (arrays.faceCount[i] < 1 ||
                std::uint64_t{arrays.firstFace[i]} + arrays.faceCount[i] > faces)
                fail("cells", "face_count", i, arrays.faceCount[i],
                     "is 0 or reaches beyond the last face");
        }
        for (std::size_t f = 0; f < faces; ++f)
            if (arrays.cornerCount[f] < 3 ||
                std::uint64_t{arrays.firstCorner[f]} + arrays.cornerCount[f] > corners)
                fail("faces", "corner_count", f, arrays.cornerCount[f],
                     "is below 3 or reaches beyond the last corner");
    }

  private:
    [[noreturn]] void fail(const char* group, const char* member, std::size_t i, double value,
                           const char* what) const {
        const JsonField in = root_.member(group);
        in.member(member).fail(" at " + std::to_string(i) + " is " + Json(value).dump() +
                               ", which " + what);
    }

    const JsonField& root_;
    const SurfaceRun& run_;
};

/// Sets the members that follow from a run's settings.
void setBySettings(const JsonField& field, SurfaceRun& run) {
    run.step = hoursSettings(field).step;
    const JsonField surfaces = field.member("surfaces");
    run.unit = surfaces.member("unit").positive();
    const JsonField windows = surfaces.member("windows");
    windows.requireArray();
    run.ofWindows = windows.size() > 0;
}

std::vector<std::uint8_t> bitsFrom(const JsonField& root, const std::filesystem::path& path,
                                   std::size_t cells, std::size_t positions) {
    const JsonField field = root.member("bits");
    const std::size_t row = bytesOfRow(positions);
    if (cells * row > mostBytesOfPart)
        field.fail(" has more than the " + std::to_string(mostBytesOfPart) + " bytes of a part");
    std::vector<std::uint8_t> bits = unpacked<std::uint8_t>(field, path, cells * row);
    if (positions % 8 != 0)
        for (std::size_t i = 0; i < cells; ++i)
            if ((bits[(i + 1) * row - 1] & 0xFF >> positions % 8) != 0)
                field.fail(" of cell " + std::to_string(i) + " has bits beyond the part's " +
                           std::to_string(positions) + " positions");
    return bits;
}

std::vector<double> beamFrom(const JsonField& field, const std::filesystem::path& path,
                             std::size_t positions) {
    if (field.value().is_null()) return {};
    std::vector<double> beam = unpacked<double>(field, path, positions);
    for (std::size_t i = 0; i < positions; ++i)
        if (!std::isfinite(beam[i]) || beam[i] < 0.0)
            field.fail(" has the number " + Json(beam[i]).dump() + " at " + std::to_string(i) +
                       ", but must be finite and not below 0");
    return beam;
}

} // namespace

std::uint64_t bytesOfPart(const SurfaceCells& cells, std::size_t trianglesOfScene,
                          std::size_t positions) {
    constexpr std::uint64_t ofTriangle = 9 * 8 + 2 * 4 + 1, ofCell = 7 * 8 + 3 * 4 + 1,
                            ofFace = 2 * 4, ofCorner = 3 * 8;
    return ofTriangle * trianglesOfScene + (ofCell + bytesOfRow(positions)) * cells.cells.size() +
           ofFace * cells.faces.size() + ofCorner * cells.corners.size();
}

std::string textOf(const SurfacePart& part) {
    const SurfaceRun& run = part.run;
    Json positions = Json::array();
    for (const Position& position : run.positions)
        positions.push_back(jsonOf(position, run.offset));
    Json json = {{surfacesKey, surfacesVersion},
                 {"part", part.number},
                 {"parts", part.of},
                 {"scene", run.scene},
                 {"version", run.version},
                 {"files", run.files},
                 {"settings", run.settings},
                 {"warnings", run.warnings},
                 {"positions_of_run", part.positionsOfRun},
                 {"positions", std::move(positions)},
                 {"beam", part.beam.empty() ? Json(nullptr) : Json(packed(std::span(part.beam)))},
                 {"materials", namesJson(run.materials)},
                 {"nodes", namesJson(run.nodes)}};
    json.update(arraysJson(arraysOf(run.cells, part.scene)));
    json["bits"] = packed(std::span(run.light.bits));
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

bool isSurfacePart(const Json& json) {
    return json.is_object() && json.contains(surfacesKey);
}

SurfacePart surfacePartFrom(const std::filesystem::path& path, const Json& json) {
    const JsonField root(path, json);
    root.requireObject();
    root.requireVersion(surfacesKey, surfacesVersion);
    SurfacePart part;
    static_cast<PartNumber&>(part) = partNumberFrom(root);
    SurfaceRun& run = part.run;
    static_cast<RunHead&>(run) = runHeadFrom(root, part);
    run.version = root.member("version").text();
    run.files = root.member("files").value();
    setBySettings(root.member("settings"), run);
    part.beam = beamFrom(root.member("beam"), path, part.positionsOfRun);
    const CellArrays arrays = arraysFrom(root, path);
    if (arrays.area.empty())
        root.member("cells").member("count").fail(" is 0, but must be 1 or more");
    Checks(root, run).check(arrays);
    run.cells = cellsOf(arrays);
    part.scene = sceneOf(arrays);
    run.light.bits = bitsFrom(root, path, arrays.area.size(), run.positions.size());
    return part;
}

} // namespace edgeshade::hours
