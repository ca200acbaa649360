// SPDX-License-Identifier: BSD-3-Clause
/* The function prototype of a compiled obstacle avoidance method: plain C.
 *
 * A method is a shared library with one exported function, slalom_method_get_api(), which returns
 * the table below. Units are meters, radians and seconds; the robot frame has x forward and y
 * left, angles are counter-clockwise. All pointers given to a method belong to the caller and are
 * valid during the call only.
 */
#ifndef SLALOM_METHOD_H
#define SLALOM_METHOD_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this prototype. Libraries built for another version are refused. */
#define SLALOM_METHOD_ABI_VERSION 1u

/* Marks the exported function visible also in libraries built with hidden visibility. */
#if defined(_WIN32)
#define SLALOM_METHOD_EXPORT __declspec(dllexport)
#else
#define SLALOM_METHOD_EXPORT __attribute__((visibility("default")))
#endif

/* A key of the method's .ini section with its value as text. */
typedef struct slalom_setting {
  const char* key;
  const char* value;
} slalom_setting;

/* Properties of the robot and its sensor. */
typedef struct slalom_robot {
  double radius;           /* m, of the smallest centered disc that contains the footprint */
  double max_v;            /* m/s */
  double max_w;            /* rad/s */
  double max_accel_v;      /* m/s^2 */
  double max_accel_w;      /* rad/s^2 */
  int forward_only;        /* 1: v must not be negative */
  int rays;                /* rays of one scan */
  double aperture;         /* rad, from the first to the last ray, symmetric to the heading */
  double max_range;        /* m */
  int holonomic;           /* 1: vy may be commanded; 0: differential drive, vy must be 0 */
  const double* footprint; /* x0, y0, x1, y1, ... of its convex hull, m, counter-clockwise */
  size_t footprint_points; /* 0: the footprint is the disc */
} slalom_robot;

/* One run. */
typedef struct slalom_task {
  double start_x, start_y, start_phi; /* odometry frame */
  double goal_x, goal_y;              /* odometry frame */
  double goal_tolerance;              /* m */
  double control_period;              /* s */
  uint64_t seed;                      /* for methods that draw random numbers */
} slalom_task;

/* The input in each control cycle. */
typedef struct slalom_observation {
  double time;           /* s since the start of the run */
  double x, y, phi;      /* odometry pose */
  double v, vy, w;       /* measured velocity forward and to the left, m/s; angular, rad/s */
  double goal_x, goal_y; /* goal in the robot frame */
  const float* ranges;   /* `rays` ranges, m, counter-clockwise from -aperture/2 */
  size_t rays;
} slalom_observation;

/* The output: within the robot's limits, or the run ends as method_invalid_command. */
typedef struct slalom_command {
  double v;  /* m/s, forward */
  double w;  /* rad/s, counter-clockwise */
  double vy; /* m/s, to the left; 0 unless the robot is holonomic */
} slalom_command;

/* A configuration key of the method, for help texts and for detecting misspelled keys. */
typedef struct slalom_parameter {
  const char* key;
  const char* default_value;
  const char* unit; /* "-" for none */
  const char* help;
} slalom_parameter;

typedef struct slalom_method_api {
  uint32_t abi_version; /* SLALOM_METHOD_ABI_VERSION */
  const char* name;
  const slalom_parameter* parameters;
  size_t parameter_count;

  /* Returns a new method, or NULL with a message (at most `error_size` bytes including the final
   * zero) in `error`. */
  void* (*create)(const slalom_setting* settings, size_t setting_count, const slalom_robot* robot,
                  char* error, size_t error_size);
  /* Begins a run; must discard all state of the run before. Returns 0, or an error code that ends
   * the run. */
  int (*reset)(void* method, const slalom_task* task);
  /* One control cycle. Returns 0, or an error code that ends the run as method_error. */
  int (*step)(void* method, const slalom_observation* observation, slalom_command* command);
  void (*destroy)(void* method);
} slalom_method_api;

/* The function that every library exports. */
SLALOM_METHOD_EXPORT const slalom_method_api* slalom_method_get_api(void);

/* Optional: a method that needs the tracks of movers (moving obstacles), which a scan does not
 * contain. A library that exports slalom_method_get_tracks_api() declares that, and its results are
 * marked as privileged in every table. Version 1 of the prototype above does not change. */
