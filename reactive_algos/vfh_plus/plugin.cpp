// SPDX-License-Identifier: BSD-3-Clause
#include "common/holonomic.h"
#include "vfh_plus/vfh_plus.h"

SLALOM_HOLONOMIC_METHOD(CHolonomicVFHPlus, vfh_plus::VfhPlus, "VFH_PLUS_CONFIG");
