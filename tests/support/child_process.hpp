#pragma once

#include <cstddef>
#include <string>
#include <sys/types.h>
#include <utility>
#include <vector>

namespace edgeshade::test {

/// How a child process ended, and its output.
struct ProcessResult {
    int status = -1; ///< exit status; -1 if it did not exit by itself
    int signal = 0;  ///< the signal that ended it; 0: none
    bool timedOut = false;
    double seconds = 0.0;
    std::size_t peakBytes = 0; ///< peak memory
    std::string out;
    std::string err;
};

/// A running child process. Its output goes to unnamed files, so it never waits for a reader.
class ChildProcess {
  public:
    using Environment = std::vector<std::pair<std::string, std::string>>; ///< added to the parent's
    using Main = int (*)(int argc, char** argv);

    ChildProcess(const std::string& program, const std::vector<std::string>& arguments,
                 const Environment& environment = {});
    /// Calls `main` in a fork of this process, which ends with main's status. It starts sooner than
    /// a program, as all libraries are loaded.
    ChildProcess(Main main, const std::vector<std::string>& arguments,
                 const Environment& environment = {});
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    void send(int signal) const;
    /// Waits for the end; after `timeoutSeconds` it kills the process.
    ProcessResult wait(double timeoutSeconds = 10.0);

  private:
    /// Calls `use` in a child process, which then ends.
    template <class Use>
    void start(const Environment& environment, Use use);

    pid_t process_ = -1;
    int out_ = -1;
    int err_ = -1;
};

} // namespace edgeshade::test
