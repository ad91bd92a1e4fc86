#pragma once

namespace edgeshade::cli {

/// The whole program: runs what the command line says, prints one line if that fails, and returns
/// the exit status.
int runProgram(int argc, char** argv);

} // namespace edgeshade::cli
