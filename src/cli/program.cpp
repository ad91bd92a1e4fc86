#include "src/cli/program.hpp"

#include "edgeshade/version.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/help.hpp"

#include <string>

namespace edgeshade::cli {

namespace {

/// "Exit status: 0 done; 1 wrong usage; ..."
std::string statusSentence() {
    std::string text = "Exit status:";
    for (const StatusMeaning& row : statusMeanings)
        text += (row.status == 0 ? " " : "; ") + std::to_string(row.status) + " " +
                std::string(row.meaning);
    return text + ".";
}

} // namespace

std::unique_ptr<CLI::App> makeProgram() {
    auto program = std::make_unique<CLI::App>(
        "Pixel-exact hard shadows for glTF scenes.\n" + statusSentence(), "edgeshade");
    program->set_version_flag("--version", "edgeshade " + std::string(versionText));
    program->require_subcommand(1);
    addPackCommand(*program);
    addInfoCommand(*program);
    addRenderCommand(*program);
    addCompareCommand(*program);
    addBenchCommand(*program);
    addTradeoffCommand(*program);
    addSunHoursCommand(*program);
    addSunHoursMergeCommand(*program);
    addCityPlanCommand(*program);
    addCityRunCommand(*program);
    addCityMergeCommand(*program);
    addViewCommand(*program);
    setHelp(*program);
    return program;
}

} // namespace edgeshade::cli
