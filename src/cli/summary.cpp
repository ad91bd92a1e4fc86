#include "src/cli/summary.hpp"

#include "preprocess/packing/parts_json.hpp"
#include "src/shadow/view/scene_cameras.hpp"

#include <iomanip>
#include <sstream>

namespace edgeshade::cli {
namespace {

/// A count with separators: 1,234,567.
std::string grouped(std::size_t value) {
    std::string digits = std::to_string(value);
    for (std::size_t at = digits.size(); at > 3; at -= 3)
        digits.insert(at - 3, ",");
    return digits;
}

} // namespace

std::string summaryOf(const PackReport& report) {
    const MeshStatistics& casters = report.casters;
    const auto json = toJson(report);
    std::ostringstream text;
    const auto row = [&](const std::string& name) -> std::ostream& {
        return text << std::left << std::setw(26) << name;
    };
    row("diagonal") << report.diagonal << " scene units\n";
    row("triangles") << grouped(report.triangles) << ", casting " << grouped(casters.triangles);
    if (report.settings.casterError > 0.0)
        text << ", simplified from " << grouped(report.castingSurfaceTriangles);
    text << ", degenerate " << grouped(casters.degenerateTriangles) << ", single-sided "
         << grouped(report.singleSidedTriangles) << "\n";
    row("edges") << grouped(casters.edges) << "\n";
    for (const auto& [n, count] : casters.edgesByOppositeCount)
        row("  with " + std::to_string(n) + (n == 1 ? " triangle" : " triangles"))
            << grouped(count) << "\n";
    row("components") << grouped(casters.components) << ", closed and oriented triangles "
                      << grouped(casters.closedOrientedTriangles) << "\n";
    row("records") << grouped(report.planePairs.records) << ", flat edges dropped "
                   << grouped(report.planePairs.flatEdges) << "\n";
    if (report.weldChoice) {
        const WeldChoice& choice = *report.weldChoice;
        row("weld tolerance chosen")
            << choice.tolerance << " scene units: open edges " << grouped(choice.before.borders)
            << " -> " << grouped(choice.after.borders) << ", quads " << grouped(choice.before.quads)
            << " -> " << grouped(choice.after.quads) << "\n";
    }
    row("vertex runs per light") << grouped(json["vertex_runs"]["sides"].get<std::size_t>())
                                 << " sides, "
                                 << grouped(json["vertex_runs"]["caps"].get<std::size_t>())
                                 << " caps, published "
                                 << grouped(json["vertex_runs"]["published"].get<std::size_t>())
                                 << "\n";
    row("bytes on the GPU") << grouped(json["bytes"]["sides"].get<std::size_t>()) << " sides, "
                            << grouped(json["bytes"]["caps"].get<std::size_t>()) << " caps\n";
    row("bytes in the file") << grouped(report.storedBytes) << " for shadow data, of "
                             << grouped(report.fileBytes) << "\n";
    row("seconds") << std::fixed << std::setprecision(3) << report.readSeconds << " read, "
                   << report.build.weld << " weld, " << report.build.edges << " edges, "
                   << report.build.pack << " pack";
    return text.str();
}

std::string choicesOf(const PackReport& report) {
    std::ostringstream text;
    const auto row = [&](const std::string& name) -> std::ostream& {
        return text << "\n" << std::left << std::setw(26) << name;
    };
    for (const std::string& name : report.variants)
        row("variant") << name;
    for (const AnimationTitle& title : report.animations)
        row("animation " + std::to_string(title.index)) << title.name;
    for (std::size_t i = 0; i < report.cameras.size(); ++i) {
        const SceneCamera& camera = report.cameras[i];
        row("camera " + std::to_string(i)) << titleOf(report.cameras, i);
        if (!camera.nodeName.empty() && !camera.name.empty())
            text << " of node " << camera.nodeName;
        if (camera.orthographic)
            text << ", orthographic, " << camera.height << " scene units high";
        else
            text << ", " << glm::degrees(camera.height) << " degrees";
    }
    for (std::size_t i = 0; i < report.lights.size(); ++i) {
        const SceneLight& light = report.lights[i];
        row("light " + std::to_string(i)) << nameOf(light.kind);
        for (const std::string& name : {light.name, light.nodeName})
            if (!name.empty()) text << ", " << name;
    }
    return text.str();
}

} // namespace edgeshade::cli
