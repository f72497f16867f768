// Requests and replies over real multicast: repeated until answered, matched by id and module.
#include "modules/regista/service_client.h"

#include <catch2/catch.hpp>
#include <future>
#include <mutex>
#include <thread>

#include "modules/bus/mailbox.h"
#include "modules/convert/service.h"
#include "modules/process/real_clock.h"
#include "tests/support/program.h"

namespace regista {
namespace {

/// Answers requests on a thread of its own until it dies.
class FakeModule {
 public:
  using Answer = std::function<std::vector<Reply>(const Request&, int seen)>;

  FakeModule(const std::string& url, Answer answer)
      : thread_([this, url, answer = std::move(answer)] { run(url, answer); }) {
    eventually([this] { return listening_.load(); });
  }
  ~FakeModule() {
    stop_ = true;
    thread_.join();
  }
  int seen() const { return seen_; }

 private:
  void run(const std::string& url, const Answer& answer) {
    Bus bus(url, real_clock());
    const Listener<Request> listener(bus, channels::request(), [&](const Request& request) {
      for (const Reply& reply : answer(request, ++seen_)) bus.publish(channels::reply(), reply);
    });
    listening_ = true;
    while (!stop_) bus.handle(std::chrono::milliseconds(20));
  }

  std::atomic<bool> stop_{false};
  std::atomic<bool> listening_{false};
  std::atomic<int> seen_{0};
  std::thread thread_;
};

constexpr Duration kPatience = std::chrono::seconds(60);

TEST_CASE("a request is repeated with the same id until it is answered") {
  const std::string url = private_bus();
  std::mutex mutex;
  std::vector<Request> requests;
  const FakeModule module(url, [&](const Request& request, int seen) -> std::vector<Reply> {
    const std::lock_guard lock(mutex);
    requests.push_back(request);
    if (seen < 3) return {};
    return {{request.sent, request.id, true, request.module, "done"}};
  });
  Bus bus(url, real_clock());
  const auto replies = ask(bus, {make_request(bus.now(), "planner.Y", "planner.use", "rrt", "value")}, kPatience);
  REQUIRE(replies.size() == 1);
  REQUIRE(replies[0].has_value());
  CHECK(replies[0]->text == "done");
  const std::lock_guard lock(mutex);
  REQUIRE(requests.size() >= 3);
  for (const Request& request : requests) CHECK(request == requests.front());
  CHECK(requests.front().module == "planner.Y");
  CHECK(requests.front().verb == "planner.use");
  CHECK(requests.front().key == "rrt");
  CHECK(requests.front().value == "value");
}

TEST_CASE("replies to others and of others are not taken") {
  const std::string url = private_bus();
  const FakeModule module(url, [](const Request& request, int) -> std::vector<Reply> {
    return {{request.sent, request.id + 1, true, request.module, "another's id"},
            {request.sent, request.id, true, "planner.B", "another module"},
            {request.sent, request.id, false, request.module, "mine"}};
  });
  Bus bus(url, real_clock());
  const auto replies = ask(bus, {make_request(bus.now(), "planner.Y", "verb")}, kPatience);
  REQUIRE(replies[0].has_value());
  CHECK(replies[0]->text == "mine");
  CHECK_FALSE(replies[0]->accepted);
}

TEST_CASE("who does not answer does not hide who does") {
  const std::string url = private_bus();
  const FakeModule module(url, [](const Request& request, int) -> std::vector<Reply> {
    if (request.module != "planner.B") return {};
    return {{request.sent, request.id, true, request.module, "here"}};
  });
  Bus bus(url, real_clock());
  // B's answer comes at once; the whole waits in vain for Y's.
  std::vector<std::optional<Reply>> replies;
  REQUIRE(eventually([&] {
    replies = ask(bus, {make_request(bus.now(), "planner.Y", "verb"), make_request(bus.now(), "planner.B", "verb")},
                  std::chrono::milliseconds(500));
    return replies[1].has_value();
  }));
  CHECK_FALSE(replies[0].has_value());
}

TEST_CASE("ids are not repeated") {
  CHECK(make_request(Time{}, "m", "v").id != make_request(Time{}, "m", "v").id);
  for (int i = 0; i < 100; ++i) CHECK(make_request(Time{}, "m", "v").id >= 0);
}

}  // namespace
}  // namespace regista
