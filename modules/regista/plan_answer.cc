#include "modules/regista/plan_answer.h"

#include <algorithm>

namespace regista {
namespace {

using nlohmann::json;

constexpr double kNanosecondsPerMicrosecond = 1e3;

json time_us(std::int64_t duration_ns) { return static_cast<double>(duration_ns) / kNanosecondsPerMicrosecond; }

json to_json(const Plan& plan, std::int64_t duration_ns) {
  json path = json::array();
  for (const Vec2& point : plan.path) path.push_back({point.x(), point.y()});
  return {
      {"status", name(plan.status)}, {"start_moved", plan.start_moved}, {"goal_moved", plan.goal_moved}, {"path", path},
      {"length", plan.length_m},     {"time_us", time_us(duration_ns)}, {"reason", plan.reason}};
}

json to_json(const PlanQuery& query, const QueryAnswer& answer) {
  // A single query's time is that of the whole, the field's lay-out included.
  if (!query.is_team) return to_json(answer.plans.front(), answer.total_ns);
  json plans = json::array();
  Plan worst;
  worst.status = PlanStatus::ok;
  for (std::size_t i = 0; i < answer.plans.size(); ++i) {
    plans.push_back(to_json(answer.plans[i], answer.plan_ns[i]));
    if (worst.status == PlanStatus::ok) worst = answer.plans[i];
  }
  return {{"status", name(worst.status)},
          {"plans", plans},
          {"time_us", time_us(answer.total_ns)},
          {"reason", worst.reason}};
}

json invalid(const std::string& reason) {
  Plan plan;
  plan.reason = reason;
  return to_json(plan, 0);
}

}  // namespace

QueryAnswer answer_query(Planner& planner, const PlanQuery& query, int repeat,
                         const std::function<std::int64_t()>& stopwatch) {
  QueryAnswer answer;
  answer.plans.resize(query.requests.size());
  answer.plan_ns.resize(query.requests.size());
  std::vector<PlanRequest> requests = query.requests;
  std::int64_t deadline_ns = 0;
  const std::function<bool()> out_of_time = [&] { return stopwatch() >= deadline_ns; };
  graph::SharedGraph graph;
  for (int round = 0; round < repeat; ++round) {
    graph.clear();
    const std::int64_t began_ns = stopwatch();
    graph.reset(query.bounds, query.obstacles);
    std::int64_t robot_began_ns = stopwatch();
    for (std::size_t i = 0; i < requests.size(); ++i) {
      if (query.budget_us) {
        deadline_ns = robot_began_ns + static_cast<std::int64_t>(*query.budget_us * kNanosecondsPerMicrosecond);
        requests[i].budget.out_of_time = &out_of_time;
      }
      planner.plan(graph, requests[i], answer.plans[i]);
      const std::int64_t robot_ended_ns = stopwatch();
      const std::int64_t duration_ns = robot_ended_ns - robot_began_ns;
      answer.plan_ns[i] = round == 0 ? duration_ns : std::min(answer.plan_ns[i], duration_ns);
      robot_began_ns = robot_ended_ns;
    }
    const std::int64_t total_ns = robot_began_ns - began_ns;
    answer.total_ns = round == 0 ? total_ns : std::min(answer.total_ns, total_ns);
  }
  return answer;
}

std::string answer_line(const std::string& line, Planner& planner, const std::string& planner_name, int repeat,
                        const std::function<std::int64_t()>& stopwatch) {
  json id = nullptr;
  json out;
  try {
    const json query = parse_line(line);
    id = id_of(query);
    const PlanQuery parsed = parse_query(query);
    out = to_json(parsed, answer_query(planner, parsed, repeat, stopwatch));
  } catch (const std::exception& error) {
    out = invalid(error.what());
  }
  out["id"] = id;
  out["planner"] = planner_name;
  // Reasons may quote bytes that are no UTF-8.
  return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace regista
