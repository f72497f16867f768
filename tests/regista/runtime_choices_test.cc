// What was chosen at run time, as settings for a module that is started again.
#include "modules/regista/runtime_choices.h"

#include <catch2/catch.hpp>

namespace regista {
namespace {

using Settings = std::vector<std::string>;

void choose(RuntimeChoices& choices, std::int64_t id, const std::string& module, const std::string& verb,
            const std::string& key, const std::string& value, bool accepted = true) {
  choices.take(Request{{}, id, module, verb, key, value});
  choices.take(Reply{{}, id, accepted, module, ""});
}

TEST_CASE("accepted choices become settings of the module's section and team, the last of a key counts") {
  RuntimeChoices choices({"planner.Y", "planner.B", "world-model"});
  choose(choices, 1, "planner.Y", "param.set", "use", "visibility_sampling");
  choose(choices, 2, "planner.Y", "param.set", "team_margin_m", "0.0625");
  choose(choices, 3, "planner.Y", "planner.use", "rrt", "");
  choose(choices, 4, "planner.B", "planner.use", "rrt", "");
  choose(choices, 5, "world-model", "param.set", "robot.position_sigma_m", "0.002");
  CHECK(choices.settings_of("planner.Y") == Settings{"planner.yellow.team_margin_m=0.0625", "planner.yellow.use=rrt"});
  CHECK(choices.settings_of("planner.B") == Settings{"planner.blue.use=rrt"});
  CHECK(choices.settings_of("world-model") == Settings{"world_model.robot.position_sigma_m=0.002"});
}

TEST_CASE("what was refused, not answered, answered by another, or no choice is not kept") {
  RuntimeChoices choices({"planner.Y"});
  choose(choices, 1, "planner.Y", "planner.use", "nonsense", "", false);
  choose(choices, 2, "planner.Y", "param.get", "use", "");
  choose(choices, 3, "planner.B", "planner.use", "rrt", "");
  choices.take(Request{{}, 4, "planner.Y", "planner.use", "rrt", ""});
  choices.take(Reply{{}, 4, true, "planner.B", ""});
  choices.take(Reply{{}, 5, true, "planner.Y", ""});
  CHECK(choices.settings_of("planner.Y").empty());
  CHECK(choices.settings_of("planner.B").empty());
}

TEST_CASE("a repeated request does not bring back what was chosen before") {
  RuntimeChoices choices({"sim"});
  for (int i = 0; i < 3; ++i) choices.take(Request{{}, 1, "sim", "param.set", "key", "1"});
  choices.take(Reply{{}, 1, true, "sim", ""});
  choose(choices, 2, "sim", "param.set", "key", "2");
  choices.take(Reply{{}, 1, true, "sim", ""});
  CHECK(choices.settings_of("sim") == Settings{"sim.key=2"});
}

}  // namespace
}  // namespace regista
