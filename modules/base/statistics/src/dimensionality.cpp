// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/statistics/dimensionality.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>

namespace slalom {
namespace {

/// The scenarios that a method solves: a bit each.
using SolvedSet = std::vector<std::uint64_t>;

std::size_t count_bits(std::uint64_t word) {
  return std::bitset<64>(word).count();
}

std::vector<SolvedSet> solved_sets(const OutcomeMatrix& outcomes) {
  std::vector<SolvedSet> sets(outcomes.front().size(), SolvedSet(outcomes.size() / 64 + 1, 0));
  for (std::size_t row = 0; row < outcomes.size(); ++row)
    for (std::size_t i = 0; i < sets.size(); ++i)
      sets[i][row / 64] |= std::uint64_t{outcomes[row][i]} << (row % 64);
  return sets;
}

/// Deals the scenarios that only one of the two methods solves at random, as many to each as
/// before.
void trade(SolvedSet& a, SolvedSet& b, RandomEngine& engine) {
  std::size_t wanted = 0, left = 0;  // by a; of both
  for (std::size_t word = 0; word < a.size(); ++word) {
    wanted += count_bits(a[word] & ~b[word]);
    left += count_bits(a[word] ^ b[word]);
  }
  if (wanted == 0 || wanted == left) return;
  for (std::size_t word = 0; word < a.size(); ++word) {
    const std::uint64_t differing = a[word] ^ b[word];
    std::uint64_t dealt = 0;
    for (std::uint64_t rest = differing; rest != 0; rest &= rest - 1, --left) {
      // With the probability wanted / left, to 2^-32.
      const bool is_dealt = (engine() >> 32) * left >> 32 < wanted;
      dealt |= is_dealt ? rest & (~rest + 1) : 0;
      wanted -= is_dealt ? 1 : 0;
    }
    a[word] = (a[word] & ~differing) | dealt;
    b[word] = (b[word] & ~differing) | (differing & ~dealt);
  }
}

/// Goes to the next matrix of the chain.
void advance(std::vector<SolvedSet>& sets, RandomEngine& engine) {
  const int methods = static_cast<int>(sets.size());
  for (int i = 0; i < 2 * methods; ++i) {
    const int first = uniform_int(engine, 0, methods - 1),
              step = uniform_int(engine, 1, methods - 1);
    trade(sets[first], sets[(first + step) % methods], engine);
  }
}

/// The number of scenarios that two methods solve both, a pair after the other.
Eigen::VectorXd joint_successes(const std::vector<SolvedSet>& sets) {
  Eigen::VectorXd joint(static_cast<Eigen::Index>(sets.size() * (sets.size() - 1) / 2));
  Eigen::Index pair = 0;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::size_t both = 0;
      for (std::size_t word = 0; word < sets[i].size(); ++word)
        both += count_bits(sets[i][word] & sets[j][word]);
      joint[pair++] = static_cast<double>(both);
    }
  }
  return joint;
}

/// The joint successes of the outcomes, in column 0, and of the other matrices of the chain.
Eigen::MatrixXd sample_joint_successes(const OutcomeMatrix& outcomes, RandomEngine& engine) {
  const std::vector<SolvedSet> observed = solved_sets(outcomes);
  const Eigen::VectorXd joint = joint_successes(observed);
  Eigen::MatrixXd sample(joint.size(), kMatricesOfDimensionTest + 1);
  sample.col(0) = joint;
  const int before = uniform_int(engine, 0, static_cast<int>(kMatricesOfDimensionTest));
  std::vector<SolvedSet> sets = observed;
  for (int i = 1; i < sample.cols(); ++i) {
    if (i == before + 1) sets = observed;  // trades are reversible: the other end of the chain
    advance(sets, engine);
    sample.col(i) = joint_successes(sets);
  }
  return sample;
}

/// Rows with mean 0 and variance 1; those that do not vary are 0.
Eigen::MatrixXd standardized(const Eigen::MatrixXd& sample) {
  const Eigen::MatrixXd centered = sample.colwise() - sample.rowwise().mean();
  const Eigen::ArrayXd deviation =
      (centered.rowwise().squaredNorm() / static_cast<double>(sample.cols())).array().sqrt();
  return (centered.array().colwise() / (deviation > 0).select(deviation, 1)).matrix();
}

Eigen::MatrixXd symmetric_matrix(const Eigen::VectorXd& pairs, Eigen::Index size) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  Eigen::Index pair = 0;
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < i; ++j) matrix(i, j) = matrix(j, i) = pairs[pair++];
  return matrix;
}

/// Subtracts the effects a of the least squares z[i][j] = a[i] + a[j] beside the diagonal.
Eigen::MatrixXd without_effects(const Eigen::MatrixXd& z) {
  const auto n = static_cast<double>(z.rows());
  const Eigen::VectorXd sums = z.rowwise().sum();
  const Eigen::VectorXd effects = (sums.array() - sums.sum() / (2 * n - 2)) / (n - 2);
  Eigen::MatrixXd rest = (z.colwise() - effects).rowwise() - effects.transpose();
  rest.diagonal().setZero();
  return rest;
}

double min_within_groups(const Eigen::MatrixXd& z, const std::vector<bool>& second_group) {
  std::array<double, 2> sums{}, pairs{};
  for (Eigen::Index i = 0; i < z.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      if (second_group[i] != second_group[j]) continue;
      sums[second_group[i] ? 1 : 0] += z(i, j);
      pairs[second_group[i] ? 1 : 0] += 1;
    }
  }
  return std::min(sums[0] / std::sqrt(std::max(1.0, pairs[0])),
                  sums[1] / std::sqrt(std::max(1.0, pairs[1])));
}

/// The statistics of one matrix, without p.
DimensionTest statistics_of(const Eigen::MatrixXd& z) {
  using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;  // eigenvalues increase
  const Eigen::VectorXd direction = Solver(without_effects(z)).eigenvectors().rightCols<1>();
  DimensionTest test;
  test.eigenvalue = Solver(z, Eigen::EigenvaluesOnly).eigenvalues().tail<1>()[0];
  for (Eigen::Index i = 0; i < z.rows(); ++i)
    test.second_group.push_back((direction[i] < 0) != (direction[0] < 0));
  test.split = min_within_groups(z, test.second_group);
  return test;
}

}  // namespace

std::optional<DimensionTest> dimension_test(const OutcomeMatrix& outcomes, std::uint64_t seed) {
  if (outcomes.empty() || outcomes.front().size() < kMinMethodsOfDimensionTest) return std::nullopt;
  RandomEngine engine(seed);
  const auto methods = static_cast<Eigen::Index>(outcomes.front().size());
  const Eigen::MatrixXd z = standardized(sample_joint_successes(outcomes, engine));
  DimensionTest test = statistics_of(symmetric_matrix(z.col(0), methods));
  constexpr double kRounding = 1e-9;  // of equal matrices up to the order of methods
  double eigenvalues = 1, splits = 1;
  for (Eigen::Index i = 1; i < z.cols(); ++i) {
    const DimensionTest other = statistics_of(symmetric_matrix(z.col(i), methods));
    eigenvalues += other.eigenvalue >= test.eigenvalue - kRounding ? 1 : 0;
    splits += other.split >= test.split - kRounding ? 1 : 0;
  }
  test.eigenvalue_p = eigenvalues / static_cast<double>(z.cols());
  test.split_p = splits / static_cast<double>(z.cols());
  return test;
}

}  // namespace slalom
