/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Covariance.h>
#include <psmks/geometry/UncertainPose.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace psmks
{
UncertainPose composed(const UncertainPose& T_a_b, const UncertainPose& T_b_c)
{
  // t_ac = R(phi_ab) t_bc + t_ab, phi_ac = phi_ab + phi_bc.
  Eigen::Matrix3d J_ac_ab = Eigen::Matrix3d::Identity();
  J_ac_ab.topRightCorner<2, 1>() = T_a_b.pose.rotationDerivative() * T_b_c.pose.translation();
  Eigen::Matrix3d J_ac_bc = Eigen::Matrix3d::Identity();
  J_ac_bc.topLeftCorner<2, 2>() = T_a_b.pose.rotation();
  return {T_a_b.pose * T_b_c.pose, J_ac_ab * T_a_b.covariance * J_ac_ab.transpose() +
                                       J_ac_bc * T_b_c.covariance * J_ac_bc.transpose()};
}

UncertainPose seenFrom(const UncertainPose& T_a_b, const UncertainPose& T_a_c)
{
  // t_bc = R(phi_ab)^T (t_ac - t_ab), phi_bc = phi_ac - phi_ab.
  const Pose2 T_b_c = T_a_b.pose.inverse() * T_a_c.pose;
  const Eigen::Matrix2d R_b_a = T_a_b.pose.rotation().transpose();
  Eigen::Matrix3d J_bc_ab = -Eigen::Matrix3d::Identity();
  J_bc_ab.topLeftCorner<2, 2>() = -R_b_a;
  J_bc_ab.topRightCorner<2, 1>() = Eigen::Vector2d(T_b_c.y_m, -T_b_c.x_m);
  Eigen::Matrix3d J_bc_ac = Eigen::Matrix3d::Identity();
  J_bc_ac.topLeftCorner<2, 2>() = R_b_a;
  return {T_b_c, J_bc_ab * T_a_b.covariance * J_bc_ab.transpose() +
                     J_bc_ac * T_a_c.covariance * J_bc_ac.transpose()};
}

Eigen::Matrix3d fusedCovariance(const Eigen::Matrix3d& guess, const Eigen::Matrix3d& information)
{
  // With guess = L L' it is L (I + L' information L)^-1 L'.
  const Eigen::Matrix3d L = guess.llt().matrixL();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(L.transpose() * information * L);
  const Eigen::Matrix3d LV = L * axes.eigenvectors();
  const Eigen::Vector3d left = (1 + axes.eigenvalues().array().max(0)).inverse();
  return LV * left.asDiagonal() * LV.transpose();
}

Eigen::Matrix3d informationBeyond(const Eigen::Matrix3d& guess, const Eigen::Matrix3d& fused)
{
  // With guess = L L' and L^-1 fused L'^-1 = V diag(d) V', it is L'^-1 V diag(1 / d - 1) V' L^-1.
  const Eigen::Matrix3d inverseL =
      guess.llt().matrixL().solve(Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inverseL * fused *
                                                            inverseL.transpose());
  const Eigen::Matrix3d V = inverseL.transpose() * axes.eigenvectors();
  const Eigen::Vector3d known = (axes.eigenvalues().array().inverse() - 1).max(0);
  return V * known.asDiagonal() * V.transpose();
}

UncertainPose conjugated(const UncertainPose& T_ref_cur, const Pose2& T_newRef_ref,
                         const Pose2& T_newCur_cur)
{
  // With A = T_newRef_ref and b the origin of newCur seen from cur, the new translation is t' = R_A
  // (R(phi) b + t) + t_A: an error of the heading of cur also displaces newCur, by the lever arm b.
  const Pose2 T_cur_newCur = T_newCur_cur.inverse();
  const Eigen::Matrix2d R_A = T_newRef_ref.rotation();
  Eigen::Matrix3d J = Eigen::Matrix3d::Identity();
  J.topLeftCorner<2, 2>() = R_A;
  J.topRightCorner<2, 1>() = R_A * T_ref_cur.pose.rotationDerivative() * T_cur_newCur.translation();

  return {T_newRef_ref * T_ref_cur.pose * T_cur_newCur,
          boundedCovariance(J * T_ref_cur.covariance * J.transpose())};
}
}  // namespace psmks
