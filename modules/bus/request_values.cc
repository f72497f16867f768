#include "modules/bus/request_values.h"

#include <charconv>
#include <sstream>
#include <vector>

#include "modules/bus/module.h"

namespace regista {

RobotId parse_robot(const std::string& text) {
  std::uint16_t number = 0;
  const char* begin = text.data() + 1;
  const char* end = text.data() + text.size();
  const bool has_team = text.size() >= 2 && (text[0] == 'Y' || text[0] == 'B');
  if (!has_team || std::from_chars(begin, end, number).ec != std::errc{} || std::to_string(number) != text.substr(1)) {
    throw RequestRefused("'" + text + "' is no robot, write for example Y3 or B11");
  }
  return {text[0] == 'Y' ? Team::yellow : Team::blue, number};
}

Pose parse_pose(const std::string& text) {
  std::istringstream words(text);
  std::vector<double> numbers;
  bool sound = true;
  for (std::string word; words >> word;) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    sound = sound && error == std::errc{} && end == word.data() + word.size() && std::isfinite(number);
    numbers.push_back(number);
  }
  if (!sound || (numbers.size() != 2 && numbers.size() != 3)) {
    throw RequestRefused("'" + text + "' is no place, write x and y in metres and, if wanted, the heading in radians");
  }
  return {{numbers[0], numbers[1]}, numbers.size() == 3 ? wrap_angle(numbers[2]) : 0.0};
}

}  // namespace regista
