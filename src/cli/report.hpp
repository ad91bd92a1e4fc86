#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace edgeshade::cli {

/// Writes the report to `path`, "-" for standard output; an empty path writes none. Throws
/// Error(output).
void writeReport(const nlohmann::ordered_json& report, const std::string& path);

/// A line for people, on standard output unless the report goes there. Throws Error(output).
void printResult(const std::string& text, const std::string& reportPath);

/// Warnings, a line each, on standard error.
void printWarnings(const std::vector<std::string>& warnings);

/// A bar on standard error. Its line ends with a share of 1, or when the work ends before, so that
/// an error's message has a line of its own.
class ProgressBar {
  public:
    ProgressBar() = default;
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Draws over the last call's. `doing`: what is being done.
    void show(double share, const std::string& doing);

  private:
    bool open_ = false; ///< its line has not ended
};

/// A line about progress, on standard error.
void printProgress(const std::string& text);

} // namespace edgeshade::cli
