// SPDX-License-Identifier: BSD-3-Clause
/* A plug-in with one fault, selected by a macro. */
#include <slalom/methods/slalom_method.h>

#include <stdio.h>

#if defined(FAULT_OLD_VERSION)
#define VERSION (SLALOM_METHOD_ABI_VERSION + 7)
#else
#define VERSION SLALOM_METHOD_ABI_VERSION
#endif

static void* create(const slalom_setting* settings, size_t setting_count, const slalom_robot* robot,
                    char* error, size_t error_size) {
  static char only_instance;
  (void)settings;
  (void)setting_count;
  (void)robot;
#if defined(FAULT_REFUSES)
  snprintf(error, error_size, "the robot is\ntoo wide");
  return NULL;
#elif defined(FAULT_REFUSES_SILENTLY)
  return NULL;
#endif
  (void)error;
  (void)error_size;
  return &only_instance;
}

static int reset(void* method, const slalom_task* task) {
  (void)method;
  (void)task;
#if defined(FAULT_RESET)
  return 4;
#else
  return 0;
#endif
}

static int step(void* method, const slalom_observation* observation, slalom_command* command) {
  (void)method;
  (void)observation;
  command->v = 0;
  command->w = 0;
#if defined(FAULT_STEP)
  return 3;
#else
  return 0;
#endif
}

static void destroy(void* method) {
  (void)method;
}

#if defined(FAULT_NO_STEP)
#define STEP NULL
#else
#define STEP step
#endif

const slalom_method_api* slalom_method_get_api(void) {
  static const slalom_method_api kApi = {VERSION, "faulty", NULL, 0, create, reset, STEP, destroy};
  (void)step;
#if defined(FAULT_NO_TABLE)
  (void)kApi;
  return NULL;
#else
  return &kApi;
#endif
}
