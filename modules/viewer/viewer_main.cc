// regista-viewer: the window, or one picture (--snapshot), or a recording (--record).
#include <CLI/CLI.hpp>

#include "modules/process/module_main.h"
#include "modules/viewer/offscreen.h"
#include "modules/viewer/rawlog_recorder.h"
#include "modules/viewer/snapshot.h"
#include "modules/viewer/window.h"

namespace {

using namespace regista;

struct Flags {
  std::string snapshot;
  SnapshotAt at;
  std::string record;
  std::string size = "1280x800";
  int width_px = 0;
  int height_px = 0;
};

/// Empty when the text is a size, else why not.
std::string read_size(const std::string& text, Flags& flags) {
  char rest = 0;
  constexpr int kLargest_px = 8192;  // what software renderers draw
  const bool read = std::sscanf(text.c_str(), "%dx%d%c", &flags.width_px, &flags.height_px, &rest) == 2;
  const auto fits = [](int side) { return side >= 64 && side <= kLargest_px; };
  if (read && fits(flags.width_px) && fits(flags.height_px)) return {};
  return "'" + text + "' is no size; one is WIDTHxHEIGHT with 64 to 8192 pixels each";
}

void add_flags(CLI::App& app, Flags& flags) {
  auto* snapshot = app.add_option("--snapshot", flags.snapshot,
                                  "write one picture to this .png file and end; needs no "
                                  "display. With --lcm-url file:///run.lcmlog of a log");
  app.add_option("--at", flags.at,
                 "seconds after the first message at which the picture is taken; default: when the "
                 "plans of all teams with targets have come in, at most 2 s")
      ->needs(snapshot)
      ->check(CLI::NonNegativeNumber);
  app.add_option("--record", flags.record, "write robots and scene to this .rawlog file; without display until SIGINT")
      ->excludes(snapshot);
  app.add_option("--size", flags.size, "of the picture or window in pixels")
      ->capture_default_str()
      ->check([&flags](const std::string& text) { return read_size(text, flags); });
}

bool has_display() {
  try {
    require_display();
    return true;
  } catch (const WindowError&) {
    return false;
  }
}

}  // namespace

int main(int argc, char** argv) {
  Flags flags;
  std::string url;
  Bus* bus = nullptr;
  std::unique_ptr<RawlogRecorder> recorder;

  ModuleProgram program;
  program.name = "viewer";
  program.help = "Shows field, robots, targets, paths, the shared graphs and planning times.";
  program.add_flags = [&](CLI::App& app) { add_flags(app, flags); };
  program.bus_url = [&](const std::string& given) {
    return url = flags.snapshot.empty() ? given : at_full_speed(given);
  };
  program.make = [&](const ModuleContext& context) -> std::unique_ptr<Module> {
    read_size(flags.size, flags);
    bus = &context.bus;
    if (flags.snapshot.empty() && flags.record.empty()) require_display();
    if (flags.record.empty()) return std::make_unique<ViewerModule>(context.bus);
    recorder = std::make_unique<RawlogRecorder>(flags.record);
    return std::make_unique<ViewerModule>(context.bus, [&](const ViewerScene& scene) { recorder->record(scene); });
  };
  program.run = [&](Module& module, ProcessLoop& loop, const std::function<bool()>& stopped) {
    auto& viewer = dynamic_cast<ViewerModule&>(module);
    if (!flags.snapshot.empty()) {
      if (is_log(url)) {
        play_until_picture(viewer, *bus, flags.at, url, stopped);
      } else {
        await_picture(viewer, loop, *bus, flags.at, url, stopped);
      }
      write_picture(viewer.scene(), flags.snapshot, flags.width_px, flags.height_px);
    } else if (has_display()) {
      const auto take_in = [&] { loop.step(Duration::zero()); };
      show_window({take_in, [&] { return viewer.scene(); }, stopped}, flags.width_px, flags.height_px);
    } else {
      constexpr Duration kLongestWait = std::chrono::milliseconds(100);
      while (!stopped()) loop.step(kLongestWait);
    }
  };
  return module_main(program, argc, argv);
}
