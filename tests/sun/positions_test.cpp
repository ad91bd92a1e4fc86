// The table of docs/measured/sun-positions.md.
#include "tests/cli/documented.hpp"
#include "tests/sun/judges.hpp"

#include <cstdio>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

struct Row {
    const char* what;
    sun::Place place;
    const char* time;
};

const Row rows[] = {
    {"NREL's example", {39.742476, -105.1786}, "2003-10-17T12:30:30-07:00"},
    {"Munich, summer afternoon", {48.14, 11.57}, "2026-06-21T14:30+02:00"},
    {"Munich, winter noon", {48.14, 11.57}, "2026-12-21T12:00+01:00"},
    {"London, BRE's 21 March, 9 h", {51.51, -0.13}, "2026-03-21T09:00+00:00"},
    {"polar day: Tromsø at midnight", {69.65, 18.96}, "2026-06-21T00:45+02:00"},
    {"polar night: Longyearbyen at noon", {78.22, 15.65}, "2026-12-21T12:00+01:00"},
    {"southern hemisphere: Sydney", {-33.87, 151.21}, "2026-12-21T15:00+11:00"},
    {"southern winter: Punta Arenas", {-53.16, -70.91}, "2026-06-21T12:00-03:00"},
    {"date line: Taveuni, from the east", {-16.8, 180.0}, "2026-03-20T09:00+12:00"},
    {"date line: from the west", {-16.8, -180.0}, "2026-03-19T09:00-12:00"},
    {"leap day: Nairobi", {-1.29, 36.82}, "2024-02-29T15:00+03:00"},
    {"the day after", {-1.29, 36.82}, "2024-03-01T15:00+03:00"},
    {"equator at the equinox, noon", {0.0, 0.0}, "2026-03-20T12:07+00:00"},
    {"North Pole at the solstice", {90.0, 0.0}, "2026-06-21T08:25+00:00"},
    {"South Pole, the same moment", {-90.0, 0.0}, "2026-06-21T08:25+00:00"},
    {"sunset: Quito", {-0.18, -78.47}, "2026-09-23T18:10-05:00"},
    {"1900", {52.37, 4.9}, "1900-01-01T12:00+00:00"},
    {"2100", {52.37, 4.9}, "2100-12-31T12:00+00:00"},
};

} // namespace

TEST(SunPositions, AreDocumentedBesideTheJudges) {
    std::vector<std::string> lines;
    for (const Row& row : rows) {
        const sun::Instant time = sun::localTimeFromText(row.time).instant;
        const auto ours = sun::sunPosition(row.place, time);
        const Judgement full = fullModel(row.place, time);
        const double offFull = apart(full, ours), offNova = apart(libnova(row.place, time), ours);
        EXPECT_LT(offFull, 0.01) << row.what;
        EXPECT_LT(offNova, 0.01) << row.what;
        char line[400];
        std::snprintf(line, sizeof line,
                      "| %s | %g, %g | %s | %.3f | %.3f | %.3f | %.3f | %.3f | %.4f | %.4f |",
                      row.what, row.place.latitude, row.place.longitude, row.time, ours.azimuth,
                      ours.airlessAltitude, ours.altitude, full.azimuth, full.altitude, offFull,
                      offNova);
        lines.push_back(line);
    }
    expectDocumented("positions", lines, "measured/sun-positions.md");
}

} // namespace edgeshade::test
