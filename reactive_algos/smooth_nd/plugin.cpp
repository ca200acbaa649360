// SPDX-License-Identifier: BSD-3-Clause
#include "common/holonomic.h"
#include "smooth_nd/smooth_nd.h"

SLALOM_HOLONOMIC_METHOD(CHolonomicSmoothND, smooth_nd::SmoothNd, "SMOOTH_ND_CONFIG");
