// The closed form against the same filter written with matrices, and its covariance under abuse.
#include "world_model/axis_filter.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "tests/world_model/scene.h"

namespace regista {
namespace {

struct MatrixFilter {
  Eigen::Vector2d state;
  Eigen::Matrix2d covariance;

  void advance(double dt, double density) {
    Eigen::Matrix2d f;
    f << 1.0, dt, 0.0, 1.0;
    Eigen::Matrix2d q;
    q << dt * dt * dt / 3.0, dt * dt / 2.0, dt * dt / 2.0, dt;
    state = f * state;
    covariance = f * covariance * f.transpose() + density * q;
  }
  void correct(double measured, double delay, double noise) {
    const Eigen::RowVector2d h(1.0, -delay);
    const Eigen::Vector2d gain = covariance * h.transpose() / ((h * covariance * h.transpose()).value() + noise);
    state += gain * (measured - (h * state).value());
    covariance = (Eigen::Matrix2d::Identity() - gain * h) * covariance;
  }
};

TEST_CASE("axis filter equals the matrix form") {
  std::mt19937_64 random(1);
  for (int run = 0; run < 200; ++run) {
    CAPTURE(run);
    AxisFilter axis{0.3, -0.2, 0.01, 0.0, 4.0};
    MatrixFilter matrix{{0.3, -0.2}, Eigen::Vector2d(0.01, 4.0).asDiagonal()};
    for (int i = 0; i < 50; ++i) {
      const double dt = test::uniform(random, 0.001, 0.1);
      const double delay = i % 3 == 0 ? test::uniform(random, 0.0, 0.05) : 0.0;
      const double measured = test::uniform(random, -1.0, 1.0);
      const double noise = test::uniform(random, 1e-6, 1e-2);
      advance(axis, dt, 0.5);
      matrix.advance(dt, 0.5);
      correct(axis, measured - (axis.value - delay * axis.rate), delay, noise);
      matrix.correct(measured, delay, noise);
      REQUIRE(axis.value == Approx(matrix.state(0)).margin(1e-9));
      REQUIRE(axis.rate == Approx(matrix.state(1)).margin(1e-8));
      REQUIRE(axis.variance == Approx(matrix.covariance(0, 0)).epsilon(1e-6));
      REQUIRE(axis.covariance == Approx(matrix.covariance(0, 1)).epsilon(1e-6));
      REQUIRE(axis.rate_variance == Approx(matrix.covariance(1, 1)).epsilon(1e-6));
    }
  }
}

TEST_CASE("covariance stays positive for any steps, delays and noises") {
  std::mt19937_64 random(2);
  for (int run = 0; run < 500; ++run) {
    CAPTURE(run);
    AxisFilter axis{0.0, 0.0, 1e-7, 0.0, std::pow(10.0, test::uniform(random, -2.0, 3.0))};
    const double density = std::pow(10.0, test::uniform(random, -6.0, 3.0));
    for (int i = 0; i < 200; ++i) {
      const double noise = std::pow(10.0, test::uniform(random, -12.0, -2.0));
      if (i % 4 != 3) advance(axis, std::pow(10.0, test::uniform(random, -6.0, 0.0)), density);
      correct(axis, test::normal(random), i % 5 == 0 ? test::uniform(random, 0.0, 0.05) : 0.0, noise);
      REQUIRE(axis.variance > 0.0);
      REQUIRE(axis.rate_variance > 0.0);
      REQUIRE(axis.variance * axis.rate_variance >= axis.covariance * axis.covariance * (1.0 - 1e-9));
    }
  }
}

}  // namespace
}  // namespace regista
