// The program itself, over a private multicast group: pictures, window under Xvfb, recording, errors in one line.
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <thread>

#include "child_process.h"
#include "fake_scene.h"
#include "modules/viewer/scene_drawing.h"
#include "picture.h"
#include "publish_scene.h"
#include "tests/support/temporary_folder.h"

namespace regista {
namespace {

using namespace std::chrono_literals;

const std::string kViewer = std::string(REGISTA_BIN_DIR) + "/regista-viewer";

/// Nobody else's: of this process, never leaving this machine.
std::string private_url() {
  const auto port = 20000 + getpid() % 20000;
  return "udpm://239.255.77.31:" + std::to_string(port) + "?ttl=0";
}

/// A scene on the air, a hundred times a second, its time running.
class Broadcast {
 public:
  explicit Broadcast(ViewerScene scene) : scene_(std::move(scene)) {
    thread_ = std::thread([this] { run(); });
  }
  ~Broadcast() {
    stop_ = true;
    thread_.join();
  }

 private:
  void run() {
    Bus bus(private_url(), [] { return Time{}; });
    while (!stop_) {
      publish_scene(bus, scene_);
      scene_.world.captured += 10ms;
      ++scene_.world.sequence;
      for (TeamScene& team : scene_.teams) {
        for (auto& [number, plan] : team.plans) plan.captured = scene_.world.captured;
        if (team.graph) team.graph->captured = scene_.world.captured;
      }
      std::this_thread::sleep_for(10ms);
    }
  }

  ViewerScene scene_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

void check_shows(const Picture& picture, const ViewerScene& scene) {
  INFO(picture.width() << " x " << picture.height());
  const View view = fitted_view(scene.field, picture.width(), picture.height());
  for (const RobotState& robot : scene.world.robots) {
    INFO(to_string(robot.id));
    CHECK(picture.count_near(color_of(robot.id.team), pixel_of(view, robot.pose.position_m), 6, 60) > 15);
  }
  CHECK(picture.count_near(palette::kBall, pixel_of(view, scene.world.ball->position_m), 4, 60) > 5);
  CHECK(alike(picture.at(pixel_of(view, {5.9, 4.4})), palette::kGrass, 12));
}

/// An X server of its own without screen; the number is chosen by the server.
class VirtualDisplay {
 public:
  explicit VirtualDisplay(const TemporaryFolder& scratch)
      : number_file_(scratch.path("display")),
        server_({"sh", "-c", "exec Xvfb -displayfd 9 -screen 0 1280x800x24 -nolisten tcp 9>" + number_file_}, {},
                scratch.path("xvfb")) {}

  /// ":7", empty when the server does not come up.
  std::string name() {
    for (int i = 0; i < 1000; ++i) {
      const std::string number = text_of(number_file_);
      if (!number.empty() && number.back() == '\n') return ":" + number.substr(0, number.size() - 1);
      std::this_thread::sleep_for(20ms);
    }
    return {};
  }

