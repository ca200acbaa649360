// SPDX-License-Identifier: BSD-3-Clause
#include "common/holonomic.h"
#include "nd_plus/nd_plus.h"

SLALOM_HOLONOMIC_METHOD(CHolonomicNDPlus, nd_plus::NdPlus, "ND_PLUS_CONFIG");
