// SPDX-License-Identifier: BSD-3-Clause
/* A method that is not repeatable: the speed depends on how many runs its process has begun. */
#include <slalom/methods/slalom_method.h>

#include <stddef.h>

static double runs;

static void* create(const slalom_setting* settings, size_t setting_count, const slalom_robot* robot,
                    char* error, size_t error_size) {
  (void)settings;
  (void)setting_count;
  (void)robot;
  (void)error;
  (void)error_size;
  return &runs;
}

static int reset(void* method, const slalom_task* task) {
  (void)method;
  (void)task;
  ++runs;
  return 0;
}

static int step(void* method, const slalom_observation* observation, slalom_command* command) {
  (void)method;
  (void)observation;
  command->v = 0.125 * runs;
  command->w = 0;
  return 0;
}

static void destroy(void* method) {
  (void)method;
}

static const slalom_method_api kApi = {
    SLALOM_METHOD_ABI_VERSION, "counting", NULL, 0, create, reset, step, destroy};

const slalom_method_api* slalom_method_get_api(void) {
  return &kApi;
}
