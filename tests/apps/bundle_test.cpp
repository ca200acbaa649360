// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "program_run.h"

#include <slalom/core/hash.h>
#include <slalom/io/bundle.h>
#include <slalom/io/result_file.h>

#include <nlohmann/json.hpp>

#include <set>

namespace slalom {
namespace {

/// Changes of a result file by a forger; checksums are right afterwards.
struct Forgery {
  std::function<void(Manifest&)> manifest = [](Manifest&) {};
  std::function<bool(RunRecord&)> run = [](RunRecord&) { return true; };  ///< false: left out
  /// Whether the scenario of this number stays.
  std::function<bool(std::size_t)> scenario = [](std::size_t) { return true; };
};

/// Copies all scenarios and runs, with other trajectories.
void copy_all(const ResultFile& from, ResultFile& to,
              const std::function<Trajectory(const RunRecord&)>& trajectory_of) {
  for (const auto& [hash, name] : from.read_scenario_names()) {
    to.add_scenario(from.read_record(hash), from.read_scenario(hash), from.read_references(hash));
    for (const RunRecord& run : from.read_runs(hash)) to.add_run(run, {}, trajectory_of(run));
  }
  to.commit();
}

class Bundles : public ResultsTest {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  void forge(const Forgery& forgery, const BundleOptions& options = {},
             const std::string& results = "runs.results") const {
    const ResultFile from = ResultFile::open(path(results));
    Manifest manifest = from.read_manifest();
    forgery.manifest(manifest);
    {
      ResultFile to =
          ResultFile::create(path("forged.results"), manifest, from.descriptors(), from.metrics());
      std::size_t number = 0;
      for (const auto& [hash, name] : from.read_scenario_names()) {
        if (!forgery.scenario(number++)) continue;
        to.add_scenario(from.read_record(hash), from.read_scenario(hash),
                        from.read_references(hash));
        for (RunRecord run : from.read_runs(hash)) {
          const Trajectory trajectory = from.read_trajectory(run);
          if (forgery.run(run)) to.add_run(run, {}, trajectory);
        }
      }
      to.commit();
    }
    write_bundle(path("forged.results"), path("forged.slalom"), options);
  }

