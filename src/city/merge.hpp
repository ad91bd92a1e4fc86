#pragma once

#include "src/city/city_hours.hpp"
#include "src/city/plan_file.hpp"

#include <functional>
#include <nlohmann/json.hpp>

namespace edgeshade::city {

/// Joins the results of all jobs, from the folder `results`, and writes into `output` hours.tif,
/// objects.csv, preview.png, report.json, with the plan's months and bits months.tif and bits.npy,
/// and for each CityJSON source a file with hours, named hours-… beside where the source was. All
/// files appear once all are complete. Holds the results and objects of jobs that one row of cells
/// crosses, no matter how many rows there are. `color`: 0xRRGGBB of a share of the most hours.
/// `progress` gets the share done. Returns the report.
///
/// Throws InputError: a result is missing or invalid, or a CityJSON source isn't the one that was
/// planned. Throws Error(output), and Error(unavailable) without libgeotiff.
nlohmann::ordered_json mergeCity(const ReadPlan& read, const std::filesystem::path& results,
                                 const std::filesystem::path& output,
                                 const std::function<std::uint32_t(double share)>& color,
                                 const std::function<void(double)>& progress);

} // namespace edgeshade::city
