// SPDX-License-Identifier: BSD-3-Clause
/* Slalom as a shared library for any language: plain C. The Python package slalom is made of it.
 *
 * Texts are UTF-8, structured ones are JSON. A function that fails returns NULL, or another value
 * than 0; slalom_error() has the reason. Texts and arrays that functions return are freed by
 * slalom_free(), objects by the function of their own; NULL may be passed to these. Units are
 * meters, radians and seconds. Settings are an object of the sections of a campaign's .ini:
 * {"robot": {"radius": "0.3"}}, with values as texts.
 */
#ifndef SLALOM_SLALOM_H
#define SLALOM_SLALOM_H

#include <slalom/methods/slalom_method.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this interface: a program compares it with slalom_library_abi_version(). */
#define SLALOM_LIBRARY_ABI_VERSION 1u

/* Marks functions visible. */
#define SLALOM_LIBRARY_EXPORT SLALOM_METHOD_EXPORT

SLALOM_LIBRARY_EXPORT uint32_t slalom_library_abi_version(void);
/* The version of Slalom. Not to be freed. */
SLALOM_LIBRARY_EXPORT const char* slalom_version(void);
/* The reason of the last failure in this thread: one line, what, where, what was expected. Not to
 * be freed; valid until the next failure. */
SLALOM_LIBRARY_EXPORT const char* slalom_error(void);
SLALOM_LIBRARY_EXPORT void slalom_free(void* memory);

/* What the language of the calling program needs: functions that are NULL are not called. */
typedef struct slalom_host {
  int (*interrupted)(void); /* polled; other than 0 ends what is going on with an error */
  /* What interrupted() has raised is put aside, and raised again before the function returns. */
  void (*put_aside)(void** first, void** second, void** third);
  void (*raise_again)(void* first, void* second, void* third);
  /* Around fork(), by which workers are made, if holds_lock() returns other than 0. */
  int (*holds_lock)(void);
  void (*before_fork)(void);
  void (*after_fork_in_parent)(void);
  void (*after_fork_in_child)(void);
  /* Around work of several threads, and around a call from one of them. */
  void* (*unlock)(void);
  void (*lock)(void* unlocked);
  int (*enter)(void);
  void (*leave)(int entered);
} slalom_host;
SLALOM_LIBRARY_EXPORT void slalom_set_host(const slalom_host* host);
/* Ends the function that is going on in this thread with an error, soon; called by one of those
 * that it calls. */
SLALOM_LIBRARY_EXPORT void slalom_stop(void);

/* Called with the phase of a job and the number of its steps that are done, and in total. Other
 * than 0 ends the job with an error. */
typedef int (*slalom_progress)(void* context, const char* phase, size_t done, size_t total);

/* What a function of the calling program answers besides its value. */
SLALOM_LIBRARY_EXPORT void slalom_reply(const char* text);

/* ---- Scenarios ---- */

/* A list of scenarios, which do not change. */
typedef struct slalom_scenarios slalom_scenarios;

SLALOM_LIBRARY_EXPORT slalom_scenarios* slalom_scenarios_new(void);
SLALOM_LIBRARY_EXPORT void slalom_scenarios_free(slalom_scenarios* list);
/* From a list (.scenarios) or a scenario (.yaml). */
SLALOM_LIBRARY_EXPORT slalom_scenarios* slalom_scenarios_read(const char* path);
SLALOM_LIBRARY_EXPORT slalom_scenarios* slalom_scenarios_from_yaml(const char* text);
/* Generates distinct scenarios that are solvable for the robot. `family` is the name of a
 * generator; settings have its section "generator.FAMILY". `workers` are threads, 0: one per core;
 * `progress`, or NULL, is called on any of them. */
SLALOM_LIBRARY_EXPORT slalom_scenarios* slalom_scenarios_generate(const char* family, int count,
                                                                  uint64_t seed, int workers,
                                                                  const char* settings,
                                                                  slalom_progress progress,
                                                                  void* context);
