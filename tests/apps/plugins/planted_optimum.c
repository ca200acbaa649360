// SPDX-License-Identifier: BSD-3-Clause
/* Drives to the goal if `a` is near 0.7, else stands still; `b` has no effect. */
#include <slalom/methods/slalom_method.h>

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

static void* create(const slalom_setting* settings, size_t setting_count, const slalom_robot* robot,
                    char* error, size_t error_size) {
  (void)robot;
  (void)error;
  (void)error_size;
  int* drives = calloc(1, sizeof(int));
  if (drives == NULL) return NULL;
  for (size_t i = 0; i < setting_count; ++i)
    if (strcmp(settings[i].key, "a") == 0)
      *drives = fabs(strtod(settings[i].value, NULL) - 0.7) < 0.2;
  return drives;
}

static int reset(void* method, const slalom_task* task) {
  (void)method;
  (void)task;
  return 0;
}

static int step(void* method, const slalom_observation* o, slalom_command* command) {
  const int* drives = method;
  command->v = *drives;
  command->w = *drives ? fmax(-1, fmin(1, atan2(o->goal_y, o->goal_x))) : 0;
  command->vy = 0;
  return 0;
}

static const slalom_parameter kParameters[] = {{"a", "0.1", "-", "planted"},
                                               {"b", "3", "-", "without effect"}};
static const slalom_method_api kApi = {
    SLALOM_METHOD_ABI_VERSION, "planted_optimum", kParameters, 2, create, reset, step, free};
static const slalom_range kRanges[] = {{"a", 0, 1, 0, 0}, {"b", 1, 9, 0, 1}};
static const slalom_space_api kSpace = {SLALOM_SPACE_ABI_VERSION, kRanges, 2};

const slalom_method_api* slalom_method_get_api(void) {
  return &kApi;
}

const slalom_space_api* slalom_method_get_space_api(void) {
  return &kSpace;
}
