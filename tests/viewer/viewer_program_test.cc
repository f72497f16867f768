// The program itself, over a private multicast group: pictures, window under Xvfb, recording, errors in one line.
#include <atomic>
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <regex>
#include <thread>

#include "fake_scene.h"
#include "modules/viewer/scene_drawing.h"
#include "picture.h"
#include "publish_scene.h"
#include "tests/support/program.h"
#include "tests/support/virtual_display.h"

namespace regista {
namespace {

using namespace std::chrono_literals;

const std::string kViewer = executable("regista-viewer");

/// A scene on the air, a hundred times a second, its time running.
class Broadcast {
 public:
  Broadcast(std::string url, ViewerScene scene) : url_(std::move(url)), scene_(std::move(scene)) {
    thread_ = std::thread([this] { run(); });
  }
  ~Broadcast() {
    stop_ = true;
    thread_.join();
  }

 private:
  void run() {
    Bus bus(url_, [] { return Time{}; });
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

  std::string url_;
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
  const std::string url = private_bus();
  const ViewerScene scene = fake_scene();
  const Broadcast broadcast(url, scene);
  const RunResult result =
      run({kViewer, "--lcm-url", url, "--snapshot", scratch.path("live.png"), "--size", "1600x1000"}, {"DISPLAY"});
  INFO(result.error);
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
    INFO(result.error);
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

  const Picture strip = picture_at({"--at", "1,4,1000,1001", "--size", "640x400"});
  CHECK(strip.width() == 3 * 640);
  CHECK(strip.height() == 2 * 400);
  const View view = fitted_view(scene.field, 640, 400);
  const auto ball_in = [&](const Vec2& corner_px, double x) {
    const Vec2 ball = pixel_of(view, {x, scene.world.ball->position_m.y()});
    return strip.count_near(palette::kBall, corner_px + ball, 2, 60) > 2;
  };
  CHECK(ball_in({0, 0}, 0.5));
  CHECK(ball_in({640, 0}, 2.0));
  CHECK(ball_in({1280, 0}, 5.0));
  CHECK(ball_in({0, 400}, 5.0));  // the log has ended: what there was last
  CHECK(!ball_in({640, 400}, 5.0));
}

TEST_CASE("the window under Xvfb shows what is on the air and closes on SIGTERM") {
  const TemporaryFolder scratch;
  const ViewerScene scene = fake_scene();
  const VirtualDisplay display;
  const std::string url = private_bus();
  const Broadcast broadcast(url, scene);
  Program viewer({kViewer, "--lcm-url", url}, {"DISPLAY=" + display.name()});
  const auto grab = [&] {
    const RunResult result = run({"import", "-display", display.name(), "-window", "root", scratch.path("screen.png")});
    REQUIRE(result.status == 0);
    return Picture(scratch.path("screen.png"));
  };
  // A slow machine may take seconds to open the window and to draw the first picture with robots in it.
  const View view = fitted_view(scene.field, VirtualDisplay::kWidth_px, VirtualDisplay::kHeight_px);
  const Vec2 robot = pixel_of(view, scene.world.robots[3].pose.position_m);
  eventually([&] { return !is_alive(viewer.pid()) || grab().count_near(palette::kYellow, robot, 6, 60) > 0; });
  INFO(viewer.error());
  REQUIRE(is_alive(viewer.pid()));
  check_shows(grab(), scene);
  viewer.send(SIGTERM);
  CHECK(viewer.wait() == 0);
}

TEST_CASE("--record writes a rawlog that rawlog-edit reads, complete after SIGINT") {
  const TemporaryFolder scratch;
  const std::string file = scratch.path("run.rawlog");
  const ViewerScene scene = fake_scene();
  {
    const std::string url = private_bus();
    const Broadcast broadcast(url, scene);
    Program viewer({kViewer, "--lcm-url", url, "--record", file}, {"DISPLAY"});
    eventually([&] { return size_of(file) >= kFirstSceneBytes; });
    std::this_thread::sleep_for(1500ms);
    viewer.send(SIGINT);
    const auto status = viewer.wait();
    INFO(viewer.error());
    REQUIRE(status == 0);
  }
  const RunResult info = run({"rawlog-edit", "--info", "-i", file, "-q"});
  INFO(info.out << info.error);
  REQUIRE(info.status == 0);
  for (const RobotState& robot : scene.world.robots) {
    INFO(to_string(robot.id));
    CHECK(observations_of(info.out, to_string(robot.id)) > 10);
  }
  constexpr const char* kScenes = "";  // MRPT writes a scene without its label
  CHECK(observations_of(info.out, kScenes) >= 2);
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
  INFO(result.error);
  REQUIRE(result.status == 0);
  const RunResult info = run({"rawlog-edit", "--info", "-i", scratch.path("run.rawlog"), "-q"});
  CHECK(observations_of(info.out, "Y3") == 250);
  CHECK(observations_of(info.out, "") == 3);
}

TEST_CASE("what cannot be is said in one line, with the exit status") {
  const TemporaryFolder scratch;
  const auto refused = [](const RunResult& result, int status, const std::string& text) {
    INFO(result.error);
    CHECK(result.status == status);
    CHECK(last_line(result.error).starts_with("regista-viewer: " + text));
  };
  const std::string url = private_bus();
  const std::vector<std::string> viewer{kViewer, "--lcm-url", url};
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
    const Broadcast broadcast(url, fake_scene());
    refused(run(with({"--snapshot", scratch.path("no/folder/x.png")}), {"DISPLAY"}), 1, "cannot write the picture");
  }
  CHECK(run(with({"--size", "big"})).status == 2);
  CHECK(run(with({"--at", "3"})).status == 2);
}

}  // namespace regista
