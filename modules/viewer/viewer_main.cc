// regista-viewer: the window, or one picture (--snapshot), or a recording (--record).
#include <CLI/CLI.hpp>
#include <cstdio>

#include "modules/process/module_program.h"
#include "modules/viewer/offscreen.h"
#include "modules/viewer/rawlog_recorder.h"
#include "modules/viewer/snapshot.h"
#include "modules/viewer/window.h"

namespace {

using namespace regista;

struct Flags {
  std::string snapshot;
  std::vector<double> at_s;
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
  app.add_option("--at", flags.at_s,
                 "seconds after the first message at which the picture is taken; default: when the "
                 "plans of all teams with targets have come in, at most 2 s. Several, rising, comma between: as many "
                 "pictures in one")
      ->needs(snapshot)
      ->delimiter(',')
      ->check(CLI::NonNegativeNumber);
  app.add_option("--record", flags.record,
                 "write robots and scene to this .rawlog file; without a display until SIGINT, or to the end of a log")
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

/// What lives as long as the program runs.
struct Viewing {
  Flags flags;
  std::string url;
  Bus* bus = nullptr;
  std::unique_ptr<RawlogRecorder> recorder;

  bool takes_picture() const { return !flags.snapshot.empty(); }
  bool shows_window() const { return !takes_picture() && has_display(); }

  /// Without a window nobody watches the log's own pace.
  std::string open_url(const std::string& given) { return url = shows_window() ? given : at_full_speed(given); }

  std::unique_ptr<Module> make(const ModuleContext& context) {
    read_size(flags.size, flags);
    bus = &context.bus;
    if (!flags.record.empty()) {
      recorder = std::make_unique<RawlogRecorder>(flags.record);
      return std::make_unique<ViewerModule>(context.bus, [this](const ViewerScene& scene) { recorder->record(scene); });
    }
    if (!takes_picture()) require_display();
    return std::make_unique<ViewerModule>(context.bus);
  }

  void run(ViewerModule& module, ProcessLoop& loop, const std::function<bool()>& stopped) {
    if (takes_picture()) {
      take_picture(module, loop, stopped);
    } else if (shows_window()) {
      const auto take_in = [&loop] { loop.step(Duration::zero()); };
      const auto scene = [&module] { return module.scene(); };
      show_window({take_in, scene, stopped}, flags.width_px, flags.height_px);
    } else {
      record(module, loop, stopped);
    }
  }

  void take_picture(ViewerModule& module, ProcessLoop& loop, const std::function<bool()>& stopped) {
    SnapshotTrigger trigger(std::nullopt);
    std::vector<ViewerScene> scenes;
    const std::size_t pictures = std::max<std::size_t>(1, flags.at_s.size());
    while (scenes.size() < pictures) {
      if (!flags.at_s.empty()) trigger.set(flags.at_s[scenes.size()]);
      if (is_log(url)) {
        play_until_picture(module, *bus, trigger, url, stopped);
      } else {
        await_picture(module, loop, *bus, trigger, url, stopped);
      }
      scenes.push_back(module.scene());
    }
    write_strip(scenes, flags.snapshot, flags.width_px, flags.height_px);
  }

  void record(ViewerModule& module, ProcessLoop& loop, const std::function<bool()>& stopped) {
    constexpr Duration kLongestWait = std::chrono::milliseconds(100);
    const bool log = is_log(url);
    while (!stopped()) {
      if (!log) {
        loop.step(kLongestWait);
      } else if (!play_next(module, *bus)) {
        return;
      }
    }
  }
};

}  // namespace

int main(int argc, char** argv) {
  Viewing viewing;
  ModuleProgram program;
  program.name = "viewer";
  program.help = "Shows field, robots, targets, paths, the shared graphs and planning times.";
  program.add_flags = [&](CLI::App& app) { add_flags(app, viewing.flags); };
  program.bus_url = [&](const std::string& given) { return viewing.open_url(given); };
  program.make = [&](const ModuleContext& context) { return viewing.make(context); };
  program.run = [&](Module& module, ProcessLoop& loop, const std::function<bool()>& stopped) {
    viewing.run(dynamic_cast<ViewerModule&>(module), loop, stopped);
  };
  return module_main(program, argc, argv);
}
