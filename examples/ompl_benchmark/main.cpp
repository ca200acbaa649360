// Compares the exact planner with planners of OMPL, by OMPL's Benchmark, in a random scenario.
//   ompl_benchmark [LOG_FILE]
#include <slalom/evaluate.h>
#include <slalom/ompl/exact_disc_planner.h>

#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/tools/benchmark/Benchmark.h>
#include <ompl/util/Console.h>

#include <iostream>

namespace og = ompl::geometric;

int main(int argc, char** argv) {
  ompl::msg::noOutputHandler();
  const slalom::RandomGeneratorOptions family;  // discs and polygons in a room of 12 m x 12 m
  slalom::Options options;
  options.robot.radius = 0.25;  // m
  const auto scenarios = slalom::generate(family, 1, /*seed=*/1, options);
  const slalom::Scenario& scenario = scenarios.front();
  const slalom::World world(scenario, /*resolution=*/0.05);

  og::SimpleSetup setup(slalom::make_disc_space(world, options.robot.radius));
  ompl::base::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
  start = std::vector<double>{scenario.start().x, scenario.start().y};
  goal = std::vector<double>{scenario.goal().x, scenario.goal().y};
  setup.setStartAndGoalStates(start, goal);

  ompl::tools::Benchmark benchmark(setup, "slalom");
  benchmark.addPlanner(std::make_shared<slalom::ExactDiscPlanner>(setup.getSpaceInformation()));
  benchmark.addPlanner(std::make_shared<og::RRTstar>(setup.getSpaceInformation()));
  benchmark.addPlanner(std::make_shared<og::BITstar>(setup.getSpaceInformation()));
  ompl::tools::Benchmark::Request request(/*maxTime=*/0.2, /*maxMem=*/1000, /*runCount=*/3);
  request.displayProgress = false;
  request.saveConsoleOutput = false;
  request.simplify = false;  // which would not always end with a path that touches obstacles
  benchmark.benchmark(request);
  benchmark.saveResultsToFile(argc > 1 ? argv[1] : "ompl_benchmark.log");

  for (const auto& planner : benchmark.getRecordedExperimentData().planners) {
    std::cout << planner.name << ":";
    for (const auto& run : planner.runs) {
      const auto length = run.find("solution length REAL");
      const bool is_solved = length != run.end() && run.at("approximate solution BOOLEAN") == "0";
      std::cout << " " << (is_solved ? length->second : "no solution");
    }
    std::cout << "\n";
  }
}
