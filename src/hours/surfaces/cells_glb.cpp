#include "src/hours/surfaces/cells_glb.hpp"

#include "preprocess/base/box.hpp"
#include "preprocess/gltf/glb.hpp"
#include "src/hours/exposure.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace edgeshade::hours {
namespace {

using Json = nlohmann::ordered_json;

// Numbers of glTF 2.0, 5.1.3, 5.11.5.
constexpr int unsignedShort = 5123, unsignedInt = 5125, floats = 5126;
constexpr int arrayBuffer = 34962, elementArrayBuffer = 34963;

/// Colour of cells that are left out, linear: a middle grey.
constexpr double leftOutGrey = 0.2;

/// Corners of one mesh.
struct MeshArrays {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::u16vec4> colors; ///< normalised
    std::vector<float> hours, energies;
    std::vector<std::uint32_t> indices;
};

std::uint16_t shortOf(double linear) {
    return static_cast<std::uint16_t>(std::lround(65535.0 * std::clamp(linear, 0.0, 1.0)));
}

void addCell(const SurfaceRun& run, std::size_t number, const glm::dvec3& origin,
             const glm::u16vec4& color, MeshArrays& to) {
    const SurfaceCells& cells = run.cells;
    const Cell& cell = cells.cells[number];
    for (std::uint32_t f = cell.firstFace; f < cell.firstFace + cell.faceCount; ++f) {
        const CellFace& face = cells.faces[f];
        const auto first = static_cast<std::uint32_t>(to.positions.size());
        for (std::uint32_t i = 0; i < face.cornerCount; ++i) {
            to.positions.emplace_back(cells.corners[face.firstCorner + i] - origin);
            to.normals.emplace_back(cell.normal);
            to.colors.push_back(color);
            to.hours.push_back(static_cast<float>(run.hoursOf(number)));
            if (!run.light.directKwh.empty())
                to.energies.push_back(static_cast<float>(run.light.directKwh[number]));
            if (i < 2) continue;
            to.indices.insert(to.indices.end(), {first, first + i - 1, first + i});
        }
    }
}

/// Builds the JSON and the binary chunk.
class Asset {
  public:
    explicit Asset(const glm::dvec3& origin) : origin_(origin) {}

    void add(const std::string& name, const MeshArrays& arrays) {
        Json attributes = {{"POSITION", accessor(arrays.positions, floats, "VEC3", arrayBuffer)},
                           {"NORMAL", accessor(arrays.normals, floats, "VEC3", arrayBuffer)},
                           {"COLOR_0", accessor(arrays.colors, unsignedShort, "VEC4", arrayBuffer)},
                           {"_HOURS", accessor(arrays.hours, floats, "SCALAR", arrayBuffer)}};
        accessors_[attributes["POSITION"].get<std::size_t>()].update(boundsJson(arrays.positions));
        accessors_[attributes["COLOR_0"].get<std::size_t>()]["normalized"] = true;
        if (!arrays.energies.empty())
            attributes["_DIRECT_KWH"] = accessor(arrays.energies, floats, "SCALAR", arrayBuffer);
        const Json indices = accessor(arrays.indices, unsignedInt, "SCALAR", elementArrayBuffer);
        nodes_.push_back({{"name", name},
                          {"mesh", meshes_.size()},
                          {"translation", {origin_.x, origin_.y, origin_.z}}});
        meshes_.push_back(
            {{"name", name},
             {"primitives",
              {{{"attributes", attributes}, {"indices", indices}, {"material", 0}}}}});
    }

    Bytes glb(const Json& extras) && {
        Json roots = Json::array();
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            roots.push_back(i);
        Json json = {
            {"asset", {{"version", "2.0"}, {"generator", "edgeshade"}, {"extras", extras}}},
            {"extensionsUsed", {"KHR_materials_unlit"}},
            {"scene", 0}};
        // glTF allows no empty arrays.
        Json scene = {{"name", "hours of sun"}};
        if (!nodes_.empty()) {
            scene["nodes"] = roots;
            json["nodes"] = nodes_;
            json["meshes"] = meshes_;
            json["accessors"] = accessors_;
            json["bufferViews"] = views_;
            json["buffers"] = {{{"byteLength", binary_.size()}}};
        }
        json["scenes"] = {scene};
        json["materials"] = {{{"name", "hours"},
                              {"extensions", {{"KHR_materials_unlit", Json::object()}}},
                              {"pbrMetallicRoughness", {{"metallicFactor", 0.0}}}}};
        return joinGlb(json.dump(-1, ' ', false, Json::error_handler_t::replace),
                       std::move(binary_));
    }

  private:
    template <class T>
    std::size_t accessor(const std::vector<T>& values, int componentType, const char* type,
                         int target) {
        views_.push_back({{"buffer", 0},
                          {"byteOffset", binary_.size()},
                          {"byteLength", values.size() * sizeof(T)},
                          {"target", target}});
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(values.data());
        binary_.insert(binary_.end(), bytes, bytes + values.size() * sizeof(T));
        accessors_.push_back({{"bufferView", views_.size() - 1},
                              {"componentType", componentType},
                              {"count", values.size()},
                              {"type", type}});
        return accessors_.size() - 1;
    }

    static Json boundsJson(const std::vector<glm::vec3>& positions) {
        glm::vec3 low = positions.front(), high = low;
        for (const glm::vec3& position : positions) {
            low = glm::min(low, position);
            high = glm::max(high, position);
        }
        return {{"min", {low.x, low.y, low.z}}, {"max", {high.x, high.y, high.z}}};
    }

    glm::dvec3 origin_;
    Json nodes_ = Json::array(), meshes_ = Json::array(), accessors_ = Json::array(),
         views_ = Json::array();
    Bytes binary_;
};

} // namespace

Bytes glbOf(const SurfaceRun& run, const CellColor& color, double most) {
    Box box;
    for (const glm::dvec3& corner : run.cells.corners)
        box.add(corner);
    const bool energies = !run.light.directKwh.empty();
    std::map<std::uint32_t, MeshArrays> byNode;
    for (std::size_t i = 0; i < run.cells.cells.size(); ++i) {
        const double value = energies ? run.light.directKwh[i] : run.hoursOf(i);
        const glm::dvec3 linear = run.isCounted(i) ? color(value / most) : glm::dvec3(leftOutGrey);
        addCell(run, i, box.center(),
                {shortOf(linear.r), shortOf(linear.g), shortOf(linear.b), 65535},
                byNode[run.cells.triangleOf(run.cells.cells[i]).node]);
    }
    Asset asset(box.center());
    for (const auto& [node, arrays] : byNode)
        asset.add(run.nodes.at(node), arrays);
    return std::move(asset).glb({{"quantity", energies ? "direct-kwh" : "hours"}, {"most", most}});
}

} // namespace edgeshade::hours