 private:
  std::string number_file_;
  ChildProcess server_;
};

/// Libraries may have had their say before.
std::string last_line(std::string text) {
  if (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

// A first scene alone is larger, a file's head smaller.
constexpr std::uintmax_t kFirstSceneBytes = 10'000;

std::uintmax_t size_of(const std::string& file) {
  std::error_code missing;
  const std::uintmax_t size = std::filesystem::file_size(file, missing);
  return missing ? 0 : size;
}

/// How many observations with that label rawlog-edit --info counts.
int observations_of(const std::string& info, const std::string& label) {
  const std::regex line(R"(\(Label/Occurs/Rate/Durat\.\) : +)" + label + " */ +([0-9]+) ");
  std::smatch match;
  return std::regex_search(info, match, line) ? std::stoi(match[1]) : 0;
}

}  // namespace

TEST_CASE("--snapshot of a live bus writes what is on the air") {
  const TemporaryFolder scratch;
  const ViewerScene scene = fake_scene();
  const Broadcast broadcast(scene);
  const RunResult result =
      run({kViewer, "--lcm-url", private_url(), "--snapshot", scratch.path("live.png"), "--size", "1600x1000"},
          {"DISPLAY"});
  INFO(result.output);
  REQUIRE(result.status == 0);
  const Picture picture(scratch.path("live.png"));
  CHECK(picture.width() == 1600);
  check_shows(picture, scene);
}

TEST_CASE("--snapshot of a log shows the moment asked for") {
  const TemporaryFolder scratch;
  ViewerScene scene = fake_scene();
  const Time begin = scene.world.captured;
  {
    Bus log("file://" + scratch.path("run.lcmlog") + "?mode=w", [] { return Time{}; });
    for (int i = 0; i <= 100; ++i) {
      scene.world.captured = begin + i * 100ms;
      scene.world.ball->position_m.x() = 0.05 * i;
      publish_scene(log, scene);
    }
  }
  const auto picture_at = [&](const std::vector<std::string>& at) {
    std::vector<std::string> command{kViewer, "--lcm-url", "file://" + scratch.path("run.lcmlog"), "--snapshot",
                                     scratch.path("log.png")};
    command.insert(command.end(), at.begin(), at.end());
    const RunResult result = run(command, {"DISPLAY"});
    INFO(result.output);
    REQUIRE(result.status == 0);
    return Picture(scratch.path("log.png"));
  };
  const auto ball_is_at = [&](const Picture& picture, double x) {
    const View view = fitted_view(scene.field, picture.width(), picture.height());
    return picture.count_near(palette::kBall, pixel_of(view, {x, scene.world.ball->position_m.y()}), 2, 60) > 5;
  };
  const Picture middle = picture_at({"--at", "4"});
  CHECK(ball_is_at(middle, 2.0));
  CHECK(!ball_is_at(middle, 2.5));
  CHECK(ball_is_at(picture_at({"--at", "1000"}), 5.0));
  CHECK(ball_is_at(picture_at({}), 0.15));
}

TEST_CASE("the window under Xvfb shows what is on the air and closes on SIGTERM") {
  const TemporaryFolder scratch;
  const ViewerScene scene = fake_scene();
  VirtualDisplay server(scratch);
  const std::string display = server.name();
  INFO(text_of(scratch.path("xvfb")));
  REQUIRE(!display.empty());
  const Broadcast broadcast(scene);
  ChildProcess viewer({kViewer, "--lcm-url", private_url()}, {"DISPLAY=" + display}, scratch.path("viewer"));
  const auto grab = [&] {
    const RunResult result =
        run({"import", "-display", display, "-window", "root", scratch.path("screen.png")}, {"DISPLAY=" + display});
    REQUIRE(result.status == 0);
    return Picture(scratch.path("screen.png"));
  };
  // A slow machine may take seconds to open the window and to draw the first picture with robots in it.
  const View view = fitted_view(scene.field, 1280, 800);
  const Vec2 robot = pixel_of(view, scene.world.robots[3].pose.position_m);
  Picture screen = grab();
  for (int i = 0; i < 100 && screen.count_near(palette::kYellow, robot, 6, 60) == 0; ++i) {
    REQUIRE(viewer.running());
    std::this_thread::sleep_for(200ms);
    screen = grab();
  }
  check_shows(screen, scene);
  viewer.signal(SIGTERM);
  INFO(text_of(scratch.path("viewer")));
  CHECK(viewer.wait(10s) == 0);
}

TEST_CASE("--record writes a rawlog that rawlog-edit reads, complete after SIGINT") {
  const TemporaryFolder scratch;
  const std::string file = scratch.path("run.rawlog");
  const ViewerScene scene = fake_scene();
  {
    const Broadcast broadcast(scene);
    ChildProcess viewer({kViewer, "--lcm-url", private_url(), "--record", file}, {"DISPLAY"}, scratch.path("viewer"));
    for (int i = 0; i < 1000 && size_of(file) < kFirstSceneBytes; ++i) std::this_thread::sleep_for(20ms);
    std::this_thread::sleep_for(1500ms);
    viewer.signal(SIGINT);
    const auto status = viewer.wait(10s);
    INFO(text_of(scratch.path("viewer")));
    REQUIRE(status == 0);
  }
  const RunResult info = run({"rawlog-edit", "--info", "-i", file, "-q"});
  INFO(info.output);
  REQUIRE(info.status == 0);
  for (const RobotState& robot : scene.world.robots) {
    INFO(to_string(robot.id));
    CHECK(observations_of(info.output, to_string(robot.id)) > 10);
  }
  constexpr const char* kScenes = "";  // MRPT writes a scene without its label
  CHECK(observations_of(info.output, kScenes) >= 2);
}

TEST_CASE("--record of a log ends with the log and holds every world state of it") {
  const TemporaryFolder scratch;
  ViewerScene scene = fake_scene();
  {
    Bus log("file://" + scratch.path("run.lcmlog") + "?mode=w", [] { return Time{}; });
    for (int i = 0; i < 250; ++i) {
      publish_scene(log, scene);
      scene.world.captured += 10ms;
    }
  }
  const RunResult result =
      run({kViewer, "--lcm-url", "file://" + scratch.path("run.lcmlog"), "--record", scratch.path("run.rawlog")},
          {"DISPLAY"});
  INFO(result.output);
  REQUIRE(result.status == 0);
  const RunResult info = run({"rawlog-edit", "--info", "-i", scratch.path("run.rawlog"), "-q"});
  CHECK(observations_of(info.output, "Y3") == 250);
  CHECK(observations_of(info.output, "") == 3);
}

TEST_CASE("what cannot be is said in one line, with the exit status") {
  const TemporaryFolder scratch;
  const auto refused = [](const RunResult& result, int status, const std::string& text) {
    INFO(result.output);
    CHECK(result.status == status);
    CHECK(last_line(result.output).starts_with("regista-viewer: " + text));
  };
  const std::vector<std::string> viewer{kViewer, "--lcm-url", private_url()};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), viewer.begin(), viewer.end());
    return more;
  };
  refused(run(viewer, {"DISPLAY"}), 1, "no display: set DISPLAY or use --snapshot FILE.png");
  refused(run(viewer, {"DISPLAY=:987"}), 1, "no display");
  refused(run(with({"--record", scratch.path("no/folder/x.rawlog")}), {"DISPLAY"}), 1, "cannot write the recording");
  refused(run(with({"--snapshot", scratch.path("x.png")}), {"DISPLAY"}), 1, "no message within 10 s");
  refused(run({kViewer, "--lcm-url", "file:///no/such.lcmlog", "--snapshot", scratch.path("x.png")}), 1, "cannot open");
  {
    const Broadcast broadcast(fake_scene());
    refused(run(with({"--snapshot", scratch.path("no/folder/x.png")}), {"DISPLAY"}), 1, "cannot write the picture");
  }
  CHECK(run(with({"--size", "big"})).status == 2);
  CHECK(run(with({"--at", "3"})).status == 2);
}

}  // namespace regista