  /// Expects that the verification of the forged bundle finds it, in a line with these words.
  void expect_found(const std::string& words) const {
    const ProgramResult verified = run("slalom-simulate verify forged.slalom --fraction 1 --quiet");
    EXPECT_EQ(verified.status, 1) << verified.out << verified.err;
    EXPECT_NE(verified.out.find(words), std::string::npos) << words << " in:\n"
                                                           << verified.out << verified.err;
  }
};

/// Sets a key of the campaign, in the text of the user and in that with all values.
void set_in_campaign(Manifest& manifest, const std::string& line, const std::string& other) {
  for (const char* key : {"campaign.ini", "campaign.effective"}) {
    std::string& text = manifest[key];
    const std::size_t at = text.find(line);
    if (at != std::string::npos) text.replace(at, line.size(), other);
  }
}

TEST_F(Bundles, AreVerifiedAsTheResultsAreThatTheyWereMadeOf) {
  const ProgramResult made = run("slalom-simulate bundle runs.results -o a.slalom");
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(made.out.rfind("a.slalom: 8 runs, 0.0 MB", 0), 0U) << made.out;
  EXPECT_EQ(run("slalom-analyze dump a.slalom").out, run("slalom-analyze dump runs.results").out);
  const ProgramResult verified = run("slalom-simulate verify a.slalom --fraction 1 --badge");
  EXPECT_EQ(verified.status, 0) << verified.err;
  EXPECT_NE(verified.out.find(", generated again\n8 of 8 runs in 4 of 4 scenarios are identical\n"),
            std::string::npos)
      << verified.out;
  const auto badge = nlohmann::json::parse(read("a.slalom.verified.json"));
  EXPECT_EQ(badge["message"], "8 of 8 runs verified");
  EXPECT_EQ(badge["color"], "brightgreen");
  EXPECT_EQ(badge["file_hash"], Hasher().add(read("a.slalom")).hex());
  EXPECT_NE(read("a.slalom.verified.svg").find(">8 of 8 runs verified</text>"), std::string::npos);
  // One changed bit of the file: its frame has a checksum.
  std::string damaged = read("a.slalom");
  damaged[damaged.size() / 2] ^= 1;
  write("b.slalom", damaged);
  expect_failure("slalom-simulate verify b.slalom", 3, {"b.slalom: is damaged"});
}

TEST_F(Bundles, AreWrittenByACampaignAndTheSameForAnyNumberOfWorkers) {
  write("small.ini", kSmallCampaign);
  for (const std::string jobs : {"1", "2"})
    ASSERT_EQ(run("slalom-evaluate small.ini -o out" + jobs + " -j " + jobs + " --bundle " + jobs +
                  ".slalom --quiet")
                  .status,
              0);
  EXPECT_EQ(read("1.slalom"), read("2.slalom"));
  expect_failure("slalom-evaluate small.ini -o out --with-sources", 2, {"--bundle"});
  expect_failure("slalom-evaluate small.ini -o out --bundle small.ini", 2,
                 {"small.ini", "is also an input"});
}

TEST_F(Bundles, OfASampleAreVerifiedWithItsChoice) {
  write("small.ini", kSmallCampaign);
  const std::string command = "slalom-evaluate small.ini --set scenarios.count=40 --quiet -o ";
  ASSERT_EQ(run(command + "sample --quick 20 --bundle a.slalom").status, 0);
  const ProgramResult verified = run("slalom-simulate verify a.slalom --fraction 1");
  EXPECT_EQ(verified.status, 0) << verified.err;
  EXPECT_NE(verified.out.find(", generated and chosen again\n"), std::string::npos) << verified.out;
  // Others of the same scenarios, such as those with a success.
  ASSERT_EQ(run(command + "all").status, 0);
  const std::string stated =
      ResultFile::open(path("sample/runs.results")).read_manifest().at("quick");
  Forgery picked;
  picked.manifest = [&](Manifest& manifest) { manifest["quick"] = stated; };
  picked.scenario = [](std::size_t number) { return number % 2 == 0; };
  forge(picked, {}, "all/runs.results");
  expect_found("of 20 are not those that --quick chooses");
  // Statements of samples that nobody could choose again.
  const std::vector<std::pair<std::string, std::string>> impossible = {
      {"20 of 40 scenarios, stratified by my wish",
       "this version of Slalom chooses 20 of 40 scenarios, stratified by turn_density"},
      {"19 of 40", "--quick 19: too few"},
      {"all", "--quick 0: too few"}};
  for (const auto& [quick, problem] : impossible) {
    const std::string text = quick;
    forge({[&](Manifest& manifest) { manifest["quick"] = text; }}, {}, "sample/runs.results");
    expect_found("its manifest states quick = " + quick + "; " + problem);
  }
}

TEST_F(Bundles, OfAPartOfACampaignAreRefused) {
  write("small.ini", kSmallCampaign);
  ASSERT_EQ(run("slalom-simulate run small.ini --shard 2/2 -o part.results --quiet").status, 0);
  expect_failure("slalom-simulate bundle part.results -o a.slalom", 2,
                 {"part.results: is shard 2/2 of its campaign", "whole campaign"});
  expect_failure("slalom-simulate bundle small.ini -o a.slalom", 3, {"small.ini"});
  ASSERT_EQ(run("slalom-simulate bundle runs.results -o a.slalom").status, 0);
  expect_failure("slalom-simulate merge a.slalom -o all.results", 2,
                 {"a.slalom: is a bundle", "result files"});
}

TEST_F(Bundles, HaveTheTrajectoriesOfFailuresThatOthersSolve) {
  ASSERT_EQ(run("slalom-simulate bundle runs.results -o a.slalom").status, 0);
  const ResultFile all = ResultFile::open(path("runs.results")),
                   bundle = ResultFile::open(path("a.slalom"));
  bundle.for_each_run([&](const RunRecord& run) {
    bool failed = false;
    for (const RunRecord& other : all.read_runs(run.scenario_hash))
      failed = failed || other.outcome != "success";
    // Fewer failures than three of each method.
    EXPECT_EQ(bundle.read_trajectory(run).samples.size(),
              failed ? all.read_trajectory(run).samples.size() : 0U)
        << run.scenario_name;
    EXPECT_EQ(bundle.read_references(run.scenario_hash).shortest->path.empty(), !failed);
    EXPECT_EQ(bundle.read_references(run.scenario_hash).shortest->length,
              all.read_references(run.scenario_hash).shortest->length);
  });
  const ProgramResult report = run("slalom-analyze report a.slalom -o report");
  EXPECT_EQ(report.status, 0) << report.err;
  EXPECT_EQ(report.err.find("damaged"), std::string::npos) << report.err;
}

TEST_F(Bundles, ForgedValuesAreFound) {
  forge({[](Manifest&) {},
         [](RunRecord& run) {
           if (run.method == "nd") run.metrics["safety"].value = Value::of(1);
           return true;
         }});
  expect_found("/nd/0: /metrics/safety/value was 1.0 and is ");
  forge({[](Manifest&) {},
         [](RunRecord& run) {
           if (run.method == "gap") run.outcome = "stuck";
           return true;
         }});
  expect_found("/gap/0: /");
  forge({[](Manifest&) {}, [](RunRecord& run) {  // swapped names
           run.method = run.method == "gap" ? "nd" : "gap";
           return true;
         }});
  expect_found("/nd/0: /");
  forge({[](Manifest&) {},
         [](RunRecord& run) {
           run.seed += 1;
           return true;
         }});
  expect_found("/seed was ");
}

TEST_F(Bundles, WhoseFileTakesTheNameOfAShippedLibraryExecuteNothing) {
  // The campaign names a library of Slalom; a file of its option would be executed in its place.
  for (const std::string key : {"method.gap.plugin", "method.nd.plugin", "method.gap.module"}) {
    SCOPED_TRACE(key);
    forge({[&](Manifest& manifest) {
            manifest[key + "_hash"] = Hasher().add("content").hex();
            if (key == "method.nd.plugin") {
              set_in_campaign(manifest, "class = CHolonomicND",
                              "class = CHolonomicND\nplugin = libslalom_nd_plus.so");
            } else if (key == "method.gap.module") {
              set_in_campaign(manifest, "adapter = library", "adapter = python\nclass = A");
              set_in_campaign(manifest, "plugin = libslalom_follow_the_gap.so", "module = m.py");
            }
          }},
          {{{key, "content"}}});
    expect_failure("slalom-simulate verify forged.slalom --quiet", 2,
                   {"forged.slalom: its methods would execute", "--trust"});
  }
}

TEST_F(Bundles, DamagedRunsAreFoundWithAnySample) {
  ASSERT_EQ(run("sqlite3 runs.results \"UPDATE runs SET m_time_to_goal = 1\"").status, 0);
  expect_failure("slalom-simulate verify runs.results --quiet", 3,
                 {"/0 is damaged (does not match its checksum), 8 in all", "an unmodified file"});
}

TEST_F(Bundles, ASampleIsRandomUnlessItsSeedIsGiven) {
  std::set<std::string> seeds;
  for (int i = 0; i < 3; ++i) {
    const std::string out = run("slalom-simulate verify runs.results --quiet").out;
    seeds.insert(out.substr(0, out.find('\n')));
  }
  EXPECT_EQ(seeds.size(), 3U);
  const std::string seed = seeds.begin()->substr(std::string("sample: ").size());
  const ProgramResult one = run("slalom-simulate verify runs.results --quiet " + seed);
  EXPECT_EQ(run("slalom-simulate verify runs.results --quiet " + seed).out, one.out);
  // One of four scenarios is taken: a change in three is missed with 1/4, in four never.
  EXPECT_NE(one.out.find("if they are in 4 of 4 scenarios or more\n2 of 8 runs in 1 of 4 scenarios "
                         "are identical\n"),
            std::string::npos)
      << one.out;
}

TEST_F(Bundles, ALimitOfTimeThatTheseRunsCannotReachIsADifference) {
  forge({[](Manifest&) {},
         [](RunRecord& run) {
           if (run.method != "gap") return true;
           run.outcome = "method_deadline";
           run.outcome_detail = "run_wall_time = 60 s exceeded, a wall-clock limit on this machine";
           return true;
         }});
  expect_found("ended at a time limit in the file (run_wall_time = 60 s exceeded");
  expect_found("too early for a slower machine");
}

TEST_F(Bundles, AStopOfAnotherMomentIsFound) {
  write("small.ini", kSmallCampaign);
  ASSERT_EQ(run("slalom-evaluate small.ini --set scenarios.count=60 --until 'interval(success) < "
                "0.6' -o until --quiet --bundle u.slalom")
                .status,
            0);
  const ProgramResult honest = run("slalom-simulate verify u.slalom --quiet");
  EXPECT_EQ(honest.status, 0) << honest.out << honest.err;
  // Left out is one scenario, as one in which a method fails.
  forge({[](Manifest&) {}, [](RunRecord&) { return true; },
         [](std::size_t number) { return number > 0; }},
        {}, "until/runs.results");
  expect_found("its manifest states until = interval(success) < 0.6, which stops after ");
}

TEST_F(Bundles, AStatementThatIsLeftOutIsComparedAsItsDefault) {
  forge({[](Manifest& manifest) {
    manifest["campaign.ini"] += "\n[robot]\nmax_w = 1.4\n";
    std::string& text = manifest["campaign.effective"];
    const std::size_t at = text.find("max_w = ");
    text.erase(at, text.find('\n', at) + 1 - at);
  }});
  expect_found("its manifest states robot.max_w = absent, its campaign has 1.4");
}

TEST_F(Bundles, ARunWhoseKeyIsOfAnotherTypeIsDamaged) {
  const std::string intact = read("runs.results");
  for (const char* forged :
       {"repetition = 4294967296", "repetition = 0.5", "repetition = x'30'", "repetition = '0x'",
        "method = CAST(method AS BLOB)", "scenario = CAST(scenario AS BLOB)"}) {
    write("runs.results", intact);
    ASSERT_EQ(
        run(std::string("sqlite3 runs.results \"UPDATE runs SET ") + forged + " WHERE run = 1\"")
            .status,
        0);
    expect_failure("slalom-simulate verify runs.results --quiet", 3,
                   {" is damaged", "an unmodified file"});
  }
}

TEST_F(Bundles, WhatIsStatedOfAQuantityIsCompared) {
  const ResultFile from = ResultFile::open(path("runs.results"));
  const auto expect_found_of = [&](const std::function<void(QuantityInfo&)>& change,
                                   const std::string& words) {
    std::vector<QuantityInfo> metrics = from.metrics();
    for (QuantityInfo& info : metrics)
      if (info.id == "time_to_goal") change(info);
    {
      ResultFile to = ResultFile::create(path("forged.results"), from.read_manifest(),
                                         from.descriptors(), metrics);
      copy_all(from, to, [&](const RunRecord& run) { return from.read_trajectory(run); });
    }
    write_bundle(path("forged.results"), path("forged.slalom"), {});
    expect_found("the file states time_to_goal as " + words);
  };
  expect_found_of([](QuantityInfo& info) { info.direction = Direction::Up; },
                  "Time to goal, s, up, amount, 0..; it is Time to goal, s, down, amount, 0..");
  expect_found_of([](QuantityInfo& info) { info.unit = "ms"; }, "Time to goal, ms");
  expect_found_of([](QuantityInfo& info) { info.range.high = 60; },
                  "Time to goal, s, down, amount, 0..60");
}

TEST_F(Bundles, ATrajectoryOfAnotherRunIsFound) {
  const ResultFile from = ResultFile::open(path("runs.results"));
  {
    ResultFile to = ResultFile::create(path("forged.results"), from.read_manifest(),
                                       from.descriptors(), from.metrics());
    Trajectory first;
    copy_all(from, to, [&](const RunRecord& run) {
      if (first.samples.empty()) first = from.read_trajectory(run);
      return first;
    });
  }
  expect_failure("slalom-simulate verify forged.results --quiet", 3,
                 {"its trajectory does not have the hash that the run states"});
}

TEST_F(Bundles, AShardHasTheScenariosAndStatementsOfItsPart) {
  for (const char* shard : {"1/2", "2/2"})
    ASSERT_EQ(run(std::string("slalom-simulate run -c small.ini --quiet -o ") + shard[0] +
                  ".results --shard " + shard)
                  .status,
              0);
  const ProgramResult verified = run("slalom-simulate verify 2.results --fraction 1 --quiet");
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  // A campaign without the scenarios in which a method fails, called a shard.
  forge({[](Manifest& manifest) { manifest["shard"] = "1/4"; }, [](RunRecord&) { return true; },
         [](std::size_t number) { return number == 1; }});
  expect_found("1 scenario of 1 are not those that the campaign generates");
  forge({[](Manifest& manifest) { manifest["shard"] = "1/2"; }, [](RunRecord&) { return true; },
         [](std::size_t number) { return number == 0; }});
  expect_found("the file lacks 2 of 4 runs of its campaign");
}

TEST_F(Bundles, AnInterruptedVerificationLeavesNothing) {
  write("many.ini", std::string(kSmallCampaign));
  ASSERT_EQ(run("slalom-evaluate many.ini -o many --bundle b.slalom --quiet "
                "--set scenarios.count=100")
                .status,
            0);
  // The signal comes when the folder for temporary files is used.
  const ProgramResult result =
      run("sh -c 'mkdir t; TMPDIR=$PWD/t slalom-simulate verify b.slalom --fraction 0.5 --quiet "
          ">printed "
          "2>said & "
          "until [ -n \"$(ls t 2>/dev/null)\" ] || ! kill -0 $! 2>/dev/null; do :; done; "
          "kill -TERM $! 2>/dev/null; wait $!; echo $?; ls t'");
  EXPECT_EQ(result.out, "130\n") << read("said");
  EXPECT_NE(read("said").find("interrupted: nothing was changed"), std::string::npos)
      << read("said");
}

TEST_F(Bundles, MissingRunsAndScenariosAreFound) {
  bool left_out = false;
  forge({[](Manifest&) {}, [&](RunRecord&) { return std::exchange(left_out, true); }});
  expect_found("the file lacks 1 of 8 runs of its campaign, run ");
  const auto without_first = [](std::size_t number) { return number > 0; };
  const auto all = [](RunRecord&) { return true; };
  forge({[](Manifest&) {}, all, without_first});
  expect_found("the file lacks 2 of 8 runs of its campaign, those of a scenario first");
  forge({[](Manifest& manifest) { manifest["scenarios.count"] = "3"; }, all, without_first});
  expect_found("the file has 3 scenarios, the campaign generates 4");
  forge({[](Manifest& manifest) {
    set_in_campaign(manifest, "gap, nd", "gap");
    set_in_campaign(manifest, "nd, gap", "gap");
  }});
  expect_found("which is not of its campaign");
}

TEST_F(Bundles, ARunThatIsThereTwiceDoesNotHideAMissingOne) {
  ASSERT_EQ(run("sqlite3 runs.results \"CREATE TABLE other AS SELECT * FROM runs WHERE run > 1; "
                "INSERT INTO other SELECT * FROM runs WHERE run = 2; DROP TABLE runs; "
                "ALTER TABLE other RENAME TO runs\"")
                .status,
            0);
  const ProgramResult verified = run("slalom-simulate verify runs.results --quiet");
  EXPECT_EQ(verified.status, 1) << verified.out;
  EXPECT_NE(verified.out.find("the file lacks 1 of 8 runs of its campaign, run "),
            std::string::npos)
      << verified.out << verified.err;
}

TEST_F(Bundles, ForgedStatementsAreFound) {
  // The scenarios of another seed.
  forge({[](Manifest& manifest) {
    set_in_campaign(manifest, "seed = 5", "seed = 6");
    manifest["seed"] = "6";
  }});
  expect_found("4 scenarios of 4 are not those that the campaign generates");
  forge({[](Manifest& manifest) { manifest["seed"] = "7"; }});
  expect_found("its manifest states seed = 7, its campaign has 5");
  // Limits that the runs did not have.
  forge({[](Manifest& manifest) {
    manifest["campaign.ini"] += "\n[robot]\nmax_v = 2\n";
    set_in_campaign(manifest, "max_v = 0.8", "max_v = 2");
  }});
  expect_found("/gap/0: /");
  forge(
      {[](Manifest& manifest) { set_in_campaign(manifest, "max_accel_v = ", "max_accel_v = 1"); }});
  expect_found("its manifest states robot.max_accel_v = 1");
  forge({[](Manifest& manifest) { manifest["methods.privileged"] = "nd"; }});
  expect_found("its manifest states methods.privileged = nd, its campaign has ");
  forge({[](Manifest& manifest) {
    manifest["scenarios.hash"] = "04203288f4478c5641527e24e4f2f53f";
  }});
  expect_found("its manifest states scenarios.hash = 04203288f4478c5641527e24e4f2f53f, its ");
}

TEST_F(Bundles, CarryTheFilesOfTheirMethods) {
  std::filesystem::copy_file(kFollowTheGap, folder_ / "mine.so");
  write("small.ini", kSmallCampaign);
  const std::string campaign = "small.ini --set method.gap.plugin=./mine.so --quiet ";
  ASSERT_EQ(run("slalom-evaluate " + campaign + "-o mine --bundle a.slalom --with-sources").status,
            0);
  const auto files = read_bundled_files(path("a.slalom"));
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].key, "method.gap.plugin");
  EXPECT_EQ(files[0].content, read("mine.so"));
  std::filesystem::remove(folder_ / "mine.so");
  expect_failure("slalom-simulate verify a.slalom --quiet", 2,
                 {"would execute", "plugin = method.gap/mine.so", "--trust", "unpack"});
  const ProgramResult verified =
      run("slalom-simulate verify a.slalom --trust --fraction 1 --quiet");
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  // Unpacked, they are read and run again.
  ASSERT_EQ(run("slalom-simulate unpack a.slalom -o there").status, 0);
  EXPECT_EQ(read("there/method.gap/mine.so"), files[0].content);
  const ProgramResult again =
      run("slalom-simulate run there/campaign.ini --scenarios there/campaign.scenarios --quiet "
          "-o again.results");
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(run("slalom-analyze dump again.results").out, run("slalom-analyze dump a.slalom").out);
}

