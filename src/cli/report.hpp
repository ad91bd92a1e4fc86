#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace edgeshade::cli {

/// Writes the report to `path`, "-" for standard output; an empty path writes none. Throws
/// Error(output).
void writeReport(const nlohmann::ordered_json& report, const std::string& path);

/// Prints a line for people on standard output, unless the report goes there. Throws Error(output).
void printResult(const std::string& text, const std::string& reportPath);

/// Prints warnings on standard error, one per line.
void printWarnings(const std::vector<std::string>& warnings);

/// As above, for warnings that are not yet in `printed`; adds them to it.
void printNewWarnings(const std::vector<std::string>& warnings, std::set<std::string>& printed);

/// A progress bar on standard error, if that is a terminal. Its line ends at a share of 1, or when
/// the work ends early, so that an error's message has its own line. In a log, each stage of the
/// work prints one line when it begins.
class ProgressBar {
  public:
    ProgressBar();
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Redraws the bar. `doing`: the current work; `stage`: the stage that it is part of, if empty
    /// the part of `doing` before the first comma.
    void show(double share, const std::string& doing, const std::string& stage = {});

  private:
    void log(double share, const std::string& stage);

    const bool drawn_;   ///< otherwise prints lines for a log
    bool open_ = false;  ///< its line has not ended
    std::string logged_; ///< the last stage
};

/// Prints a line about progress on standard error.
void printProgress(const std::string& text);

} // namespace edgeshade::cli
