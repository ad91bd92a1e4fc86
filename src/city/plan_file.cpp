#include "src/city/plan_file.hpp"

#include "preprocess/base/sha256.hpp"
#include "preprocess/gltf/json_vectors.hpp"
#include "src/city/byte_text.hpp"
#include "src/city/cell_range_json.hpp"
#include "src/city/json_text.hpp"
#include "src/hours/settings.hpp"

namespace edgeshade::city {
namespace {

using Json = nlohmann::ordered_json;
using std::chrono::minutes;

constexpr std::uint64_t planVersion = 1;
constexpr const char* planKey = "edgeshade_city_plan";

Json jsonOf(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}
Json jsonOf(const glm::dmat4& matrix) {
    Json json = Json::array();
    for (glm::length_t i = 0; i < 16; ++i)
        json.push_back(matrix[i / 4][i % 4]);
    return json;
}

Json jsonOf(const hours::Schedule& schedule) {
    return {{"place", {schedule.place.latitude, schedule.place.longitude}},
            {"utc_offset", sun::textOf(schedule.offset)},
            {"from", sun::textOf(schedule.from)},
            {"to", sun::textOf(schedule.to)},
            {"step", schedule.step.count()},
            {"min_altitude", schedule.minAltitude},
            {"north", schedule.north}};
}

Json jsonOf(const PlannedSource& planned) {
    Json json = {{"file", planned.source.file},
                 {"kind", sourceKindNames[static_cast<std::size_t>(planned.source.kind)]},
                 {"bytes", planned.bytes},
                 {"sha256", planned.sha256},
                 {"triangles", planned.triangles},
                 {"box", nullptr}};
    if (!planned.box.empty()) json["box"] = {jsonOf(planned.box.low), jsonOf(planned.box.high)};
    if (planned.source.kind == SourceKind::gltf || planned.source.kind == SourceKind::b3dm)
        json["transform"] = jsonOf(planned.source.frameFromTile);
    return json;
}

Json jsonOf(const Job& job, std::size_t number) {
    return {{"job", number},
            {"cells", jsonOf(job.cells)},
            {"lowest", job.lowest},
            {"sources", job.sources},
            {"memory", job.memory}};
}

hours::Schedule scheduleOf(const JsonField& field) {
    hours::Schedule schedule;
    const std::vector<double> place = field.member("place").numbers(2);
    schedule.place = {place[0], place[1]};
    if (!(std::abs(place[0]) <= 90.0 && std::abs(place[1]) <= 180.0))
        field.member("place").fail(" is no latitude and longitude");
    schedule.offset = hours::readAs(field.member("utc_offset"), sun::offsetFromText);
    schedule.from = hours::readAs(field.member("from"), sun::dateFromText);
    schedule.to = hours::readAs(field.member("to"), sun::dateFromText);
    schedule.step = minutes(field.member("step").wholeNumber(1440));
    schedule.minAltitude = field.member("min_altitude").notNegative();
    schedule.north = field.member("north").number();
    return schedule;
}

PlannedSource sourceOf(const JsonField& field) {
    PlannedSource planned;
    const JsonField file = field.member("file");
    planned.source.file = file.text();
    if (!staysInside(planned.source.file))
        file.fail(" is '" + planned.source.file + "', but must be below the folder");
    const JsonField kind = field.member("kind");
    const std::string word = kind.oneOf({sourceKindNames[0], sourceKindNames[1], sourceKindNames[2],
                                         sourceKindNames[3], sourceKindNames[4]});
    for (std::size_t i = 0; i < std::size(sourceKindNames); ++i)
        if (word == sourceKindNames[i]) planned.source.kind = static_cast<SourceKind>(i);
    planned.bytes = field.member("bytes").wholeNumber();
    planned.sha256 = field.member("sha256").text();
    planned.triangles = field.member("triangles").wholeNumber();
    const JsonField box = field.member("box");
    if (!box.value().is_null()) {
        box.requireArray();
        if (box.size() != 2) box.fail(" is not two corners");
        planned.box.add(vectorFrom(box.item(0)));
        planned.box.add(vectorFrom(box.item(1)));
    }
    field.ifPresent("transform", [&](const JsonField& transform) {
        planned.source.frameFromTile = matrixFrom(transform);
    });
    return planned;
}

Job jobOf(const JsonField& field, std::size_t sources) {
    Job job;
    job.cells = cellRangeFrom(field.member("cells"));
    job.lowest = field.member("lowest").number();
    field.member("sources").forEachItem([&](const JsonField& source) {
        job.sources.push_back(static_cast<std::size_t>(source.indexInto(sources, "sources")));
    });
    job.memory = field.member("memory").wholeNumber();
    return job;
}

} // namespace

std::string textOf(const Plan& plan) {
    Json sources = Json::array(), jobs = Json::array();
    for (const PlannedSource& source : plan.sources)
        sources.push_back(jsonOf(source));
    for (const Job& job : plan.jobs)
        jobs.push_back(jsonOf(job, jobs.size() + 1));
    const Json json = {{planKey, planVersion},
                       {"folder", plan.folder.generic_string()},
                       {"epsg", plan.epsg ? Json(*plan.epsg) : Json(nullptr)},
                       {"lod", plan.reading.lod ? Json(*plan.reading.lod) : Json(nullptr)},
                       {"schedule", jsonOf(plan.schedule)},
                       {"grid", plan.grid},
                       {"months", plan.months},
                       {"bits", plan.bits},
                       {"region", jsonOf(plan.region)},
                       {"sources", std::move(sources)},
                       {"jobs", std::move(jobs)}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

ReadPlan planFrom(const std::filesystem::path& path) {
    const Bytes bytes = readFile(path);
    const Json json = jsonFrom(textOf(bytes), "'" + path.string() + "' is not a plan of city plan");
    const JsonField root(path, json);
    root.requireObject();
    root.requireVersion(planKey, planVersion);
    ReadPlan read{{}, sha256(bytes)};
    Plan& plan = read.plan;
    plan.folder = path.parent_path() / root.member("folder").text();
    const JsonField epsg = root.member("epsg"), lod = root.member("lod");
    if (!epsg.value().is_null()) plan.epsg = epsg.index();
    if (!lod.value().is_null()) plan.reading.lod = lod.number();
    plan.schedule = scheduleOf(root.member("schedule"));
    plan.grid = root.member("grid").positive();
    plan.months = root.member("months").boolean();
    plan.bits = root.member("bits").boolean();
    plan.region = cellRangeFrom(root.member("region"));
    root.member("sources").forEachItem(
        [&](const JsonField& source) { plan.sources.push_back(sourceOf(source)); });
    root.member("jobs").forEachItem([&](const JsonField& job) {
        plan.jobs.push_back(jobOf(job, plan.sources.size()));
        const CellRange& cells = plan.jobs.back().cells;
        if (cells.left < plan.region.left || cells.bottom < plan.region.bottom ||
            cells.right > plan.region.right || cells.top > plan.region.top)
            job.member("cells").fail(" reaches out of the region");
    });
    return read;
}

} // namespace edgeshade::city
