#include "control/team_wheels.h"

#include <charconv>
#include <sstream>
#include <stdexcept>

namespace regista {
namespace {

[[noreturn]] void refuse(const std::string& part, const std::string& why) {
  throw std::invalid_argument("wheels of single robots: '" + part + "' " + why +
                              "; write for example \"3: hub_radius_m=0.07; 12: wheel_radius_m=0.03\"");
}

std::uint16_t number_of(const std::string& text, const std::string& part) {
  std::uint16_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) refuse(part, "begins with no robot number");
  return number;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\n");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\n") - begin + 1);
}

WheelGeometry changed(WheelGeometry geometry, const std::string& settings, const std::string& part) {
  std::istringstream words(settings);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) refuse(part, "has '" + word + "' where a field=value should be");
    try {
      set_param(geometry, word.substr(0, equals), word.substr(equals + 1));
    } catch (const ParamError& error) {
      refuse(part, std::string("is wrong: ") + error.what());
    }
  }
  return geometry;
}

}  // namespace

TeamWheels::TeamWheels(const WheelGeometry& common, const std::string& exceptions) : common_(common) {
  std::istringstream parts(exceptions);
  for (std::string part; std::getline(parts, part, ';');) {
    part = trimmed(part);
    if (part.empty()) continue;  // a semicolon at the end
    const std::size_t colon = part.find(':');
    if (colon == std::string::npos) refuse(part, "has no colon after the robot number");
    const OmniWheels wheels(changed(common, part.substr(colon + 1), part));
    const bool is_new = exceptions_.emplace(number_of(trimmed(part.substr(0, colon)), part), wheels).second;
    if (!is_new) refuse(part, "is about a robot that came before");
  }
}

const OmniWheels& TeamWheels::of(std::uint16_t robot) const {
  const auto exception = exceptions_.find(robot);
  return exception != exceptions_.end() ? exception->second : common_;
}

}  // namespace regista
