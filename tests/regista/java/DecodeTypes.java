// Reads, with the generated Java classes, the messages that the C++ side wrote to a folder: one file per type, named
// after it. Prints one line per type with some of its numbers.
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import regista.commands_t;
import regista.plan_t;
import regista.request_t;
import regista.world_state_t;

public class DecodeTypes {
  private static byte[] bytes(String folder, String type) throws Exception {
    return Files.readAllBytes(Paths.get(folder, type));
  }

  public static void main(String[] arguments) throws Exception {
    String folder = arguments[0];
    world_state_t world = new world_state_t(bytes(folder, "world_state_t"));
    System.out.println("world " + world.stamp_us + " " + world.robot_count + " " + world.robots[1].x_m + " "
        + world.robots[1].number + " " + world.balls[0].vy_mps);
    plan_t plan = new plan_t(bytes(folder, "plan_t"));
    System.out.println("plan " + plan.planner + " " + plan.waypoint_count + " " + plan.waypoints[1].y_m + " " + plan.goal_moved);
    commands_t commands = new commands_t(bytes(folder, "commands_t"));
    System.out.println("commands " + commands.command_count + " " + commands.commands[0].wheel_speeds_radps[3]);
    request_t request = new request_t(bytes(folder, "request_t"));
    System.out.println("request " + request.id + " " + request.verb);
  }
}
