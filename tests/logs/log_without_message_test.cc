// A file that holds no whole message is told apart from a log before anything is done with it.
#include <catch2/catch.hpp>
#include <fstream>

#include "logs/log_reader.h"
#include "logs/log_writer.h"
#include "tests/support/temporary_folder.h"

namespace regista {
namespace {

TEST_CASE("a file without a whole message is refused, one with a message is not") {
  const TemporaryFolder folder;
  const std::string log = folder.path("log"), cut = folder.path("cut");
  LogWriter writer(log);
  writer.write(Time{}, "CHANNEL", std::vector<std::uint8_t>(20));
  writer.close();
  CHECK_NOTHROW(require_message(log));

  std::filesystem::copy(log, cut);
  std::filesystem::resize_file(cut, std::filesystem::file_size(log) - 1);
  CHECK_THROWS_WITH(require_message(cut), Catch::Contains(cut) && Catch::Contains("no whole message"));
  std::ofstream(folder.path("text")) << "no log at all";
  CHECK_THROWS_AS(require_message(folder.path("text")), LogError);
  std::ofstream(folder.path("empty"));
  CHECK_THROWS_AS(require_message(folder.path("empty")), LogError);
  CHECK_THROWS_AS(require_message(folder.path("none")), LogError);
}

}  // namespace
}  // namespace regista
