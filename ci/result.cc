#include "ci/result.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/check.h"

namespace nao::ci {
namespace {

using Json = nlohmann::json;

Json toJson(const Course& course) {
  Json json{{"time", course.time},
            {"stills", Json::array()},
            {"robots", Json::array()},
            {"balls", Json::array()}};
  for (const auto& still : course.stills) {
    json["stills"].push_back({{"time", still.time}, {"png", still.png}});
  }
  for (const auto& robot : course.robots) {
    json["robots"].push_back({{"name", robot.name},
                              {"model", robot.model},
                              {"x", robot.x},
                              {"y", robot.y},
                              {"asked", robot.asked},
                              {"sensed", robot.sensed}});
  }
  for (const auto& ball : course.balls) {
    json["balls"].push_back({{"name", ball.name}, {"x", ball.x}, {"y", ball.y}});
  }
  return json;
}

Course parseCourse(const Json& json) {
  Course course;
  course.time = json.at("time").get<std::vector<double>>();
  for (const Json& still : json.at("stills")) {
    course.stills.push_back({still.at("time"), still.at("png")});
  }
  for (const Json& robot : json.at("robots")) {
    course.robots.push_back({robot.at("name"), robot.at("model"), robot.at("x"), robot.at("y"),
                             robot.at("asked"), robot.at("sensed")});
  }
  for (const Json& ball : json.at("balls")) {
    course.balls.push_back({ball.at("name"), ball.at("x"), ball.at("y")});
  }
  return course;
}

}  // namespace

bool Result::passed() const {
  return trouble.empty() && std::all_of(verdicts.begin(), verdicts.end(),
                                        [](const Verdict& verdict) { return verdict.passed; });
}

std::string toJson(const Result& result) {
  Json json{{"scenario", result.scenario}, {"file", result.file},       {"about", result.about},
            {"seed", result.seed},         {"drawn", result.drawn},     {"time", result.time},
            {"hash", result.hash},         {"trouble", result.trouble}, {"passed", result.passed()},
            {"verdicts", Json::array()}};
  for (const Verdict& verdict : result.verdicts) {
    json["verdicts"].push_back({{"passed", verdict.passed},
                                {"expected", verdict.expected},
                                {"seen", verdict.seen},
                                {"at", verdict.at.count()},
                                {"line", verdict.line}});
  }
  json["course"] = toJson(result.course);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result parseResult(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    Result result;
    result.scenario = json.at("scenario");
    result.file = json.at("file");
    result.about = json.at("about");
    result.seed = json.at("seed");
    result.drawn = json.at("drawn").get<std::map<std::string, double>>();
    result.time = json.at("time");
    result.hash = json.at("hash");
    result.trouble = json.at("trouble");
    for (const Json& verdict : json.at("verdicts")) {
      result.verdicts.push_back({verdict.at("passed"), verdict.at("expected"), verdict.at("seen"),
                                 Duration(verdict.at("at").get<Duration::rep>()),
                                 verdict.at("line")});
    }
    result.course = parseCourse(json.at("course"));
    return result;
  } catch (const Json::exception& error) {
    throw InputError(std::string("the result can not be read: ") + error.what());
  }
}

}  // namespace nao::ci
