// Writing and reading logs: nothing is lost, damage is survived, a full disk is told.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <random>

#include "logs/log_info.h"
#include "logs/log_reader.h"
#include "logs/log_writer.h"
#include "tests/support/temporary_folder.h"

namespace regista {
namespace {

std::vector<LogMessage> random_messages(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 random(seed);
  std::vector<LogMessage> messages;
  for (std::size_t i = 0; i < count; ++i) {
    LogMessage message{
        from_us(static_cast<std::int64_t>(random() % 1'000'000'000)), "CHANNEL." + std::to_string(random() % 5), {}};
    message.bytes.resize(random() % 300);
    for (std::uint8_t& byte : message.bytes) byte = static_cast<std::uint8_t>(random());
    messages.push_back(std::move(message));
  }
  return messages;
}

void write_log(const std::string& file, const std::vector<LogMessage>& messages) {
  LogWriter writer(file);
  for (const LogMessage& message : messages) writer.write(message.received, message.channel, message.bytes);
  writer.close();
}

std::vector<LogMessage> read_log(const std::string& file) {
  LogReader reader(file);
  std::vector<LogMessage> messages;
  while (auto message = reader.next()) messages.push_back(std::move(*message));
  return messages;
}

std::string content_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_content(const std::string& file, const std::string& content) {
  std::ofstream(file, std::ios::binary) << content;
}

TEST_CASE("a log gives back what was written, and the same messages make the same bytes") {
  const TemporaryFolder folder;
  const auto messages = random_messages(7, 200);
  write_log(folder.path("a"), messages);
  write_log(folder.path("b"), messages);
  CHECK(read_log(folder.path("a")) == messages);
  CHECK(content_of(folder.path("a")) == content_of(folder.path("b")));
  LogReader reader(folder.path("a"));
  while (reader.next()) {
  }
  CHECK(reader.unread_bytes() == 0);
}

TEST_CASE("a log cut off anywhere gives all its whole messages and says how much is lost") {
  const TemporaryFolder folder;
  const auto messages = random_messages(3, 4);
  write_log(folder.path("whole"), messages);
  const std::string content = content_of(folder.path("whole"));
  std::size_t whole_before = 0;
  for (std::size_t cut = 0; cut < content.size(); ++cut) {
    write_content(folder.path("cut"), content.substr(0, cut));
    const auto read = read_log(folder.path("cut"));
    REQUIRE(read.size() >= whole_before);
    whole_before = read.size();
    REQUIRE(std::equal(read.begin(), read.end(), messages.begin()));
    std::size_t bytes = 0;
    for (const LogMessage& message : read) bytes += 28 + message.channel.size() + message.bytes.size();
    REQUIRE(log_info(folder.path("cut")).damaged_bytes == static_cast<std::int64_t>(cut - bytes));
  }
  CHECK(whole_before == messages.size() - 1);
}

TEST_CASE("what follows a damaged message is read all the same") {
  const TemporaryFolder folder;
  auto messages = random_messages(5, 6);
  write_log(folder.path("log"), messages);
  std::string content = content_of(folder.path("log"));
  // The third message's channel length becomes negative; it begins after two headers of 28 bytes.
  const std::size_t at =
      std::size_t{56} + 2U * messages[0].channel.size() + messages[0].bytes.size() + messages[1].bytes.size();
  REQUIRE(content.substr(at, 4) == "\xED\xA1\xDA\x01");
  content[at + 20] = '\xFF';
  write_content(folder.path("log"), content);
  messages.erase(messages.begin() + 2);
  CHECK(read_log(folder.path("log")) == messages);
  CHECK(log_info(folder.path("log")).damaged_bytes > 0);
}

TEST_CASE("random bytes are no log and do no harm") {
  const TemporaryFolder folder;
  std::mt19937_64 random(11);
  for (int round = 0; round < 10; ++round) {
    std::string noise;
    for (int i = 0; i < 400; ++i) {
      if (random() % 200 == 0) noise += std::string("\xED\xA1\xDA\x01", 4) + std::string(16, '\0');
      noise += static_cast<char>(random());
    }
    write_content(folder.path("noise"), noise);
    const LogInfo info = log_info(folder.path("noise"));
    CHECK(info.file_bytes == static_cast<std::int64_t>(noise.size()));
    CHECK(info.damaged_bytes >= 0);
  }
}

TEST_CASE("files that cannot be read or written are named") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(LogReader(folder.path("none")), Catch::Contains("none"));
  CHECK_THROWS_WITH(LogReader(folder.path("")), Catch::Contains("is no file"));
  CHECK_THROWS_WITH(LogWriter(folder.path("no/such/folder")), Catch::Contains("No such file"));
  LogWriter full("/dev/full");
  const std::vector<std::uint8_t> bytes(100'000);
  CHECK_THROWS_WITH(
      [&] {
        full.write(Time{}, "C", bytes);
        full.close();
      }(),
      Catch::Contains("No space left"));
}

TEST_CASE("channels that LCM could not read again are refused") {
  const TemporaryFolder folder;
  LogWriter writer(folder.path("log"));
  CHECK_THROWS_AS(writer.write(Time{}, "", {}), LogError);
  CHECK_THROWS_AS(writer.write(Time{}, std::string(1000, 'c'), {}), LogError);
  writer.write(Time{}, std::string(999, 'c'), {});
  writer.close();
  CHECK_THROWS_AS(writer.write(Time{}, "C", {}), LogError);
  CHECK(read_log(folder.path("log")).size() == 1);
}

TEST_CASE("log info counts, measures and rates per channel") {
  const TemporaryFolder folder;
  {
    LogWriter writer(folder.path("log"));
    const std::vector<std::uint8_t> bytes(10);
    for (int i = 0; i <= 100; ++i) writer.write(from_us(1'000'000 + i * 10'000), "FAST", bytes);
    writer.write(from_us(500'000), "ONCE", bytes);
    writer.close();
  }
  const LogInfo info = log_info(folder.path("log"));
  CHECK(info.messages == 102);
  CHECK(info.first == from_us(500'000));
  CHECK(info.last == from_us(2'000'000));
  CHECK(info.damaged_bytes == 0);
  REQUIRE(info.channels.size() == 2);
  CHECK(info.channels[0].channel == "FAST");
  CHECK(info.channels[0].bytes == 1010);
  CHECK(rate_hz(info.channels[0]) == Approx(100.0));
  CHECK(rate_hz(info.channels[1]) == 0.0);
}

TEST_CASE("an empty log has no messages") {
  const TemporaryFolder folder;
  write_content(folder.path("empty"), "");
  CHECK(log_info(folder.path("empty")).messages == 0);
}

TEST_CASE("the stamp is read without knowing the type") {
  CHECK_FALSE(stamp_of(std::vector<std::uint8_t>(15)).has_value());
  std::vector<std::uint8_t> bytes(16);
  bytes[14] = 1;
  bytes[15] = 2;
  CHECK(stamp_of(bytes) == from_us(258));
}

}  // namespace
}  // namespace regista
