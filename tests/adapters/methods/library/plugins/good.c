// SPDX-License-Identifier: BSD-3-Clause
/* A plug-in that returns its inputs as commands, so that tests can check the interface. */
#include <slalom/methods/slalom_method.h>

#include <stdlib.h>
#include <string.h>

typedef struct instance {
  char answer[24];
  double gain;
  slalom_robot robot;
  slalom_task task;
  int steps;
#if defined(USES_TRACKS)
  slalom_track first;
  size_t tracks;
#endif
#if defined(USES_MAP)
  slalom_map map;
  int last_cell;
#endif
} instance;

static void* create(const slalom_setting* settings, size_t setting_count, const slalom_robot* robot,
                    char* error, size_t error_size) {
  (void)error;
  (void)error_size;
  instance* self = calloc(1, sizeof(instance));
  if (self == NULL) return NULL;
  self->gain = 1;
  self->robot = *robot;
  strcpy(self->answer, "steps");
  for (size_t i = 0; i < setting_count; ++i) {
    if (strcmp(settings[i].key, "answer") == 0)
      strncpy(self->answer, settings[i].value, sizeof self->answer - 1);
    if (strcmp(settings[i].key, "gain") == 0) self->gain = strtod(settings[i].value, NULL);
  }
  return self;
}

static int reset(void* method, const slalom_task* task) {
  instance* self = method;
  self->task = *task;
  self->steps = 0;
  return 0;
}

static int answer_with(slalom_command* command, double v, double w) {
  command->v = v;
  command->w = w;
  return 0;
}

static int step(void* method, const slalom_observation* o, slalom_command* command) {
  instance* self = method;
  const char* answer = self->answer;
  ++self->steps;
#if defined(USES_TRACKS)
  const slalom_track* t = &self->first;
  if (strcmp(answer, "tracks") == 0) return answer_with(command, (double)self->tracks, t->id);
  if (strcmp(answer, "track_position") == 0) return answer_with(command, t->x, t->y);
  if (strcmp(answer, "track_velocity") == 0) return answer_with(command, t->vx, t->vy);
  if (strcmp(answer, "track_radius") == 0) return answer_with(command, t->radius, 0);
#endif
#if defined(USES_MAP)
  const slalom_map* m = &self->map;
  if (strcmp(answer, "map_origin") == 0) return answer_with(command, m->origin_x, m->origin_y);
  if (strcmp(answer, "map_size") == 0)
    return answer_with(command, (double)m->size_x, (double)m->size_y);
  if (strcmp(answer, "map_cells") == 0) return answer_with(command, m->resolution, self->last_cell);
#endif
  if (strcmp(answer, "steps") == 0) return answer_with(command, self->steps, self->gain);
  if (strcmp(answer, "position") == 0) return answer_with(command, o->x, o->y);
  if (strcmp(answer, "heading") == 0) return answer_with(command, o->phi, o->time);
  if (strcmp(answer, "speeds") == 0) return answer_with(command, o->v, o->w);
  if (strcmp(answer, "goal") == 0) return answer_with(command, o->goal_x, o->goal_y);
  if (strcmp(answer, "rays") == 0) return answer_with(command, (double)o->rays, self->robot.rays);
  if (strcmp(answer, "ranges") == 0)
    return answer_with(command, o->ranges[0], o->ranges[o->rays - 1]);
  if (strcmp(answer, "body") == 0)
    return answer_with(command, self->robot.radius, self->robot.forward_only);
  if (strcmp(answer, "limits") == 0)
    return answer_with(command, self->robot.max_v, self->robot.max_w);
  if (strcmp(answer, "accel") == 0)
    return answer_with(command, self->robot.max_accel_v, self->robot.max_accel_w);
  if (strcmp(answer, "sensor") == 0)
    return answer_with(command, self->robot.aperture, self->robot.max_range);
  if (strcmp(answer, "start") == 0)
    return answer_with(command, self->task.start_x, self->task.start_y);
  if (strcmp(answer, "task_goal") == 0)
    return answer_with(command, self->task.goal_x, self->task.goal_y);
  if (strcmp(answer, "task") == 0)
    return answer_with(command, self->task.start_phi, self->task.goal_tolerance);
  if (strcmp(answer, "seed") == 0)
    return answer_with(command, (double)self->task.seed, self->task.control_period);
  return 1;
}

static const slalom_parameter kParameters[] = {
    {"answer", "steps", "-", "input that is returned as command"},
    {"gain", "1", "-", "second number of the answer `steps`"},
};

static const slalom_method_api kApi = {
    SLALOM_METHOD_ABI_VERSION, "good", kParameters, 2, create, reset, step, free};

const slalom_method_api* slalom_method_get_api(void) {
  return &kApi;
}

#if defined(USES_TRACKS)
static int set_tracks(void* method, const slalom_track* tracks, size_t count) {
  instance* self = method;
  self->tracks = count;
  if (count > 0) self->first = tracks[0];
  return count > 2 ? 5 : 0;
}

#if defined(FAULT_TRACKS_VERSION)
#define TRACKS_VERSION (SLALOM_TRACKS_ABI_VERSION + 1)
#else
#define TRACKS_VERSION SLALOM_TRACKS_ABI_VERSION
#endif

const slalom_tracks_api* slalom_method_get_tracks_api(void) {
  static const slalom_tracks_api kTracksApi = {TRACKS_VERSION, set_tracks};
  return &kTracksApi;
}
#endif

#if defined(USES_MAP)
/* Only some of the methods use it. */
static int uses_map(const void* method) {
  return strncmp(((const instance*)method)->answer, "map_", 4) == 0;
}

static int set_map(void* method, const slalom_map* map) {
  instance* self = method;
  self->map = *map;
  self->last_cell = map->cells[map->size_x * map->size_y - 1];
  return map->size_x > 3 ? 5 : 0;
}

const slalom_map_api* slalom_method_get_map_api(void) {
  static const slalom_map_api kMapApi = {
    SLALOM_MAP_ABI_VERSION,
    uses_map,
#if defined(FAULT_NO_SET_MAP)
    NULL
  };
  (void)set_map;
#else
    set_map
  };
#endif
  return &kMapApi;
}
#endif
