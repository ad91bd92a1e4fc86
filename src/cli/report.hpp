#pragma once

#include <nlohmann/json.hpp>
#include <set>
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

/// The same of those that are not in `printed`, where they are from then on.
void printNewWarnings(const std::vector<std::string>& warnings, std::set<std::string>& printed);

/// A bar on standard error where that is a terminal. Its line ends with a share of 1, or when the
/// work ends before, so that an error's message has a line of its own. In a log each stage of the
/// work has one line, when it begins.
class ProgressBar {
  public:
    ProgressBar();
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Draws over the last call's. `doing`: what is being done; `stage`: of what that is a part,
    /// what stands before the first comma if it is empty.
    void show(double share, const std::string& doing, const std::string& stage = {});

  private:
    void log(double share, const std::string& stage);

    const bool drawn_;   ///< else a log gets lines
    bool open_ = false;  ///< its line has not ended
    std::string logged_; ///< the last stage
};

/// A line about progress, on standard error.
void printProgress(const std::string& text);

} // namespace edgeshade::cli