/* Makes a candidate of a family of the calling program: the same for the same seed. Returns 0 and
 * has given a scenario as YAML, of which JSON is a part, by slalom_reply(); or other than 0 and the
 * reason, which ends the generation. Called on any of the threads. */
typedef int (*slalom_family)(void* context, const char* name, uint64_t seed);
/* As slalom_scenarios_generate(), of candidates of such a family, whose name begins those of the
 * scenarios. */
SLALOM_LIBRARY_EXPORT slalom_scenarios* slalom_scenarios_generate_own(
    const char* name, slalom_family family, int count, uint64_t seed, int workers,
    const char* settings, slalom_progress progress, void* context);
/* Appends the scenario `index` of another list. */
SLALOM_LIBRARY_EXPORT int slalom_scenarios_add(slalom_scenarios* list, const slalom_scenarios* from,
                                               size_t index);
SLALOM_LIBRARY_EXPORT size_t slalom_scenarios_size(const slalom_scenarios* list);
SLALOM_LIBRARY_EXPORT int slalom_scenarios_write(const slalom_scenarios* list, const char* path);
/* {"name", "hash", "start": [x, y, heading], "goal": [x, y], "goal_heading": number or null,
 * "bounds": [x_min, y_min, x_max, y_max], "movers": [{"id", "radius", "after", "waypoints": [[t, x,
 * y], ...]}]} */
SLALOM_LIBRARY_EXPORT char* slalom_scenario_json(const slalom_scenarios* list, size_t index);
SLALOM_LIBRARY_EXPORT char* slalom_scenario_yaml(const slalom_scenarios* list, size_t index);
SLALOM_LIBRARY_EXPORT char* slalom_scenario_svg(const slalom_scenarios* list, size_t index);
/* Cells row by row from the bottom: 1 where occupied. Grids keep their own cells. */
SLALOM_LIBRARY_EXPORT uint8_t* slalom_scenario_occupancy(const slalom_scenarios* list, size_t index,
                                                         double resolution, size_t* rows,
                                                         size_t* columns);

/* ---- Methods of the calling program ---- */

/* Functions that return other than 0 have set the reason by slalom_reply(), which ends the run as
 * method_error. They are called by forked workers, or by the thread that called slalom_evaluate().
 * Pointers are valid during the call only. */
typedef struct slalom_own_methods {
  /* Makes a method of a type, a number that the program has given it, with options {KEY: TEXT} in
   * place of those that it has. Returns its number, which is not 0, and describes it by
   * slalom_reply(): {"uses_tracks": false, "uses_map": false, "tunable": [{"name", "default",
   * "low", "high", "log", "integer"}]}. Returns 0 if it cannot be made. */
  uint64_t (*create)(uint64_t type, const char* options, const slalom_robot* robot);
  /* Begins a run. `goal_heading` are a heading and its tolerance, or NULL; `map` is NULL unless the
   * method uses it. */
  int (*reset)(uint64_t method, const slalom_task* task, const double* goal_heading,
               const slalom_map* map);
  /* One control cycle. The observation, its ranges and the command are at the same place throughout
   * a run. */
  int (*step)(uint64_t method, const slalom_observation* observation, const slalom_track* tracks,
              size_t track_count, slalom_command* command);
  /* The run has ended, as "success", "collision", ... */
  int (*finish)(uint64_t method, const char* outcome);
  void (*destroy)(uint64_t method);
  /* Of a method with an "inner" one, in place of step(): gives parameters of that as {NAME: TEXT}
   * by slalom_reply(), from this cycle on. May be NULL if there is none. */
  int (*adapt)(uint64_t method, const slalom_observation* observation, const slalom_track* tracks,
               size_t track_count);
  /* Changes a parameter of an inner method from the next step() on; it is not reset again. May be
   * NULL. */
  int (*set_parameter)(uint64_t method, const char* name, const char* value);
} slalom_own_methods;

/* ---- Results ---- */

typedef struct slalom_results slalom_results;

