// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/placement.h>
#include <slalom/core/random.h>

#include <gtest/gtest.h>
#include <mrpt/math/CQuaternion.h>
#include <mrpt/poses/CPose3D.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint3D;
using mrpt::poses::CPose3D;

void expect_equal(const TPoint3D& a, const TPoint3D& b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

TEST(Placement, AgreesWithMrptsPoses) {
  RandomEngine random(3);
  const auto draw = [&] { return uniform_real(random, -3, 3); };
  for (int i = 0; i < 200; ++i) {
    const double n[] = {draw(), draw(), draw(), draw(), draw(), draw()};
    const double m[] = {draw(), draw(), draw(), draw(), draw(), draw()};
    const Placement a(n[0], n[1], n[2], n[3], n[4], n[5]), b(m[0], m[1], m[2], m[3], m[4], m[5]);
    const CPose3D p(n[0], n[1], n[2], n[3], n[4], n[5]), q(m[0], m[1], m[2], m[3], m[4], m[5]);
    const TPoint3D point(draw(), draw(), draw());
    expect_equal(a.point(point), p.composePoint(point));
    expect_equal((a + b).point(point), (p + q).composePoint(point));
    expect_equal(a.inverse().point(point), p.inverseComposePoint(point));
    EXPECT_NEAR(a.cosine_of_tilt(), p.getRotationMatrix()(2, 2), 1e-12);
    EXPECT_NEAR(std::remainder(
                    a.yaw() - std::atan2(p.getRotationMatrix()(1, 0), p.getRotationMatrix()(0, 0)),
                    2 * M_PI),
                0, 1e-12);
    mrpt::math::CQuaternionDouble turn;
    p.getAsQuaternion(turn);
    const TPoint3D at(n[0], n[1], n[2]);
    expect_equal(Placement::of_quaternion(at, turn.x(), turn.y(), turn.z(), turn.r()).point(point),
                 p.composePoint(point));
  }
}

}  // namespace
}  // namespace slalom
