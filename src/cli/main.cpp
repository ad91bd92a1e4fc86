#include "src/cli/run_program.hpp"

int main(int argc, char** argv) {
    return edgeshade::cli::runProgram(argc, argv);
}