/* Runs every method in every scenario. `methods` are a list of {"name", "keys": {KEY: TEXT}}, as in
 * [method.NAME] of an .ini, and of {"name", "type": number} with the functions `own` (else NULL),
 * with "inner", the name of another one, if it sets parameters of that.
 * `options` are {"settings", "metrics": [ids] or null, "descriptors", "seed", "repetitions",
 * "workers", "in_process", "output": a result file to write}, all of them optional. */
SLALOM_LIBRARY_EXPORT slalom_results* slalom_evaluate(const char* methods,
                                                      const slalom_own_methods* own,
                                                      const slalom_scenarios* scenarios,
                                                      const char* options, slalom_progress progress,
                                                      void* context);
/* From a result file, or a folder with the shards of a campaign. */
SLALOM_LIBRARY_EXPORT slalom_results* slalom_results_read(const char* path);
SLALOM_LIBRARY_EXPORT void slalom_results_free(slalom_results* results);
/* The number of runs, in the order of scenario, method and repetition. */
SLALOM_LIBRARY_EXPORT size_t slalom_results_size(const slalom_results* results);
/* {"columns": {"scenario": [one value per run], "scenario_hash", "method", "repetition", "outcome",
 * "detail"}, "numbers": [ids of metrics and descriptors], "timing": [ids of wall-clock figures],
 * "reasons": {id: {run: why it is not available}}, "manifest": {key: text}} */
SLALOM_LIBRARY_EXPORT char* slalom_results_json(const slalom_results* results);
/* The values of a column of "numbers" or "timing": one per run, NaN where not available. */
SLALOM_LIBRARY_EXPORT double* slalom_results_numbers(const slalom_results* results, const char* id);
/* The samples of a run as of TRAJECTORY_COLUMNS of Python, 11 numbers each. Of results in a file.
 */
SLALOM_LIBRARY_EXPORT double* slalom_results_trajectory(const slalom_results* results, size_t run,
                                                        size_t* samples);
/* Their scenarios, in the order in which they first occur in the runs. Of results in a file. */
SLALOM_LIBRARY_EXPORT slalom_scenarios* slalom_results_scenarios(const slalom_results* results);
/* Writes the results with one more column to a file, and returns those. Its values are numbers, or
 * texts that say why there is none, one per run, or one per scenario. `column` is {"id", "of":
 * "runs" or "scenarios", "values", "version": 1, "unit": "m", "better": "up", "down" or "none",
 * "kind": "rate", "count", "amount", "ratio" or "score", "range": "0..1", "source": the text of
 * what computes it}. Of results in a file. */
SLALOM_LIBRARY_EXPORT slalom_results* slalom_results_add(const slalom_results* results,
                                                         const char* column, const char* path);
/* The first screen of a report as a page of its own, without links and pictures. */
SLALOM_LIBRARY_EXPORT char* slalom_results_html(const slalom_results* results);
/* What slalom-analyze summary prints. */
SLALOM_LIBRARY_EXPORT char* slalom_results_summary(const slalom_results* results);
/* Tables of metrics (a list of ids) in bins of a descriptor: "all", "density:4", "density:q4",
 * "density:0,0.1,0.2". */
SLALOM_LIBRARY_EXPORT char* slalom_results_table(const slalom_results* results, const char* rows,
                                                 const char* columns, double confidence);
/* Writes a result file with the trajectories. Of results in a file. */
SLALOM_LIBRARY_EXPORT int slalom_results_save(const slalom_results* results, const char* path);

/* ---- Questions ---- */

/* Answers a question about the reliability of a method: `kind` is "limit", "envelope", "risk",
 * "standard" or "tune", `question` an object of the options of slalom-certify or slalom-tune,
 * `method` one of those of slalom_evaluate(). Returns {"certificate", "text"}; unless `output` is
 * "", the certificate is written there. */
SLALOM_LIBRARY_EXPORT char* slalom_certify(const char* kind, const char* question,
                                           const char* method, const slalom_own_methods* own,
                                           const char* settings, int workers, const char* output);

#ifdef __cplusplus
}
#endif

#endif
