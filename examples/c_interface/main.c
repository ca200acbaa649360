/* SPDX-License-Identifier: BSD-3-Clause */
/* Evaluates a method of this program and one of Slalom's by the interface of slalom.h. */
#include <slalom/slalom.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Drives towards the goal and looks at nothing else; it needs no memory of its own. */
static uint64_t create(uint64_t type, const char* options, const slalom_robot* robot) {
  (void)options;
  (void)robot;
  slalom_reply("{\"uses_tracks\": false, \"uses_map\": false, \"tunable\": []}");
  return type;
}

static int reset(uint64_t method, const slalom_task* task, const double* goal_heading,
                 const slalom_map* map) {
  (void)method, (void)task, (void)goal_heading, (void)map;
  return 0;
}

static int step(uint64_t method, const slalom_observation* o, const slalom_track* tracks,
                size_t track_count, slalom_command* command) {
  const double turn = atan2(o->goal_y, o->goal_x);
  (void)method, (void)tracks, (void)track_count;
  command->v = fabs(turn) < 0.5 ? 0.5 : 0;
  command->w = fmax(-1, fmin(1, 2 * turn));
  command->vy = 0;
  return 0;
}

static int finish(uint64_t method, const char* outcome) {
  (void)method, (void)outcome;
  return 0;
}

static void destroy(uint64_t method) {
  (void)method;
}

static void* valid(void* result) {
  if (result != NULL) return result;
  fprintf(stderr, "%s\n", slalom_error());
  exit(1);
}

int main(void) {
  const slalom_own_methods own = {create, reset, step, finish, destroy, NULL, NULL};
  const char* methods =
      "[{\"name\": \"direct\", \"type\": 1},"
      " {\"name\": \"gap\", \"keys\": {\"adapter\": \"library\", \"plugin\": "
      "\"libslalom_follow_the_gap.so\"}}]";
  slalom_scenarios* scenarios;
  slalom_results* results;
  char* table;
  if (slalom_library_abi_version() != SLALOM_LIBRARY_ABI_VERSION) return 1;
  scenarios = valid(slalom_scenarios_generate("random", 20, 1, 2, "{}", NULL, NULL));
  results = valid(slalom_evaluate(methods, &own, scenarios,
                                  "{\"settings\": {\"robot\": {\"radius\": \"0.2\"}}, \"metrics\": "
                                  "[\"success\"], \"workers\": 2}",
                                  NULL, NULL));
  table = valid(slalom_results_table(results, "all", "[\"success\"]", 0.95));
  fputs(table, stdout);
  slalom_free(table);
  slalom_results_free(results);
  slalom_scenarios_free(scenarios);
  return 0;
}
