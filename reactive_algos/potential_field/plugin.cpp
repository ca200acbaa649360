// SPDX-License-Identifier: BSD-3-Clause
#include "common/holonomic.h"
#include "potential_field/potential_field.h"

SLALOM_HOLONOMIC_METHOD(CHolonomicPotentialField, potential_field::PotentialField,
                        "POTENTIAL_FIELD_CONFIG");
