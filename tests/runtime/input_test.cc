// What a simulation takes over survives being written and read, whatever it is.
#include "runtime/input.h"

#include <gtest/gtest.h>

#include <set>

#include "runtime/plain_structs.h"

namespace nao::runtime {
namespace {

/// Gives every number, text and list below `value` a value of its own.
struct Filler {
  int next = 1;

  template <class T>
  void fill(T& value) {
    using namespace members_detail;
    if constexpr (std::is_same_v<T, bool>) {
      value = !value;
    } else if constexpr (std::is_enum_v<T>) {
      value = static_cast<T>(1);
    } else if constexpr (std::is_arithmetic_v<T>) {
      value = static_cast<T>(++next);
    } else if constexpr (kIsTime<T>) {
      value = T(Duration(++next));
    } else if constexpr (std::is_same_v<T, std::string>) {
      value = "text " + std::to_string(++next);
    } else if constexpr (std::is_same_v<T, Pose>) {
      value = translation(Vec3(++next, 2, 3));
    } else if constexpr (kIsMatrix<T>) {
      value.setConstant(++next);
    } else if constexpr (kIs<T, std::vector>) {
      value.resize(3);
      for (auto& item : value) fill(item);
    } else if constexpr (kIsJointArray<T>) {
      value = T(5);
      for (auto& item : value) fill(item);
    } else if constexpr (kIs<T, std::optional>) {
      fill(value.emplace());
    } else {
      std::apply([this](auto&... member) { (fill(member), ...); }, tieMembers(value));
    }
  }
};

std::vector<unsigned char> bytesOf(Input::Content content) {
  std::vector<unsigned char> bytes;
  Archive archive = Archive::saving(bytes);
  archiveContent(archive, content);
  return bytes;
}

Input::Content contentOf(const std::vector<unsigned char>& bytes) {
  Input::Content content;
  Archive archive = Archive::loading(bytes);
  archiveContent(archive, content);
  EXPECT_TRUE(archive.atEnd());
  return content;
}

/// One of every kind of input there is, each with values of its own.
struct Kinds {
  std::vector<Input::Content> all;
  Filler filler;

  Kinds() {
    addMotions<0>();
    addWorldRequests<0>();
    add<LedOrder>();
    add<BodyCommand>();
  }

  template <class T>
  void add() {
    T value{};
    filler.fill(value);
    all.emplace_back(std::move(value));
  }
  template <std::size_t i>
  void addMotions() {
    if constexpr (i < std::variant_size_v<motion::MotionAction>) {
      std::variant_alternative_t<i, motion::MotionAction> action{};
      filler.fill(action);
      all.emplace_back(motion::MotionRequest{i + 7, std::move(action)});
      addMotions<i + 1>();
    }
  }
  template <std::size_t i>
  void addWorldRequests() {
    if constexpr (i < std::variant_size_v<WorldRequest>) {
      std::variant_alternative_t<i, WorldRequest> request{};
      filler.fill(request);
      all.emplace_back(WorldRequest(std::move(request)));
      addWorldRequests<i + 1>();
    }
  }
};

TEST(Input, OfEveryKindIsReadAsItWasWritten) {
  const Kinds kinds;
  ASSERT_EQ(kinds.all.size(),
            std::variant_size_v<motion::MotionAction> + std::variant_size_v<WorldRequest> + 2);
  for (const Input::Content& content : kinds.all) {
    const auto bytes = bytesOf(content);
    const Input::Content read = contentOf(bytes);
    EXPECT_EQ(nameOf(read), nameOf(content));
    EXPECT_EQ(bytesOf(read), bytes) << nameOf(content);
  }
}

TEST(Input, KeepsItsValues) {
  const motion::WalkSteps steps{{{Foot::Right, {0.04, -0.1, 0.2}, 0.5}}, true, false};
  const auto read =
      std::get<motion::MotionRequest>(contentOf(bytesOf(motion::MotionRequest{12, steps})));
  EXPECT_EQ(read.id, 12u);
  const auto& walk = std::get<motion::WalkSteps>(read.action);
  ASSERT_EQ(walk.steps.size(), 1u);
  EXPECT_EQ(walk.steps[0].foot, Foot::Right);
  EXPECT_EQ(walk.steps[0].place.theta, 0.2);
  EXPECT_EQ(walk.steps[0].period, 0.5);
  EXPECT_TRUE(walk.clear);
  EXPECT_FALSE(walk.awaited);

  const auto timed = std::get<motion::MotionRequest>(
      contentOf(bytesOf(motion::MotionRequest{1, motion::MoveTo{{1, 2, 3}, 4.5, {}}})));
  EXPECT_EQ(std::get<motion::MoveTo>(timed.action).time, 4.5);
}

TEST(Input, HasANameForEveryKind) {
  const Kinds kinds;
  std::set<std::string> names;
  for (const Input::Content& content : kinds.all) names.insert(nameOf(content));
  EXPECT_EQ(names.size(), kinds.all.size());
  EXPECT_EQ(names.count("MoveTo"), 1u);
  EXPECT_EQ(names.count("PushRobot"), 1u);
}

TEST(Input, OfAStructWithOtherMembersIsRefused) {
  auto bytes = bytesOf(LedOrder{"ChestLeds", 1});
  ASSERT_EQ(bytes[2], 2);  // after the variant's number: how many members it was written with
  bytes[2] = 3;
  EXPECT_THROW(contentOf(bytes), InputError);
}

}  // namespace
}  // namespace nao::runtime