TEST_F(Bundles, CarryTheFilesThatOptionsOfAPythonClassName) {
  write(
      "mine.py",
      "class Mine:\n"
      "    options = {'weights': ('', '-', 'of v and w')}\n"
      "    def __init__(self, robot, options):\n"
      "        self.v, self.w = (float(open(path).read()) for path in options.weights.split(','))\n"
      "    def reset(self, task):\n"
      "        pass\n"
      "    def step(self, observation):\n"
      "        return self.v, self.w\n");
  std::filesystem::create_directory(folder_ / "nets");
  write("nets/v.txt", "0.5");
  write("w.txt", "0.1");
  write("python.ini",
        "[campaign]\nmethods = mine\n[scenarios]\ngenerator = random\ncount = 2\n[method.mine]\n"
        "adapter = python\nmodule = mine.py\nclass = Mine\nweights = nets/v.txt,w.txt\n");
  ASSERT_EQ(
      run("slalom-evaluate python.ini -o mine --bundle a.slalom --with-sources --quiet").status, 0);
  for (const char* file : {"mine.py", "nets/v.txt", "w.txt"})
    std::filesystem::remove(folder_ / file);
  const ProgramResult verified =
      run("slalom-simulate verify a.slalom --trust --fraction 1 --quiet");
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  ASSERT_EQ(run("slalom-simulate unpack a.slalom -o there").status, 0);
  const std::string again =
      "slalom-simulate run there/campaign.ini --quiet -o again.results "
      "--scenarios there/campaign.scenarios";
  ASSERT_EQ(run(again).status, 0);
  EXPECT_EQ(run("slalom-analyze dump again.results").out, run("slalom-analyze dump a.slalom").out);
  expect_failure("slalom-simulate unpack a.slalom -o 'a #b'", 2, {"a #b: cannot be named", "#"});
  // Another value is one, whatever the folders.
  write("there/campaign.ini", read("there/campaign.ini") + "[robot]\nmax_v = 0.9\n");
  EXPECT_EQ(run("slalom-simulate verify a.slalom -c there/campaign.ini --quiet").status, 1);
}

