#include "src/cli/report.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/file_io.hpp"

#include <iostream>
#include <unistd.h>

namespace edgeshade::cli {
namespace {

/// Throws if standard output can't be written, for example on a full disk or to a closed pipe.
void writeToStandardOutput(const std::string& text) {
    if (!(std::cout << text << std::flush))
        throw Error(ExitStatus::output, "Standard output can't be written.");
}

} // namespace

void writeReport(const nlohmann::ordered_json& report, const std::string& path) {
    if (path.empty()) return;
    const std::string text =
        report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    if (path == "-")
        writeToStandardOutput(text);
    else
        writeFile(path, std::string_view(text));
}

void printResult(const std::string& text, const std::string& reportPath) {
    if (reportPath == "-")
        std::cerr << text << std::endl;
    else
        writeToStandardOutput(text + "\n");
}

void printWarnings(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings)
        std::cerr << "warning: " << warning << "\n";
}

void printNewWarnings(const std::vector<std::string>& warnings, std::set<std::string>& printed) {
    for (const std::string& warning : warnings)
        if (printed.insert(warning).second) printWarnings({warning});
}

ProgressBar::ProgressBar() : drawn_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (open_) std::cerr << std::endl;
}

void ProgressBar::show(double share, const std::string& doing, const std::string& stage) {
    if (!drawn_) return log(share, stage.empty() ? doing.substr(0, doing.find(", ")) : stage);
    constexpr int width = 24;
    const int full = static_cast<int>(share * width + 0.5);
    std::cerr << "\r\033[K[" << std::string(full, '#') << std::string(width - full, '.') << "] "
              << doing.substr(0, 90) << std::flush;
    open_ = share < 1.0;
    if (!open_) std::cerr << "\n";
}

void ProgressBar::log(double share, const std::string& stage) {
    if (share >= 1.0 || stage == logged_) return;
    logged_ = stage;
    printProgress("progress: " + stage);
}

void printProgress(const std::string& text) {
    std::cerr << text << std::endl;
}

} // namespace edgeshade::cli
