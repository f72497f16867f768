#include "control/avoidance.h"

#include <algorithm>
#include <stdexcept>

#include "control/safety/published_search.h"

namespace regista {
namespace {

/// A change of velocity in no time is one within this.
constexpr double kShortest_s = 1e-3;

/// An opponent that stands is where it is seen, however late; from this speed on it drives.
constexpr double kDrives_mps = 0.5;

}  // namespace

SafetyMode safety_mode(const std::string& name) {
  if (name == "none") return SafetyMode::none;
  if (name == "published") return SafetyMode::published;
  if (name == "team") return SafetyMode::team;
  throw std::invalid_argument("safety.mode must be none, published or team, not '" + name + "'");
}

const std::vector<Vec2>& Avoidance::choose(std::span<SafetyRobot> team, std::span<const double> arrivals_s,
                                           std::span<const Opponent> opponents, const Surroundings& around,
                                           const ControlParams& params, const TickTimes& times) {
  const SafetyMode mode = safety_mode(params.safety.mode);
  chosen_.clear();
  if (mode == SafetyMode::team) {
    keep_out_of_the_way(team, arrivals_s, opponents, params, times.delay_s);
    search_.choose(team, opponents, around, params.limits, params.safety, times.period_s, chosen_);
    return chosen_;
  }
  for (std::size_t i = 0; i < team.size(); ++i) {
    // Where no search holds a wish down, the limit must.
    chosen_.push_back(mode == SafetyMode::none
                          ? clamped_norm(team[i].wanted_mps, team[i].speed_max_mps)
                          : published_choice(team, i, opponents, params.limits, params.safety, times.period_s));
  }
  return chosen_;
}

void Avoidance::keep_out_of_the_way(std::span<SafetyRobot> team, std::span<const double> arrivals_s,
                                    std::span<const Opponent> opponents, const ControlParams& params, double delay_s) {
  const VelocityChoiceParams& choice = params.velocity_choice;
  const double late_s = choice.foul_horizon_s > 0.0 ? choice.foul_horizon_per_delay * delay_s : 0.0;
  const double horizon_s = std::max(choice.horizon_s, choice.foul_horizon_s + late_s);
  if (horizon_s <= 0.0) return;
  const double bodies_m = 2.0 * params.limits.radius_m;
  const double reach_m = 2.0 * params.limits.speed_max_mps * horizon_s + bodies_m;
  const double acceleration = params.limits.acceleration_max_mps2;
  for (std::size_t i = 0; i < team.size(); ++i) {
    if (team[i].wanted_mps.isZero(0.0)) continue;  // who stands, stands
    const auto is_near = [&](const Vec2& other_m) {
      return (other_m - team[i].position_m).squaredNorm() < reach_m * reach_m;
    };
    neighbours_.clear();
    for (std::size_t j = 0; j < team.size(); ++j) {
      if (j == i || !is_near(team[j].position_m)) continue;
      // A team-mate's wish is known: it accelerates towards it. Those before i have chosen already.
      const Vec2 change_mps = team[j].wanted_mps - team[j].velocity_mps;
      neighbours_.push_back(
          {team[j].position_m, team[j].velocity_mps,
           clamped_norm(change_mps / std::max(params.safety.acceleration_lasts_s, kShortest_s), acceleration),
           bodies_m + params.safety.team_margin_m, false, 0.0});
    }
    for (const Opponent& opponent : opponents) {
      if (!is_near(opponent.position_m)) continue;
      neighbours_.push_back({opponent.position_m, opponent.velocity_mps, opponent.acceleration_mps2,
                             bodies_m + params.safety.opponent_margin_m, true,
                             late_s * std::min(1.0, opponent.velocity_mps.norm() / kDrives_mps)});
    }
    team[i].wanted_mps =
        choose_velocity(team[i], arrivals_s[i], neighbours_, choice, params.safety.acceleration_lasts_s);
  }
}

}  // namespace regista
