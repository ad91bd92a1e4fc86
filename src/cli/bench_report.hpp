#pragma once

#include "src/bench/bench.hpp"
#include "src/cli/draw_settings.hpp"
#include "src/cli/options.hpp"
#include "src/cli/report.hpp"

#include <chrono>

namespace edgeshade::cli {

/// A setting with its name in reports.
struct BenchSetting {
    std::string name;
    DrawSettings settings;
    std::shared_ptr<const LoadedScene> scene; ///< the scene with the setting's casters; null: the
                                              ///< call's own
};

/// The setting as the benchmark takes it.
bench::Setting toTask(const BenchSetting& setting);

/// The flight that the program measures, or the typed camera, which stays in place.
std::function<Frustum(double)> flightFor(const ViewOptions& view, const Scene& scene);

/// Meanings of the words of `--timing`.
inline const std::vector timings{gl::Timing::query, gl::Timing::finish, gl::Timing::processor};

/// A warning that figures of this device are those of a processor.
std::string softwareWarning(const gl::Capabilities& device);

/// Its word in `--timing`.
const std::string& nameOf(gl::Timing timing);

/// A progress bar that estimates the remaining time.
class Countdown {
  public:
    void show(double share, const std::string& doing);

  private:
    ProgressBar bar_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The report of `bench`: the JSON keys of its contract, and a table.
class BenchReport {
  public:
    std::vector<std::string> warnings;                               ///< from loading
    CasterSettings casters;                                          ///< the call's casters
    nlohmann::ordered_json scene = nlohmann::ordered_json::object(); ///< sceneJson()

    /// Adds the results for one size; `settings` in the order of the task's.
    void add(const bench::Task& task, const std::vector<BenchSetting>& settings,
             const bench::Report& measured);

    /// Warnings that limit what the figures say.
    const std::vector<std::string>& warningsOfMeasuring() const { return doubts_; }

    std::string table() const;

    /// The keys of a single result: {device, size, frames, timing, light, light_count,
    /// lights_reaching, lights_shadowed, settings, frame_ms, stage_ms, plan_ms, vertex_runs,
    /// bytes_gpu, bytes, repeated, warnings}; of several: {results, ratios, warnings}.
    nlohmann::ordered_json json() const;

  private:
    struct Row {
        std::string size;
        std::size_t lights; ///< scattered lights; 0: the scene's lights or those typed
        bench::Result result;
        bench::Ratios ratios; ///< the first row of that size over this one
        bool first;
    };
    std::vector<Row> rows_;
    std::string heading_;
    std::vector<std::string> doubts_;
    nlohmann::ordered_json results_ = nlohmann::ordered_json::array();
    nlohmann::ordered_json ratios_ = nlohmann::ordered_json::array();
};

} // namespace edgeshade::cli
