#include "src/cli/report.hpp"

#include "preprocess/file_io.hpp"

#include <iostream>

namespace edgeshade::cli {

void writeReport(const nlohmann::ordered_json& report, const std::string& path) {
    if (path.empty()) return;
    const std::string text =
        report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    if (path == "-")
        std::cout << text << std::flush;
    else
        writeFile(path, std::string_view(text));
}

void printResult(const std::string& text, const std::string& reportPath) {
    (reportPath == "-" ? std::cerr : std::cout) << text << std::endl;
}

void printWarnings(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings)
        std::cerr << "warning: " << warning << "\n";
}

void printProgress(const std::string& text) {
    std::cerr << text << std::endl;
}

} // namespace edgeshade::cli
