#include "naoqi_api/service.h"

#include <gtest/gtest.h>

#include "naoqi_api/al_module.h"
#include "naoqi_api/signal_tracer.h"
#include "naoqi_api/tasks.h"
#include "tests/naoqi_api/demo_service.h"

namespace nao::rpc {
namespace {

std::string errorOf(const Pending<Value>& call) {
  return call.isDone() && call.outcome()->error ? *call.outcome()->error : "no error";
}

TEST(Service, CountsMembersFrom100InTheirOrder) {
  Demo demo;
  const Service service = demo.describe();
  EXPECT_EQ(service.findMethod(101)->parameters_signature, "(ii)");
  EXPECT_EQ(service.findMethod(102)->parameters_signature, "(ff)");
  EXPECT_EQ(service.findMethod(105)->return_signature, "[f]");
  EXPECT_EQ(service.signals().at(112).emitter.signature(), "(is)");
  EXPECT_EQ(service.properties().at(113).signature, "f");
  EXPECT_EQ(service.findSignal(113)->signature(), "(f)");
}

TEST(Service, AMemberMayHaveItsOwnUid) {
  const std::function<void()> nothing = [] {};
  Service service("S", "");
  service.method("a", nothing, "").method("b", nothing, "").at(100).method("c", nothing, "");
  EXPECT_EQ(service.findMethod(100)->name, "b");
  EXPECT_EQ(service.findMethod(101)->name, "a");
  EXPECT_EQ(service.findMethod(102)->name, "c");
  EXPECT_EQ(service.findMethod(100)->uid, 100U);
}

TEST(Service, ChoosesTheOverloadThatTakesTheArguments) {
  Demo demo;
  Service service = demo.describe();
  EXPECT_EQ(*service.call("add", {1, 2}).outcome()->value, Value(3));
  EXPECT_EQ(*service.call("add", {1.5, 2.25}).outcome()->value, Value(3.75F));
  EXPECT_EQ(*service.call("add", {1, 2.5}).outcome()->value, Value(3.5F));
  EXPECT_EQ(errorOf(service.call("add", {1})),
            "\tDemo::add\n\tCan't find method: add (resolved to '(i)')");
}

TEST(Service, RefusesArgumentsInTheWordsOfLibqi) {
  Demo demo;
  Service service = demo.describe();
  EXPECT_EQ(errorOf(service.call("say", {3})),
            "Call argument number 1 conversion failure from Int32 to String. Function signature: "
            "(Unknown,String).");
  EXPECT_EQ(errorOf(service.findMethod(101)->invoke({}, {1})),
            "Argument count mismatch, expected 3, got 2");
  EXPECT_EQ(errorOf(service.call("fail", {})), "deliberate failure");
}

TEST(Service, APendingCallEndsWhenItsServiceSaysSo) {
  Demo demo;
  Service service = demo.describe();
  const auto call = service.call("slow", {1500});
  EXPECT_FALSE(call.isDone());
  demo.finishSlowCalls();
  EXPECT_EQ(*call.outcome()->value, Value(1500));
}

TEST(Service, APendingCallCanBeCanceled) {
  Demo demo;
  Service service = demo.describe();
  const auto call = service.call("slow", {1500});
  call.cancel();
  EXPECT_TRUE(call.outcome()->isCanceled());
}

TEST(Service, ACallThatItsServiceDropsIsHeldByNobody) {
  const auto held = std::make_shared<int>(0);
  const std::function<Pending<int>()> forget = [held] {
    Pending<int> pending;
    pending.onCancel([held] {});
    return pending;
  };
  const auto before = held.use_count();
  {
    Service service("S", "");
    service.method("forget", forget, "");
    service.call("forget", {});
  }
  EXPECT_EQ(held.use_count(), before);
}

TEST(Service, TellsTheCallerToWhoAsks) {
  const std::function<std::string(const Caller&, int)> who = [](const Caller& caller, int number) {
    return caller.service->name() + std::to_string(number);
  };
  Service service("S", "");
  service.method("who", who, "", Argument{"number", ""});
  EXPECT_EQ(service.findMethod(100)->parameters_signature, "(i)");
  EXPECT_EQ(*service.call("who", {5}).outcome()->value, Value("S5"));
}

TEST(Emitter, TellsListenersInTheirOrderUntilTheyLeave) {
  const Signal<int> signal;
  std::vector<int> told;
  const auto first = signal.emitter().connect(
      [&](const std::vector<Value>& arguments) { told.push_back(arguments[0].to<int>()); });
  signal.emitter().connect([&](const auto& /*arguments*/) { told.push_back(-1); });
  signal(1);
  signal.emitter().disconnect(first);
  signal(2);
  EXPECT_EQ(told, (std::vector<int>{1, -1, -1}));
}

TEST(Emitter, AListenerMayLeaveWhileItIsTold) {
  const Signal<> signal;
  int told = 0;
  std::uint64_t second = 0;
  signal.emitter().connect([&](const auto& /*arguments*/) { signal.emitter().disconnect(second); });
  second = signal.emitter().connect([&](const auto& /*arguments*/) { ++told; });
  signal();
  EXPECT_EQ(told, 0);
}

TEST(Emitter, WhoComesOrLeavesWhileOthersAreToldIsToldNextTimeOrNeverAgain) {
  const Signal<> signal;
  int told = 0;
  const auto kept = std::make_shared<int>();
  std::vector<std::uint64_t> links;
  for (int k = 0; k < 100; ++k) {
    links.push_back(signal.emitter().connect([&told, kept](const Emission&) { ++told; }));
  }
  signal.emitter().connect([&](const Emission&) {
    for (const auto link : std::exchange(links, {})) signal.emitter().disconnect(link);
    signal.emitter().connect([&told](const Emission&) { told += 1000; });
  });
  signal();
  EXPECT_EQ(told, 100);
  EXPECT_EQ(kept.use_count(), 1);
  EXPECT_EQ(signal.emitter().listenerCount(), 2U);
  signal();
  EXPECT_EQ(told, 1100);
}

TEST(Emitter, WhatOneListenerEncodedIsThereForTheNext) {
  const Emitter emitter("(i)");
  int encoded = 0;
  for (int k = 0; k < 3; ++k) {
    emitter.connect([&](const Emission& emission) {
      const auto* bytes = emission.encoded("(i)", [&] {
        ++encoded;
        return std::optional(Bytes{7});
      });
      EXPECT_EQ(*bytes, Bytes{7});
    });
  }
  emitter.emit({1});
  EXPECT_EQ(encoded, 1);
}

TEST(PropertyOf, TellsItsChangesAndMayRefuse) {
  const Property<float> property(0.5F);
  float told = 0;
  property.emitter().connect(
      [&](const std::vector<Value>& arguments) { told = arguments[0].to<float>(); });
  property.onSet([](float value) {
    if (value > 1) throw CallError("too much");
  });
  property.set(0.75F);
  EXPECT_EQ(told, 0.75F);
  EXPECT_THROW(property.set(2), CallError);
  EXPECT_EQ(property.get(), 0.75F);
}

TEST(SignalTracer, TellsOfSignalsAndPropertiesWhileSomebodyListensToTheTrace) {
  Demo demo;
  const auto service = std::make_shared<Service>(demo.describe());
  std::vector<std::uint32_t> traced;
  SignalTracer::watch(service, [&](Service& of, std::uint32_t uid, const auto& /*arguments*/) {
    EXPECT_EQ(&of, service.get());
    traced.push_back(uid);
  });
  demo.tick(1, "before");
  const Emitter& trace = service->monitor().traceObject();
  const auto link = trace.connect([](const Emission&) {});
  demo.tick(2, "during");
  demo.level.set(0.25F);
  trace.disconnect(link);
  demo.tick(3, "after");
  EXPECT_EQ(traced.size(), 2U);
  EXPECT_EQ(service->findSignal("tick"), service->findSignal(traced.at(0)));
  EXPECT_EQ(demo.tick.emitter().listenerCount(), 0U);
}

class AlModuleTest : public testing::Test {
 protected:
  Pending<Value> call(const std::string& name, const std::vector<Value>& arguments) {
    return service_.call(name, arguments, {nullptr, nullptr, &tasks_});
  }
  Value result(const std::string& name, const std::vector<Value>& arguments) {
    return *call(name, arguments).outcome()->value;
  }

