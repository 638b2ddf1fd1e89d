// Ctrl-C: the solve ends at the next iteration and writes its best state.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "cli/command_line.h"

namespace planewright {
namespace {

class Interrupt : public test::CommandLineTest {};

TEST_F(Interrupt, KeepsTheBestState) {
  const std::string input = sample("train-station", 2000);
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], 2);
    ::close(ends[0]);
    ::close(ends[1]);
    const int nothing = ::open("/dev/null", O_WRONLY);
    ::dup2(nothing, 1);
    const std::string output = path("p.obj"), report = path("r.json");
    // A tolerance that is never reached.
    ::execl(PLANEWRIGHT_CLI_BINARY, PLANEWRIGHT_CLI_BINARY, "dual", input.c_str(), "-o", output.c_str(),
            "--report", report.c_str(), "--tolerance", "1e-30", "--max-iterations", "1000000",
            static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ::close(ends[1]);
  // The first line of progress: it is solving.
  std::string progress;
  char c = 0;
  while (progress.find("iteration") == std::string::npos && ::read(ends[0], &c, 1) == 1) progress += c;
  ::kill(child, SIGINT);
  while (::read(ends[0], &c, 1) == 1) progress += c;
  ::close(ends[0]);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status)) << progress;
  EXPECT_EQ(WEXITSTATUS(status), 1) << progress;
  EXPECT_NE(progress.find("stopped by the user"), std::string::npos) << progress;
  EXPECT_EQ(json("r.json")["status"], "stopped");
  EXPECT_LE(json("r.json")["planarity"]["max_relative_to_bbox"].get<double>(), 1e-9);
}

}  // namespace
}  // namespace planewright
