// Kalman filter of one coordinate and its rate, in closed form, driven by white acceleration noise. Robot positions,
// robot headings and ball positions are made of it. Source: Bar-Shalom, Li, Kirubarajan, "Estimation with Applications
// to Tracking and Navigation", 6.2.2 (continuous white noise acceleration model).
#pragma once

namespace regista {

/// Value and rate in the unit u and u/s, their covariance. Symmetry holds by construction: one number per pair.
struct AxisFilter {
  double value = 0.0;
  double rate = 0.0;
  double variance = 0.0;       ///< of value, u², > 0
  double covariance = 0.0;     ///< of value and rate, u²/s
  double rate_variance = 0.0;  ///< of rate, (u/s)², > 0
  bool operator==(const AxisFilter&) const = default;
};

/// Moves the estimate dt_s >= 0 onward; `density` is the power spectral density of the acceleration, u²/s³.
inline void advance(AxisFilter& axis, double dt_s, double density) {
  axis.value += axis.rate * dt_s;
  axis.variance += dt_s * (2.0 * axis.covariance + dt_s * axis.rate_variance) + density * dt_s * dt_s * dt_s / 3.0;
  axis.covariance += dt_s * axis.rate_variance + density * dt_s * dt_s / 2.0;
  axis.rate_variance += density * dt_s;
}

/// Variance of the difference between a measurement taken `delay_s` >= 0 before the estimate's time and its prediction.
inline double innovation_variance(const AxisFilter& axis, double delay_s, double noise_variance) {
  return axis.variance - 2.0 * delay_s * axis.covariance + delay_s * delay_s * axis.rate_variance + noise_variance;
}

/// Takes in a measurement of value − delay_s · rate. `innovation` is measured minus predicted (wrapped by the caller
/// where the value is an angle). Joseph's form: the covariance stays positive whatever the rounding.
inline void correct(AxisFilter& axis, double innovation, double delay_s, double noise_variance) {
  const double s = innovation_variance(axis, delay_s, noise_variance);
  const double gain = (axis.variance - delay_s * axis.covariance) / s;
  const double rate_gain = (axis.covariance - delay_s * axis.rate_variance) / s;
  axis.value += gain * innovation;
  axis.rate += rate_gain * innovation;
  // A = I − K H with H = (1, −delay).
  const double a00 = 1.0 - gain;
  const double a01 = gain * delay_s;
  const double a10 = -rate_gain;
  const double a11 = 1.0 + rate_gain * delay_s;
  const double p00 = axis.variance;
  const double p01 = axis.covariance;
  const double p11 = axis.rate_variance;
  axis.variance = a00 * a00 * p00 + 2.0 * a00 * a01 * p01 + a01 * a01 * p11 + gain * gain * noise_variance;
  axis.covariance =
      a00 * a10 * p00 + (a00 * a11 + a01 * a10) * p01 + a01 * a11 * p11 + gain * rate_gain * noise_variance;
  axis.rate_variance =
      a10 * a10 * p00 + 2.0 * a10 * a11 * p01 + a11 * a11 * p11 + rate_gain * rate_gain * noise_variance;
}

}  // namespace regista