  Demo demo_;
  std::vector<std::function<void()>> timers_;
  int canceled_timers_ = 0;
  Tasks tasks_{[this](Duration, std::function<void()> then) {
    timers_.push_back(std::move(then));
    return [this] { ++canceled_timers_; };
  }};
  Service service_ = alModule("ALDemo", "A module.")
                         .method("slow", std::function<Pending<int>(int)>([this](int /*number*/) {
                                   Pending<int> pending;
                                   pending.onCancel([] {});
                                   slow_.push_back(pending);
                                   return pending;
                                 }),
                                 "Takes long.", Argument{"number", "Any."});
  std::vector<Pending<int>> slow_;
};

TEST_F(AlModuleTest, HasNaoQisLegacyMembersAt100To112) {
  const std::vector<std::string> names = {
      "exit",          "__pCall",       "pCall",         "version", "ping",
      "getMethodList", "getMethodHelp", "getModuleHelp", "wait",    "isRunning",
      "stop",          "getBrokerName", "getUsage"};
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(service_.findMethod(100 + i)->name, names[i]);
  }
  EXPECT_EQ(service_.findMethod(101)->parameters_signature, "(I[m])");
  EXPECT_EQ(service_.findMethod(101)->return_signature, "i");
  EXPECT_EQ(service_.findMethod(108)->parameters_signature, "(ii)");
  EXPECT_EQ(service_.findMethod(113)->name, "slow");
}

TEST_F(AlModuleTest, PostReturnsATaskThatRunsUntilTheCallEnds) {
  const int task = result("__pCall", {113U, Value::list({5})}).to<int>();
  EXPECT_EQ(result("isRunning", {task}), Value(true));
  slow_.at(0).resolve(1);
  EXPECT_EQ(result("isRunning", {task}), Value(false));
}

TEST_F(AlModuleTest, StopCancelsATask) {
  const int task = result("__pCall", {113U, Value::list({5})}).to<int>();
  call("stop", {task});
  EXPECT_TRUE(slow_.at(0).outcome()->isCanceled());
  EXPECT_EQ(result("isRunning", {task}), Value(false));
}

TEST_F(AlModuleTest, WaitEndsWithTheTaskOrTheTimeOut) {
  const int task = result("__pCall", {113U, Value::list({5})}).to<int>();
  const auto with_limit = call("wait", {task, 100});
  const auto without = call("wait", {task, 0});
  EXPECT_FALSE(with_limit.isDone());
  ASSERT_EQ(timers_.size(), 1U);
  timers_[0]();
  EXPECT_EQ(*with_limit.outcome()->value, Value(true));  // timed out
  EXPECT_FALSE(without.isDone());
  slow_.at(0).resolve(1);
  EXPECT_EQ(*without.outcome()->value, Value(false));
  EXPECT_EQ(result("wait", {task, 0}), Value(false));  // unknown by now
}

TEST_F(AlModuleTest, TasksAreBounded) {
  for (std::size_t i = 0; i < Tasks::kMost; ++i) result("__pCall", {113U, Value::list({5})});
  EXPECT_EQ(errorOf(call("__pCall", {113U, Value::list({5})})),
            "too many calls posted and not ended");
}

TEST_F(AlModuleTest, WaitsAreForgottenWithTheirClient) {
  const int task = result("__pCall", {113U, Value::list({5})}).to<int>();
  call("wait", {task, 1000}).abandon();
  call("wait", {task, 0}).abandon();
  EXPECT_EQ(tasks_.waitCount(task), 0U);
  EXPECT_GE(canceled_timers_, 1);
  EXPECT_EQ(result("isRunning", {task}), Value(true));
}

TEST_F(AlModuleTest, APostedCallThatOnlyWaitsEndsWithItsClient) {
  const auto client = std::make_shared<Session>(7, "tcp://127.0.0.1:1");
  Pending<Value> waits;
  waits.onlyWaits();
  Pending<Value> moves;
  moves.onCancel([] {});
  const int waiting = tasks_.start(waits, client);
  const int moving = tasks_.start(moves, client);
  client->end();
  EXPECT_FALSE(tasks_.isRunning(waiting));
  EXPECT_TRUE(tasks_.isRunning(moving));
}

TEST_F(AlModuleTest, TheShortWaitComesAfterAllOtherMembersAndHasNoLimit) {
  addShortWait(service_);
  EXPECT_EQ(service_.findMethod(114)->parameters_signature, "(i)");
  const int task = result("__pCall", {113U, Value::list({5})}).to<int>();
  const auto waiting = call("wait", {task});
  EXPECT_FALSE(waiting.isDone());
  slow_.at(0).resolve(1);
  EXPECT_TRUE(waiting.isDone());
}

TEST(Tasks, OfTwoRobotsHaveIdsOfOneCount) {
  const auto ids = std::make_shared<TaskIds>();
  Tasks one({}, ids);
  Tasks other({}, ids);
  const int first = one.start(Pending<Value>());
  EXPECT_EQ(other.start(Pending<Value>()), first + 1);
  EXPECT_FALSE(other.isRunning(first));
}

TEST_F(AlModuleTest, PostOfNoMethodIsAnError) {
  EXPECT_EQ(errorOf(call("__pCall", {999U, Value::list({})})), "no method has the id 999");
}

TEST_F(AlModuleTest, CallsByNameToo) {
  EXPECT_EQ(result("pCall", {Value::list({"ping"})}), Value(true));
  EXPECT_NE(errorOf(call("pCall", {1})), "no error");
}

TEST_F(AlModuleTest, CanNotBeShutDown) {
  EXPECT_EQ(errorOf(call("exit", {})), "not simulated: a client can not end a module");
}

TEST_F(AlModuleTest, ExplainsItself) {
  EXPECT_EQ(result("getMethodHelp", {"slow"}),
            Value::list({"slow", "Takes long.", Value::list({Value::list({"number", "Any."})}),
                         Value::list({"i", ""})}));
  EXPECT_EQ(result("getUsage", {"slow"}), Value("slow(i) -> i: Takes long."));
  EXPECT_EQ(result("getMethodList", {}).findItems()->size(), 14U);
}

}  // namespace
}  // namespace nao::rpc
