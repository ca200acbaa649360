// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "program_run.h"

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

/// Drives straight ahead; after two seconds it raises the signal given by its parameter.
const char* const kCrashingMethod = R"(
#include <slalom/methods/slalom_method.h>
#include <signal.h>
#include <stdlib.h>
static int signal_number;
static void* create(const slalom_setting* s, size_t n, const slalom_robot* r, char* e, size_t size) {
  (void)r, (void)e, (void)size;
  signal_number = n > 0 ? atoi(s[0].value) : 0;
  return &signal_number;
}
static int reset(void* m, const slalom_task* t) { (void)m, (void)t; return 0; }
static int step(void* m, const slalom_observation* o, slalom_command* c) {
  (void)m;
  c->v = 0.3;
  if (o->time > 2 && signal_number) { signal(signal_number, SIG_DFL); raise(signal_number); }
  return 0;
}
static void destroy(void* m) { (void)m; }
static const slalom_parameter keys[] = {{"signal", "0", "-", "signal to raise"}};
static const slalom_method_api api = {SLALOM_METHOD_ABI_VERSION, "crashing", keys, 1,
                                      create, reset, step, destroy};
SLALOM_METHOD_EXPORT const slalom_method_api* slalom_method_get_api(void) { return &api; }
)";

class Recording : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("crashing.c", kCrashingMethod);
    ASSERT_EQ(run("cc -shared -fPIC -I" + kSource +
                  "/modules/run/methods/include crashing.c -o crashing.so")
                  .status,
              0);
    write("campaign.ini", R"([campaign]
methods = crashing, gap
[scenarios]
generator = random
count     = 2
[record]
rawlog = failures
[method.crashing]
adapter = library
plugin  = crashing.so
signal  = 11
[method.gap]
adapter = library
plugin  = libslalom_follow_the_gap.so
)");
  }

  /// The names of the files of a folder, each followed by its bytes.
  std::string files_of(const std::string& folder) const {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / folder))
      paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::string all;
    for (const auto& path : paths) all += path.filename().string() + "\n" + read_text(path);
    return all;
  }
};

TEST_F(Recording, ACrashIsRecordedAndTheCampaignContinues) {
  const ProgramResult result = run("slalom-simulate run -c campaign.ini -o runs.results -j 2");
  ASSERT_EQ(result.status, 1) << result.err;  // the method crashes in every run
  EXPECT_NE(result.err.find("crashing has ended every run"), std::string::npos) << result.err;
  const std::string sentence =
      "crashing: 2 of 2 runs ended with method_crash: killed by signal 11 (Segmentation fault), at "
      "(";
  EXPECT_NE(result.err.find(sentence), std::string::npos) << result.err;
  for (const std::string verb :
       {"table", "summary", "table --failures", "table --method crashing"}) {
    const std::string shown = run("slalom-analyze " + verb + " runs.results").out;
    EXPECT_NE(shown.find("→ " + sentence), std::string::npos) << shown;
  }
  EXPECT_EQ(run("slalom-analyze table runs.results --method gap").out.find(sentence),
            std::string::npos);
  ASSERT_EQ(run("slalom-analyze report runs.results -o report").status, 0);
  EXPECT_NE(read("report/report.json").find("\"headlines\":[{\"method\":0,\"text\":\"" + sentence),
            std::string::npos);
  const std::string dump = run("slalom-analyze dump runs.results").out;
  EXPECT_EQ(std::count(dump.begin(), dump.end(), '\n'), 4);
  EXPECT_NE(dump.find("\"outcome\":\"method_crash\""), std::string::npos) << dump;
  EXPECT_NE(dump.find("killed by signal 11 (Segmentation fault), at ("), std::string::npos) << dump;
  EXPECT_NE(dump.find("\"outcome\":\"success\""), std::string::npos) << dump;
  std::istringstream lines(dump);
  std::string line;
  while (std::getline(lines, line)) {
    const auto row = nlohmann::json::parse(line);
    const std::string name = row["scenario"]["hash"].get<std::string>().substr(0, 8) + "_" +
                             row["method"].get<std::string>() + "_0.rawlog";
    const bool recorded = row["outcome"] != "success";
    EXPECT_EQ(std::filesystem::exists(folder_ / "runs.rawlogs" / name), recorded)
        << name << " " << row["outcome"];
    const std::string id = row["scenario"]["hash"].get<std::string>().substr(0, 8) + "/" +
                           row["method"].get<std::string>() + "/0";
    const std::string shown = run("slalom-analyze show runs.results --run " + id).out;
    EXPECT_EQ(shown.find("runs.rawlogs/" + name) != std::string::npos, recorded) << shown;
  }
}

TEST_F(Recording, IsBitIdenticalForAnyNumberOfWorkers) {
  const std::string command =
      "slalom-simulate run -c campaign.ini --quiet --set record.rawlog=all ";
  ASSERT_EQ(run(command + "-o one.results -j 1").status, 1);  // one method crashes in every run
  ASSERT_EQ(run(command + "-o two.results -j 2").status, 1);
  EXPECT_EQ(files_of("one.rawlogs"), files_of("two.rawlogs"));
  EXPECT_EQ(run("slalom-analyze dump one.results").out, run("slalom-analyze dump two.results").out);
}

TEST_F(Recording, BagsOfFailedRunsStandBesideTheirRawlogs) {
  const std::string command = "slalom-simulate run -c campaign.ini --quiet ";
  ASSERT_EQ(run(command + "-o without.results -j 2").status, 1);  // one method crashes
  ASSERT_EQ(run(command + "--set record.bag=failures -o one.results -j 1").status, 1);
  ASSERT_EQ(run(command + "--set record.bag=failures -o two.results -j 2").status, 1);
  EXPECT_EQ(files_of("one.bags"), files_of("two.bags"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "without.bags"));
  EXPECT_EQ(run("slalom-analyze dump one.results").out,
            run("slalom-analyze dump without.results").out);
  int bags = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "one.bags")) {
    ++bags;
    const std::string name = entry.path().filename().string();
    const std::string run_name = entry.path().stem().string();
    EXPECT_TRUE(std::filesystem::exists(folder_ / "one.rawlogs" / (run_name + ".rawlog")));
    const std::string info = run("slalom-replay info one.bags/" + name).out;
    EXPECT_NE(info.find("/ground_truth  nav_msgs/Odometry"), std::string::npos) << info;
    std::string id = run_name;
    std::replace(id.begin(), id.end(), '_', '/');
    const std::string shown = run("slalom-analyze show one.results --run " + id).out;
    EXPECT_NE(shown.find("bag of ROS 2\n  one.bags/" + name), std::string::npos) << shown;
  }
  EXPECT_GE(bags, 2);
  const ProgramResult wrong = run(command + "--set record.bag=some -o w.results");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("expected one of none, failures, all"), std::string::npos) << wrong.err;
}

}  // namespace
}  // namespace slalom