#define SLALOM_TRACKS_ABI_VERSION 1u

/* A mover within the range of [tracks], in the robot frame; with the noise of [tracks]. */
typedef struct slalom_track {
  int32_t id;    /* the same throughout a run */
  double x, y;   /* m, of the center */
  double vx, vy; /* m/s over ground, along the axes of the robot frame */
  double radius; /* m */
} slalom_track;

typedef struct slalom_tracks_api {
  uint32_t abi_version; /* SLALOM_TRACKS_ABI_VERSION */
  /* The tracks of a control cycle, in the order of their ids: called before its step(). Returns 0,
   * or an error code that ends the run as method_error. */
  int (*set_tracks)(void* method, const slalom_track* tracks, size_t count);
} slalom_tracks_api;

SLALOM_METHOD_EXPORT const slalom_tracks_api* slalom_method_get_tracks_api(void);

/* Optional: a method that can use the map of static obstacles. A library that exports
 * slalom_method_get_map_api() declares that for those of its methods for which uses_map() returns
 * 1, whose results are marked as privileged. */
#define SLALOM_MAP_ABI_VERSION 1u

/* The static obstacles of a run, without noise, on square cells. */
typedef struct slalom_map {
  double resolution;         /* m, size of a cell */
  double origin_x, origin_y; /* m, of the lower left corner, in the odometry frame */
  size_t size_x, size_y;     /* cells */
  const uint8_t* cells;      /* row by row upwards: 1 occupied, 0 free */
} slalom_map;

typedef struct slalom_map_api {
  uint32_t abi_version; /* SLALOM_MAP_ABI_VERSION */
  /* Whether this method uses the map: 1 or 0, the same for its life. */
  int (*uses_map)(const void* method);
  /* The map of a run: called after its reset(), if the method uses it. Returns 0, or an error code
   * that ends the run as method_error. */
  int (*set_map)(void* method, const slalom_map* map);
} slalom_map_api;

SLALOM_METHOD_EXPORT const slalom_map_api* slalom_method_get_map_api(void);

/* Optional: a method that turns to the heading that a goal may have. Of a goal with a heading, runs
 * succeed only within its tolerance. */
#define SLALOM_GOAL_HEADING_ABI_VERSION 1u

typedef struct slalom_goal_heading_api {
  uint32_t abi_version; /* SLALOM_GOAL_HEADING_ABI_VERSION */
  /* The heading of the goal of a run (rad, odometry frame) and its tolerance (rad): called after
   * its reset(), if the goal has one. Returns 0, or an error code that ends the run as
   * method_error. */
  int (*set_goal_heading)(void* method, double heading, double tolerance);
} slalom_goal_heading_api;

SLALOM_METHOD_EXPORT const slalom_goal_heading_api* slalom_method_get_goal_heading_api(void);

/* Optional: the space in which the method's parameters are tuned (slalom-tune). */
#define SLALOM_SPACE_ABI_VERSION 1u

/* A numeric parameter of slalom_method_api with the range in which it is worth tuning. */
typedef struct slalom_range {
  const char* key;
  double low, high;
  int32_t logarithmic; /* 1: equal ratios are equally far apart */
  int32_t integer;     /* 1: the values are integers */
} slalom_range;

typedef struct slalom_space_api {
  uint32_t abi_version; /* SLALOM_SPACE_ABI_VERSION */
  const slalom_range* ranges;
  size_t range_count;
} slalom_space_api;

SLALOM_METHOD_EXPORT const slalom_space_api* slalom_method_get_space_api(void);

/* Optional: a method whose parameters another one can set during a run. */
#define SLALOM_PARAMETERS_ABI_VERSION 1u

typedef struct slalom_parameters_api {
  uint32_t abi_version; /* SLALOM_PARAMETERS_ABI_VERSION */
  /* Changes a parameter of slalom_method_api from the next step() on: called between reset() and
   * destroy(), of a method that is then not reset again. Returns 0, or an error code, as for an
   * invalid value, that ends the run as method_error. */
  int (*set_parameter)(void* method, const char* key, const char* value);
} slalom_parameters_api;

SLALOM_METHOD_EXPORT const slalom_parameters_api* slalom_method_get_parameters_api(void);

#ifdef __cplusplus
}
#endif

#endif
