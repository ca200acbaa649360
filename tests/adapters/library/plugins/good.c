/* A plug-in that answers with what it was given, so that a test sees what crossed the border. */
#include <slalom/methods/slalom_method.h>

#include <stdlib.h>
#include <string.h>

typedef struct instance {
  char answer[16];
  double gain;
  slalom_robot robot;
  slalom_task task;
  int steps;
} instance;

static void* create(const slalom_setting* settings, size_t setting_count, const slalom_robot* robot,
                    char* error, size_t error_size) {
  (void)error;
  (void)error_size;
  instance* it = calloc(1, sizeof(instance));
  if (it == NULL) return NULL;
  it->gain = 1;
  it->robot = *robot;
  strcpy(it->answer, "steps");
  for (size_t i = 0; i < setting_count; ++i) {
    if (strcmp(settings[i].key, "answer") == 0)
      strncpy(it->answer, settings[i].value, sizeof it->answer - 1);
    if (strcmp(settings[i].key, "gain") == 0) it->gain = strtod(settings[i].value, NULL);
  }
  return it;
}

static int reset(void* method, const slalom_task* task) {
  instance* it = method;
  it->task = *task;
  it->steps = 0;
  return 0;
}

static int answer_with(slalom_command* command, double v, double w) {
  command->v = v;
  command->w = w;
  return 0;
}

static int step(void* method, const slalom_observation* o, slalom_command* command) {
  instance* it = method;
  const char* answer = it->answer;
  ++it->steps;
  if (strcmp(answer, "steps") == 0) return answer_with(command, it->steps, it->gain);
  if (strcmp(answer, "position") == 0) return answer_with(command, o->x, o->y);
  if (strcmp(answer, "heading") == 0) return answer_with(command, o->phi, o->time);
  if (strcmp(answer, "speeds") == 0) return answer_with(command, o->v, o->w);
  if (strcmp(answer, "goal") == 0) return answer_with(command, o->goal_x, o->goal_y);
  if (strcmp(answer, "rays") == 0) return answer_with(command, (double)o->rays, it->robot.rays);
  if (strcmp(answer, "ranges") == 0)
    return answer_with(command, o->ranges[0], o->ranges[o->rays - 1]);
  if (strcmp(answer, "body") == 0)
    return answer_with(command, it->robot.radius, it->robot.forward_only);
  if (strcmp(answer, "limits") == 0) return answer_with(command, it->robot.max_v, it->robot.max_w);
  if (strcmp(answer, "accel") == 0)
    return answer_with(command, it->robot.max_accel_v, it->robot.max_accel_w);
  if (strcmp(answer, "sensor") == 0)
    return answer_with(command, it->robot.aperture, it->robot.max_range);
  if (strcmp(answer, "start") == 0) return answer_with(command, it->task.start_x, it->task.start_y);
  if (strcmp(answer, "task_goal") == 0)
    return answer_with(command, it->task.goal_x, it->task.goal_y);
  if (strcmp(answer, "task") == 0)
    return answer_with(command, it->task.start_phi, it->task.goal_tolerance);
  if (strcmp(answer, "seed") == 0)
    return answer_with(command, (double)it->task.seed, it->task.control_period);
  return 1;
}

static const slalom_parameter kParameters[] = {
    {"answer", "steps", "-", "which of the things it was given it answers with"},
    {"gain", "1", "-", "second number of the answer `steps`"},
};

static const slalom_method_api kApi = {
    SLALOM_METHOD_ABI_VERSION, "good", kParameters, 2, create, reset, step, free};

const slalom_method_api* slalom_method_get_api(void) {
  return &kApi;
}
