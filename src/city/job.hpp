#pragma once

#include "preprocess/base/parallel.hpp"
#include "src/city/job_result.hpp"
#include "src/city/plan_file.hpp"

#include <functional>

namespace edgeshade::city {

/// Computes a job by certified rays (src/rays/): the sun positions that light each cell's top
/// surface. The result depends on the plan and its sources alone. `job`: from 1. `progress` gets
/// the share done and what is being done.
///
/// Throws InputError: a source can't be read, or isn't the one that was planned. Throws
/// Error(usage): the plan has no such job.
JobResult runJob(const ReadPlan& read, std::size_t job,
                 const std::function<void(double, const std::string&)>& progress,
                 Threads threads = {});

} // namespace edgeshade::city
