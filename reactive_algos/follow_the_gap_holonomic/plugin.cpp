// SPDX-License-Identifier: BSD-3-Clause
#include "common/holonomic.h"
#include "follow_the_gap_holonomic/follow_the_gap_holonomic.h"

SLALOM_HOLONOMIC_METHOD(CHolonomicFollowTheGap, follow_the_gap_holonomic::FollowTheGap,
                        "FOLLOW_THE_GAP_CONFIG");
