// Ctrl-C: the solve ends at the next iteration and writes its best state.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include "cli/command_line.h"

namespace planewright {
namespace {

class Interrupt : public test::CommandLineTest {
 protected:
  // Runs the command, sends Ctrl-C once stderr has these words and a pause is over, and waits for its end.
  // stdout: nowhere.
  test::Ended interrupted(std::vector<std::string> arguments, const std::string& words,
                          std::chrono::milliseconds pause = {}) const {
    test::Ended ended;
    int ends[2];
    if (::pipe(ends) != 0) return ended;
    const pid_t child = ::fork();
    if (child == 0) {
      ::dup2(ends[1], 2);
      ::close(ends[0]);
      ::close(ends[1]);
      ::dup2(::open("/dev/null", O_WRONLY), 1);
      std::string program = PLANEWRIGHT_CLI_BINARY;
      std::vector<char*> argv{program.data()};
      for (std::string& argument : arguments) argv.push_back(argument.data());
      argv.push_back(nullptr);
      ::execv(PLANEWRIGHT_CLI_BINARY, argv.data());
      ::_exit(127);
    }
    ::close(ends[1]);
    char c = 0;
    while (ended.err.find(words) == std::string::npos && ::read(ends[0], &c, 1) == 1) ended.err += c;
    std::this_thread::sleep_for(pause);
    ::kill(child, SIGINT);
    while (::read(ends[0], &c, 1) == 1) ended.err += c;
    ::close(ends[0]);
    int status = 0;
    if (::waitpid(child, &status, 0) == child && WIFEXITED(status)) ended.status = WEXITSTATUS(status);
    return ended;
  }
};

TEST_F(Interrupt, KeepsTheBestState) {
  // A tolerance that is never reached.
  const test::Ended ended =
      interrupted({"dual", sample("train-station", 2000), "-o", path("p.obj"), "--report", path("r.json"),
                   "--tolerance", "1e-30", "--max-iterations", "1000000"},
                  "iteration");
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_NE(ended.err.find("stopped by the user"), std::string::npos) << ended.err;
  EXPECT_EQ(json("r.json")["status"], "stopped");
  EXPECT_LE(json("r.json")["planarity"]["max_relative_to_bbox"].get<double>(), 1e-9);
}

TEST_F(Interrupt, ImproveKeepsTheEditsOfTheRoundsBefore) {
  const test::Ended ended =
      interrupted({"improve", sample("train-station", 900), "-o", path("p.obj"), "--mesh", path("m.obj"),
                   "--report", path("r.json"), "--solver", "tangent"},
                  "round 1:");
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_NE(ended.err.find("stopped; what was reached by then is written"), std::string::npos) << ended.err;
  const nlohmann::json report = json("r.json");
  EXPECT_EQ(report["stopped"], true);
  EXPECT_GT(report["edits"].size(), 0u);
  EXPECT_LT(report["rounds"].size(), 4u);  // it takes more
  EXPECT_TRUE(report["left"].empty());
  EXPECT_LT(report["after"]["score"]["total"].get<double>(),
            report["before"]["score"]["total"].get<double>());
  EXPECT_LE(report["planarity"]["max_relative_to_bbox"].get<double>(), 1e-9);
  EXPECT_EQ(run({"check", path("p.obj")}).status, 0);
  EXPECT_TRUE(exists("m.obj"));
}

TEST_F(Interrupt, ImproveEndsWhileItListsWhatIsLeft) {
  // Planes that may not move leave a thousand bad places; to try every edit at each takes minutes.
  const test::Ended ended =
      interrupted({"improve", sample("bad-saddle", 300), "-o", path("p.obj"), "--report", path("r.json"),
                   "--freedom", "fixed", "--max-edits", "0", "--solver", "tangent"},
                  "iteration", std::chrono::milliseconds(1500));
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_EQ(json("r.json")["stopped"], true);
  EXPECT_LT(json("r.json")["seconds"].get<double>(), 20.0);
}

TEST_F(Interrupt, ClusterMakesPanelsOfTheRegionsOfThatMoment) {
  const test::Ended ended =
      interrupted({"cluster", sample("torus", 60000), "-o", path("p.obj"), "--panels", "60", "--regions",
                   path("regions.csv"), "--report", path("r.json"), "--solver", "tangent"},
                  "clustering:");
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_NE(ended.err.find("clustering was stopped; panels are made of the"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("the clustering was stopped before it was done"), std::string::npos) << ended.err;
  const nlohmann::json report = json("r.json");
  EXPECT_EQ(report["cluster"]["stopped"], true);
  EXPECT_EQ(report["cluster"]["clusters"], 60);
  EXPECT_EQ(report["status"], "converged");
  EXPECT_LE(report["planarity"]["max_relative_to_bbox"].get<double>(), 1e-9);
  EXPECT_EQ(run({"check", path("p.obj")}).status, 0);
  EXPECT_TRUE(exists("regions.csv"));
}

}  // namespace
}  // namespace planewright
