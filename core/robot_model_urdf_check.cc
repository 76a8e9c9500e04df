#include <tinyxml.h>

#include <set>
#include <sstream>

#include "core/check.h"
#include "core/config_node.h"
#include "core/robot_model_urdf.h"

namespace nao {
namespace {

// How many numbers an attribute of URDF holds.
const std::map<std::string, int>& numbersPerAttribute() {
  static const std::map<std::string, int> table = {
      {"xyz", 3},   {"rpy", 3},   {"size", 3},   {"rgba", 4},     {"radius", 1},     {"length", 1},
      {"ixx", 1},   {"ixy", 1},   {"ixz", 1},    {"iyy", 1},      {"iyz", 1},        {"izz", 1},
      {"lower", 1}, {"upper", 1}, {"effort", 1}, {"velocity", 1}, {"multiplier", 1}, {"offset", 1}};
  return table;
}

class Checker {
 public:
  Checker(const std::string& file, const TiXmlDocument& xml) : file_(file), xml_(xml) {}

  UrdfLines run() {
    const TiXmlElement* robot = xml_.RootElement();
    if (robot == nullptr || robot->ValueStr() != "robot") {
      fail(robot == nullptr ? 1 : robot->Row(), "expected <robot> as the outermost element");
    }
    for (const TiXmlElement* e = robot->FirstChildElement("link"); e != nullptr;
         e = e->NextSiblingElement("link")) {
      add(*e, lines_.links);
    }
    for (const TiXmlElement* e = robot->FirstChildElement("joint"); e != nullptr;
         e = e->NextSiblingElement("joint")) {
      add(*e, lines_.joints);
    }
    for (const TiXmlElement* e = robot->FirstChildElement("joint"); e != nullptr;
         e = e->NextSiblingElement("joint")) {
      checkJoint(*e);
    }
    for (const TiXmlElement* e = robot->FirstChildElement("link"); e != nullptr;
         e = e->NextSiblingElement("link")) {
      checkNumbersBelow(*e);
    }
    return lines_;
  }

 private:
  [[noreturn]] void fail(int line, const std::string& sentence) const {
    throw InputError(complaint(file_, line, sentence));
  }

  std::string attribute(const TiXmlElement& element, const char* name) const {
    const std::string* value = element.Attribute(std::string(name));
    if (value == nullptr || value->empty()) {
      fail(element.Row(), "`" + std::string(name) + "`: missing in <" + element.ValueStr() + ">");
    }
    return *value;
  }

  void add(const TiXmlElement& element, std::map<std::string, int>& lines) {
    const std::string name = attribute(element, "name");
    if (!lines.emplace(name, element.Row()).second) {
      fail(element.Row(), "`" + name + "`: a <" + element.ValueStr() + "> given twice");
    }
  }

  void checkJoint(const TiXmlElement& joint) {
    const std::string name = attribute(joint, "name");
    const std::string type = attribute(joint, "type");
    const std::string parent = link(joint, "parent");
    const std::string child = link(joint, "child");
    checkType(joint, type, parent);
    if (type != "fixed" && name.find('/') != std::string::npos) {
      fail(joint.Row(), "joint '" + name + "': a joint that moves names keys of the robot's " +
                            "memory, whose parts `/` separates; expected a name without `/`");
    }
    if (!children_.insert(child).second) {
      fail(joint.Row(), "`child`: link '" + child + "' has two parent joints");
    }
    if (type == "revolute") checkLimit(joint, name);
    checkMimic(joint);
    checkNumbersBelow(joint);
  }

  void checkType(const TiXmlElement& joint, const std::string& type,
                 const std::string& parent) const {
    if (type == "revolute" || type == "continuous" || type == "fixed") return;
    if (type == "floating" && isEmptyRoot(parent)) return;
    fail(joint.Row(), "`type`: expected revolute, continuous or fixed, found '" + type + "'");
  }

  // An empty link that only one joint leaves: a name for the world.
  bool isEmptyRoot(const std::string& name) const {
    const TiXmlElement* robot = xml_.RootElement();
    int joints = 0;
    for (const TiXmlElement* e = robot->FirstChildElement("joint"); e != nullptr;
         e = e->NextSiblingElement("joint")) {
      if (link(*e, "child") == name) return false;
      joints += link(*e, "parent") == name ? 1 : 0;
    }
    for (const TiXmlElement* e = robot->FirstChildElement("link"); e != nullptr;
         e = e->NextSiblingElement("link")) {
      if (attribute(*e, "name") == name && e->FirstChildElement() != nullptr) return false;
    }
    return joints == 1;
  }

