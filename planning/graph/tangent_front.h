// One search for the shortest path over common tangents and the arcs between them: lazy A* from one end, a few legs at
// a time.
#pragma once

#include <limits>

#include "planning/graph/active_obstacles.h"
#include "planning/graph/corridor.h"
#include "planning/graph/detours.h"
#include "planning/graph/search_queue.h"
#include "planning/graph/separation.h"
#include "planning/graph/shared_graph.h"
#include "planning/graph/tangents.h"
#include "planning/plan.h"
#include "planning/request.h"

namespace regista::graph {

/// A shortest path is a taut string: legs along common tangents, arcs along boundaries. A node of the search is a leg
/// with the arc that leads to it; its end is a boundary and the side on which it is gone round. Only active obstacles
/// have tangents: none at first; one becomes active when it blocks a leg or an arc that the search is about to use.
/// Whatever the search drops is blocked by an active obstacle, so the first free path that is the cheapest among the
/// active ones is the shortest of all, and an empty queue proves that there is none.
/// The answer depends on field and query alone. Only scratch memory is kept between two searches.
class TangentFront {
 public:
  enum class Progress { going_on, goal, no_way, no_time, too_long };

  /// Begins at the query's start.
  void begin(SharedGraph& graph, const Query& query);

  /// Tests so many more legs, unless it ends before. no_way is a proof. The time is asked for once in 64
  /// steps, which are legs and departures that were put off.
  Progress advance(SharedGraph& graph, int legs);

  /// After goal: from the start to it, arcs as circumscribed polylines at most kArcExcess longer. Else to the arrival
  /// nearest to the goal, which may be the start alone.
  void trace(SharedGraph& graph, std::vector<Vec2>& path);

  /// All of the path that was traced last is free by clearance.h; false: nobody knows.
  bool is_path_known_free() const { return is_path_known_free_; }

  /// Exact length of the way to the goal, arcs as arcs. Metres.
  double length_m() const { return length_m_; }

  /// What the last search has cost.
  std::size_t legs_made() const { return legs_.size(); }

  /// Obstacles the last search went round, or tried to, in the order in which they became active.
  std::span<const ObstacleIndex> active() const { return active_.list(); }

 private:
  using LegIndex = std::uint32_t;
  using ArrivalIndex = std::uint32_t;
  using State = std::uint32_t;  ///< a slot and a side, or one of the ends

  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  static constexpr State kStartState = kNone - 1;
  static constexpr State kGoalState = kNone - 2;
  static constexpr std::uint32_t kStart = 0;  ///< the first leg, which has no length, and its arrival
  static constexpr double kInfinite_m = std::numeric_limits<double>::infinity();

  static double side_of(State state) { return 2.0 * static_cast<double>(state & 1U) - 1.0; }

  struct Leg {
    Place from, to;
    Vec2 along = Vec2::Zero();   ///< unit
    double cost = 0.0;           ///< length from the start to the leg's end
    ArrivalIndex parent = 0;     ///< where it begins
    State state = 0;             ///< where it arrives
    std::uint32_t free_of = 0;   ///< how many of the active obstacles it was tested against
    std::uint32_t bound_by = 0;  ///< how many of them its estimate takes into account
  };
  /// The end of a free leg, where ways go on.
  struct Arrival {
    ActiveObstacles::Departure departure;
    double reach = 0.0;  ///< how far ahead (in order) a path can go on
    double order = 0.0;  ///< of the leg's end, where it matters
    /// Departures to obstacles have been made where no shorter way than this leads on over them; the others are queued
    /// together, under the least of theirs (infinite for none).
    double made_m = 0.0;
    double next_m = 0.0;
    LegIndex leg = 0;
    State state = 0;
    ArrivalIndex next_here = 0;  ///< another arrival at this state
    Occluders occluders;         ///< of its departures
  };

  bool expand(SharedGraph& graph, LegIndex leg);
  static Departures window_of(const Body& body, const Leg& leg, double reach, double order);
  void make_departures(ArrivalIndex arrival);
  void depart_to_slot(ArrivalIndex arrival, State slot);
  void depart(ArrivalIndex arrival, const Body& to, double to_side, State state);
  void add_leg(ArrivalIndex arrival, const Body& from, const Tangent& tangent, State state);
  double least_to_goal_m(const Vec2& from, std::uint32_t few);
  bool is_put_off(const SearchQueue::Entry& leg);
  bool is_open(SharedGraph& graph, const Leg& leg);
  void pend_deepest(const ObstacleField& field, const Vec2& from, const Vec2& to,
                    std::span<const ObstacleIndex> blockers);
  void activate(SharedGraph& graph, ObstacleIndex obstacle);
  void activate_pending(SharedGraph& graph);

  Query query_;  ///< of the search that runs
  const ObstacleField* field_ = nullptr;
  Body start_, goal_;
  ActiveObstacles active_;
  Corridor corridor_;
  Detours detours_;                       ///< as many of the active ones as were asked for
  std::vector<ArrivalIndex> first_here_;  ///< by state: of a list of arrivals
  std::vector<Leg> legs_;                 ///< the first is the start
  std::vector<Arrival> arrivals_;         ///< the first is the start
  SearchQueue queue_;
  std::vector<ObstacleIndex> pending_;
  std::vector<ObstacleIndex> blockers_;
  std::vector<LegIndex> chain_;
  std::vector<Vec2> polyline_;
  bool is_path_known_free_ = false;
  Separation separation_;
  int legs_tested_ = 0;
  std::int64_t steps_ = 0;  ///< taken from the queue: legs, and departures that were put off
  double horizon_m_ = 0.0;  ///< estimate of what was last taken from the queue
  bool is_separated_ = false;
  LegIndex last_ = 0;  ///< of the way to the goal, or to the arrival nearest to it
  double nearest_m_ = 0.0;
  double length_m_ = 0.0;
};

}  // namespace regista::graph