TEST_F(Bundles, CarryTheConfigurationsOfMrptsMethods) {
  const std::string original = kSource + "/tests/adapters/methods/mrpt_nav/small_navigator.ini";
  for (const char* adapter : {"mrpt_navigator", "mrpt_holonomic"}) {
    std::filesystem::copy_file(original, folder_ / "mine.ini");
    write("mrpt.ini",
          "[campaign]\nmethods = mrpt\n[scenarios]\ngenerator = random\ncount = 2\n[method.mrpt]\n"
          "config = mine.ini\nadapter = " +
              std::string(adapter) +
              (adapter == std::string("mrpt_holonomic") ? "\nclass = CHolonomicND\n" : "\n"));
    ASSERT_EQ(run("slalom-evaluate mrpt.ini -o " + std::string(adapter) +
                  " --bundle a.slalom --with-sources --quiet")
                  .status,
              0);
    std::filesystem::remove(folder_ / "mine.ini");
    const ProgramResult verified = run("slalom-simulate verify a.slalom --fraction 1 --quiet");
    EXPECT_EQ(verified.status, 0) << adapter << verified.out << verified.err;
  }
}

TEST_F(Bundles, WithAnotherFileOfAMethodAreRefused) {
  const auto with = [&](const std::string& key, const std::string& hash) {
    forge({[&](Manifest& manifest) { manifest[key + "_hash"] = Hasher().add(hash).hex(); }},
          {{{key, "edited"}}});
  };
  with("method.gap.plugin", "original");
  expect_failure("slalom-simulate verify forged.slalom --trust", 3,
                 {"method.gap.plugin", "is not the file whose hash the manifest names"});
  for (const std::string name : {"../evil.py", "/tmp/evil.py", "a/../../evil.py"}) {
    with("method.gap.module/" + name, "edited");
    expect_failure("slalom-simulate unpack forged.slalom -o there", 3,
                   {"forged.slalom", "outside of its folder"});
    for (const std::string section : {"method.", "..x", "method.none", "campaign"}) {
      with(section + ".plugin/" + name, "edited");
      expect_failure("slalom-simulate unpack forged.slalom -o there", 3,
                     {"forged.slalom", "a file of a method of its campaign"});
    }
  }
}

TEST_F(Bundles, AreUnpackedIntoAFolderWithoutFilesOfTheUser) {
  forge({});
  std::filesystem::create_directories(path("there"));
  write("there/.bashrc", "mine");
  expect_failure("slalom-simulate unpack forged.slalom -o there", 2,
                 {"there: is not empty", "a new or an empty folder"});
  EXPECT_EQ(read("there/.bashrc"), "mine");
  std::filesystem::remove(path("there/.bashrc"));
  EXPECT_EQ(run("slalom-simulate unpack forged.slalom -o there").status, 0);
}

TEST_F(Bundles, AFileWhoseNameBeginsAsAnOverrideIsNotTheUsers) {
  write("foreign.so", "");
  forge({[&](Manifest& manifest) {
    set_in_campaign(manifest, "libslalom_follow_the_gap.so", path("foreign.so"));
  }});
  std::filesystem::rename(path("forged.results"), path("--set.results"));
  expect_failure("slalom-simulate verify --quiet -- --set.results", 2,
                 {"would execute", "plugin = " + path("foreign.so")});
}

}  // namespace
}  // namespace slalom