  std::string link(const TiXmlElement& joint, const char* role) const {
    const TiXmlElement* element = joint.FirstChildElement(role);
    if (element == nullptr) fail(joint.Row(), "expected <" + std::string(role) + " link=..>");
    std::string name = attribute(*element, "link");
    if (lines_.links.count(name) == 0) {
      fail(element->Row(), "`link`: expected the name of a <link>, found '" + name + "'");
    }
    return name;
  }

  void checkLimit(const TiXmlElement& joint, const std::string& name) const {
    const TiXmlElement* limit = joint.FirstChildElement("limit");
    if (limit == nullptr) {
      fail(joint.Row(), "joint '" + name + "' is revolute and needs a <limit>");
    }
    for (const char* key : {"lower", "upper", "effort", "velocity"}) attribute(*limit, key);
    checkNumbers(*limit);
    if (*parseNumber(attribute(*limit, "lower")) == *parseNumber(attribute(*limit, "upper"))) {
      fail(limit->Row(), "`lower`: expected another number than `upper`, found '" +
                             attribute(*limit, "lower") + "'");
    }
  }

  void checkMimic(const TiXmlElement& joint) const {
    const TiXmlElement* mimic = joint.FirstChildElement("mimic");
    if (mimic == nullptr) return;
    const std::string leader = attribute(*mimic, "joint");
    if (lines_.joints.count(leader) == 0) {
      fail(mimic->Row(), "`joint`: expected the name of a <joint>, found '" + leader + "'");
    }
  }

  void checkNumbersBelow(const TiXmlElement& parent) const {
    for (const TiXmlElement* e = parent.FirstChildElement(); e != nullptr;
         e = e->NextSiblingElement()) {
      checkNumbers(*e);
      checkNumbersBelow(*e);
    }
  }

  void checkNumbers(const TiXmlElement& element) const {
    for (const TiXmlAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
      const auto entry = numbersPerAttribute().find(a->NameTStr());
      const bool is_mass = element.ValueStr() == "mass" && a->NameTStr() == "value";
      checkSign(element, *a, is_mass);
      const int expected = is_mass ? 1 : entry == numbersPerAttribute().end() ? 0 : entry->second;
      if (expected == 0 || holdsNumbers(a->ValueStr(), expected)) continue;
      const std::string wanted = expected == 1 ? "a number" : std::to_string(expected) + " numbers";
      fail(element.Row(), "`" + a->NameTStr() + "` of <" + element.ValueStr() + ">: expected " +
                              wanted + ", found '" + a->ValueStr() + "'");
    }
  }

  // Sizes are above zero; masses, efforts and velocities not below it.
  void checkSign(const TiXmlElement& element, const TiXmlAttribute& a, bool is_mass) const {
    const std::string name = a.NameTStr();
    const bool is_size = name == "radius" || name == "length" || name == "size";
    const bool is_limit = element.ValueStr() == "limit" && (name == "effort" || name == "velocity");
    if (!is_mass && !is_size && !is_limit) return;
    std::istringstream words(a.ValueStr());
    for (std::string word; words >> word;) {
      const auto number = parseNumber(word);
      if (!number || *number > 0 || (!is_size && *number == 0)) continue;
      fail(element.Row(), "`" + name + "` of <" + element.ValueStr() + ">: expected " +
                              (is_size ? "sizes above 0" : "a number from 0 up") + ", found '" +
                              a.ValueStr() + "'");
    }
  }

  static bool holdsNumbers(const std::string& text, int count) {
    std::istringstream words(text);
    int numbers = 0;
    for (std::string word; words >> word; ++numbers) {
      if (!parseNumber(word)) return false;
    }
    return numbers == count;
  }

  const std::string& file_;
  const TiXmlDocument& xml_;
  UrdfLines lines_;
  std::set<std::string> children_;
};

}  // namespace

UrdfLines checkUrdf(const std::string& file, const std::string& xml) {
  TiXmlDocument document;
  document.Parse(xml.c_str());
  if (document.Error()) {
    throw InputError(
        complaint(file, document.ErrorRow(), std::string("not XML: ") + document.ErrorDesc()));
  }
  return Checker(file, document).run();
}

}  // namespace nao
