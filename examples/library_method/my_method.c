/* A complete avoidance method: selects the free direction closest to the goal, and slows down when
 * it has to turn. */
#include <slalom/methods/slalom_method.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct {
  slalom_robot robot;
  double look_ahead;
} method;

static void* create(const slalom_setting* settings, size_t count, const slalom_robot* robot,
                    char* error, size_t error_size) {
  const double look_ahead = count > 0 ? atof(settings[0].value) : 1.0; /* the only parameter */
  method* self = look_ahead > 0 ? malloc(sizeof *self) : NULL;
  if (self) *self = (method){*robot, look_ahead};
  if (!self) snprintf(error, error_size, "look_ahead must be positive");
  return self;
}

static int reset(void* self, const slalom_task* task) {
  return self && task ? 0 : 1;
}

/* Whether a straight corridor, slightly wider than the robot, is free along `angle`. */
static int is_free(const method* self, const slalom_observation* obs, double angle, double limit) {
  for (size_t i = 0; i < obs->rays; ++i) {
    const double fraction = (double)i / (double)(obs->rays - 1) - 0.5;
    const double at = self->robot.aperture * fraction - angle;
    const double ahead = obs->ranges[i] * cos(at), lateral = fabs(obs->ranges[i] * sin(at));
    if (ahead > 0 && ahead < limit && lateral < 1.3 * self->robot.radius) return 0;
  }
  return 1;
}

static int step(void* data, const slalom_observation* obs, slalom_command* command) {
  const method* self = data;
  const double goal = atan2(obs->goal_y, obs->goal_x);
  const double goal_distance = hypot(obs->goal_x, obs->goal_y);
  double best = goal > 0 ? 9 : -9; /* nothing is free: rotate in place */
  for (double angle = -1.5; angle <= 1.5; angle += 0.05)
    if (fabs(angle - goal) < fabs(best - goal) &&
        is_free(self, obs, angle, fmin(self->look_ahead, goal_distance)))
      best = angle;
  command->w = fmax(-1, fmin(1, best)) * self->robot.max_w;
  command->v = fmax(0, 1 - 2 * fabs(best)) * fmin(self->robot.max_v, goal_distance);
  return 0;
}

static const slalom_parameter parameters[] = {{"look_ahead", "1.0", "m", "Required free distance"}};
static const slalom_method_api api = {
    SLALOM_METHOD_ABI_VERSION, "my_method", parameters, 1, create, reset, step, free};

const slalom_method_api* slalom_method_get_api(void) {
  return &api;
}
