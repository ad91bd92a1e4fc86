#include "src/city/job_result.hpp"

#include "src/city/byte_text.hpp"
#include "src/city/cell_range_json.hpp"
#include "src/city/json_text.hpp"
#include "src/city/top_surface.hpp"
#include "src/image/zlib.hpp"

#include <algorithm>
#include <bit>

namespace edgeshade::city {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t version = 1;
constexpr const char* versionKey = "edgeshade_city_job";
constexpr std::uint64_t mostCells = std::uint64_t{1} << 26;

static_assert(std::endian::native == std::endian::little); // as files are

template <class Number>
void append(Bytes& bytes, const std::vector<Number>& numbers) {
    const auto* const first = reinterpret_cast<const std::uint8_t*>(numbers.data());
    bytes.insert(bytes.end(), first, first + sizeof(Number) * numbers.size());
}

/// Fills numbers from the front of bytes, which it removes.
template <class Number>
void take(std::span<const std::uint8_t>& bytes, std::vector<Number>& numbers) {
    const std::size_t size = sizeof(Number) * numbers.size();
    std::copy_n(bytes.begin(), size, reinterpret_cast<std::uint8_t*>(numbers.data()));
    bytes = bytes.subspan(size);
}

std::size_t bytesOfCells(const JobResult& result) {
    return result.cells.count() *
           bytesOfCell(!result.months.empty(), !result.bits.empty(), result.positions);
}

JobResult headerFrom(const JsonField& root) {
    root.requireObject();
    root.requireVersion(versionKey, version);
    JobResult result;
    result.plan = root.member("plan").text();
    result.job = root.member("job").wholeNumber();
    const JsonField cells = root.member("cells");
    result.cells = cellRangeFrom(cells);
    const auto columns = static_cast<std::uint64_t>(result.cells.columns()),
               rows = static_cast<std::uint64_t>(result.cells.rows());
    if (columns > mostCells || rows > mostCells / columns)
        cells.fail(" is " + cells.value().dump() + ", which is no range of cells");
    result.positions = root.member("positions").wholeNumber(65535);
    const bool months = root.member("months").boolean(), bits = root.member("bits").boolean();
    if (bytesOfCell(months, bits, result.positions) * result.cells.count() > mostBytesOfCells)
        cells.fail(" is " + cells.value().dump() + ", which is more cells than a result has");
    if (months) result.months.resize(monthsOfYear * result.cells.count());
    if (bits) result.bits.resize(hours::bytesOfRow(result.positions) * result.cells.count());
    root.member("objects").forEachItem([&](const JsonField& object) {
        result.named.push_back({object.member("source").wholeNumber(), object.member("id").text(),
                                object.member("building").boolean()});
    });
    return result;
}

void readCells(std::span<const std::uint8_t> bytes, const JsonField& root, JobResult& result) {
    const std::size_t count = result.cells.count();
    result.lit.resize(count);
    result.objects.resize(count);
    result.kinds.resize(count);
    take(bytes, result.lit);
    take(bytes, result.objects);
    take(bytes, result.kinds);
    take(bytes, result.months);
    take(bytes, result.bits);
    for (std::size_t i = 0; i < count; ++i) {
        const bool isObject = result.objects[i] < result.named.size();
        if (result.lit[i] > result.positions || result.kinds[i] > SurfaceKind::other ||
            (!isObject && result.objects[i] != noSurface))
            root.fail(": cell " + std::to_string(i) + " is invalid");
    }
}

} // namespace

std::size_t bytesOfCell(bool months, bool bits, std::size_t positions) {
    return 2 + 4 + 1 + (months ? 2 * monthsOfYear : 0) + (bits ? hours::bytesOfRow(positions) : 0);
}

std::string fileNameOfJob(std::size_t job) {
    return "job-" + std::to_string(job) + ".city";
}

Bytes bytesOfResult(const JobResult& result) {
    Json objects = Json::array();
    for (const ResultObject& object : result.named)
        objects.push_back(
            {{"source", object.source}, {"id", object.id}, {"building", object.isBuilding}});
    const Json header = {{versionKey, version},
                         {"plan", result.plan},
                         {"job", result.job},
                         {"cells", jsonOf(result.cells)},
                         {"positions", result.positions},
                         {"months", !result.months.empty()},
                         {"bits", !result.bits.empty()},
                         {"objects", std::move(objects)}};
    Bytes planes;
    planes.reserve(bytesOfCells(result));
    append(planes, result.lit);
    append(planes, result.objects);
    append(planes, result.kinds);
    append(planes, result.months);
    append(planes, result.bits);
    const std::string text = header.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    Bytes bytes(text.begin(), text.end());
    const Bytes stream = deflated(planes);
    bytes.insert(bytes.end(), stream.begin(), stream.end());
    return bytes;
}

JobResult resultFrom(const std::filesystem::path& path) {
    const Bytes bytes = readFile(path);
    const std::string_view text = textOf(bytes);
    const std::size_t end = std::min(text.find('\n'), text.size());
    const Json json =
        jsonFrom(text.substr(0, end), "'" + path.string() + "' is not a result of city run");
    const JsonField root(path, json, "the header");
    JobResult result = headerFrom(root);
    const auto stream = std::span(bytes).subspan(std::min(end + 1, bytes.size()));
    const std::optional<Bytes> planes = inflated(stream, bytesOfCells(result));
    if (!planes)
        throw InputError("'" + path.string() + "' is cut short or broken: its " +
                         std::to_string(result.cells.count()) + " cells can't be read.");
    readCells(*planes, root, result);
    return result;
}

} // namespace edgeshade::city
