// The bus: newest wins, nothing malformed gets through, no exception crosses LCM.
#include "modules/bus/bus.h"

#include <catch2/catch.hpp>

#include "modules/bus/mailbox.h"
#include "modules/bus/module.h"
#include "modules/bus/request_values.h"

using namespace regista;

namespace {

void drain(Bus& bus) {
  while (bus.handle(Duration::zero())) {
  }
}

Targets targets(std::uint64_t sequence) {
  Targets value;
  value.sequence = sequence;
  return value;
}

}  // namespace

TEST_CASE("a mailbox keeps the newest value and counts what it skipped") {
  Time now{};
  Bus bus("memq://", [&] { return now; });
  Mailbox<Targets> mailbox(bus, channels::targets(Team::yellow));
  CHECK_FALSE(mailbox.fresh());
  CHECK(mailbox.newest() == nullptr);
  for (const std::uint64_t sequence : {1U, 2U, 3U}) bus.publish(channels::targets(Team::yellow), targets(sequence));
  bus.publish(channels::targets(Team::blue), targets(9));
  now += Duration{50};
  drain(bus);
  REQUIRE(mailbox.fresh());
  CHECK(mailbox.take()->sequence == 3);
  CHECK_FALSE(mailbox.fresh());
  CHECK(mailbox.newest()->sequence == 3);
  CHECK(mailbox.arrived() == Time{Duration{50}});
  CHECK(mailbox.reception().received == 3);
  CHECK(mailbox.reception().skipped == 2);
  now += Duration{100};
  CHECK(mailbox.is_younger_than(Duration{100}));
  CHECK_FALSE(mailbox.is_younger_than(Duration{99}));
}

TEST_CASE("a queue keeps all values up to its capacity, the newest at that") {
  Bus bus("memq://", [] { return Time{}; });
  Queue<Targets> queue(bus, channels::targets(Team::yellow), 2);
  for (const std::uint64_t sequence : {1U, 2U, 3U}) bus.publish(channels::targets(Team::yellow), targets(sequence));
  drain(bus);
  CHECK(queue.pop()->sequence == 2);
  CHECK(queue.pop()->sequence == 3);
  CHECK(queue.empty());
  CHECK_FALSE(queue.pop());
  CHECK(queue.reception().skipped == 1);
}

TEST_CASE("malformed messages are refused, counted and named; the good one before stays") {
  Bus bus("memq://", [] { return Time{}; });
  Mailbox<Targets> mailbox(bus, channels::targets(Team::yellow));
  bus.publish(channels::targets(Team::yellow), targets(1));
  bus.publish_raw("TARGETS.Y", std::vector<std::uint8_t>{1, 2, 3});
  bus.publish_raw("TARGETS.Y", std::vector<std::uint8_t>(100, 0xff));
  REQUIRE_NOTHROW(drain(bus));
  CHECK(mailbox.newest()->sequence == 1);
  CHECK(mailbox.reception().refused == 2);
  CHECK(bus.reception().refused == 2);
  CHECK(bus.reception().last_refusal.find("TARGETS.Y refused") == 0);
}

TEST_CASE("what a handler throws comes out of handle, and the bus goes on") {
  Bus bus("memq://", [] { return Time{}; });
  int calls = 0;
  const auto subscription = bus.subscribe_raw("X", [&](const std::string&, std::span<const std::uint8_t>) {
    if (++calls == 1) throw std::runtime_error("first");
  });
  bus.publish_raw("X", std::vector<std::uint8_t>{1});
  bus.publish_raw("X", std::vector<std::uint8_t>{1});
  CHECK_THROWS_WITH(drain(bus), "first");
  CHECK_NOTHROW(drain(bus));
  CHECK(calls == 2);
}

TEST_CASE("a bus that does not open says so") {
  CHECK_THROWS_AS(Bus("nonsense://", [] { return Time{}; }), BusError);
}

namespace {

struct EchoParams {
  double gain = 1.0;
  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("gain", self.gain, Range{0.0, 2.0}, "", "how loud");
  }
};

class EchoModule : public Module {
 public:
  explicit EchoModule(Bus& bus) : Module("echo", bus) {
    answer("echo.say", [this](const Request& request) {
      ++said;
      if (request.value.empty()) throw RequestRefused("say what?");
      return request.value;
    });
    expose<EchoParams>(params, [this](const EchoParams& changed) { params = changed; });
  }
  int said = 0;
  EchoParams params;

 protected:
  bool has_input() const override { return false; }
  void on_tick(Time) override {}
};

Reply ask(Bus& bus, EchoModule& module, const Request& request) {
  Mailbox<Reply> replies(bus, channels::reply());
  bus.publish(channels::request(), request);
  drain(bus);
  REQUIRE(module.ready());
  module.tick(Time{});
  drain(bus);
  REQUIRE(replies.fresh());
  return *replies.take();
}

}  // namespace

TEST_CASE("a request is answered once per id, repeated as often as asked") {
  Bus bus("memq://", [] { return Time{}; });
  EchoModule module(bus);
  const Request request{Time{}, 42, "echo", "echo.say", "", "hello"};
  for (int i = 0; i < 3; ++i) {
    const Reply reply = ask(bus, module, request);
    CHECK(reply.accepted);
    CHECK(reply.id == 42);
    CHECK(reply.text == "hello");
  }
  CHECK(module.said == 1);
  CHECK_FALSE(ask(bus, module, {Time{}, 43, "echo", "echo.say", "", ""}).accepted);
  const Reply unknown = ask(bus, module, {Time{}, 44, "echo", "echo.sing", "", ""});
  CHECK_FALSE(unknown.accepted);
  CHECK(unknown.text.find("echo.say") != std::string::npos);
}

TEST_CASE("parameters are listed, read and set by request, and a bad value changes nothing") {
  Bus bus("memq://", [] { return Time{}; });
  EchoModule module(bus);
  const std::int64_t before = module.parameters_fingerprint();
  CHECK(ask(bus, module, {Time{}, 1, "echo", "param.list", "", ""}).text.find("gain = 1") == 0);
  CHECK(ask(bus, module, {Time{}, 2, "echo", "param.set", "gain", "1.5"}).accepted);
  CHECK(ask(bus, module, {Time{}, 3, "echo", "param.get", "gain", ""}).text == "1.5");
  CHECK_FALSE(ask(bus, module, {Time{}, 4, "echo", "param.set", "gain", "3"}).accepted);
  CHECK_FALSE(ask(bus, module, {Time{}, 5, "echo", "param.set", "gian", "1"}).accepted);
  CHECK(module.params.gain == 1.5);
  CHECK(module.parameters_fingerprint() != before);
}

TEST_CASE("robots and places are read as people write them") {
  CHECK(parse_robot("Y3") == RobotId{Team::yellow, 3});
  CHECK(parse_robot("B11") == RobotId{Team::blue, 11});
  for (const char* wrong : {"", "Y", "X1", "Y-1", "Y1x", "Y01", "Y99999"})
    CHECK_THROWS_AS(parse_robot(wrong), RequestRefused);
  CHECK(parse_pose("1 -2").position_m == Vec2(1.0, -2.0));
  CHECK(parse_pose("1 2 0.5").heading_rad == 0.5);
  for (const char* wrong : {"", "1", "1 2 3 4", "1 x", "nan 1", "inf 0"})
    CHECK_THROWS_AS(parse_pose(wrong), RequestRefused);
}
