// How nodes of trees answer, by the names of version 4.
#include <sstream>
#include <string>
#include <vector>

#include "behaviortree_cpp/bt_factory.h"
#include "behaviortree_cpp/json_export.h"
#include "behaviortree_cpp/loggers/bt_cout_logger.h"
#include "behaviortree_cpp/loggers/groot2_publisher.h"
#include "behaviortree_cpp/xml_parsing.h"
#include "checks.hpp"

struct Goal {
  double x = 0;
  double y = 0;
};

namespace BT {
template <>
inline Goal convertFromString(StringView str) {
  const auto parts = splitString(str, ';');
  if (parts.size() != 2) throw RuntimeError("invalid input)");
  return {convertFromString<double>(parts[0]), convertFromString<double>(parts[1])};
}
}  // namespace BT

struct Speed {
  double linear = 0;
  double angular = 0;
};
BT_JSON_CONVERTER(Speed, speed) {
  add_field("linear", &speed.linear);
  add_field("angular", &speed.angular);
}

namespace {

using BT::NodeStatus;

/// What the nodes did, in this order.
std::vector<std::string> events;

class MakeGoal : public BT::SyncActionNode {
 public:
  MakeGoal(const std::string& name, const BT::NodeConfig& config) : SyncActionNode(name, config) {}
  static BT::PortsList providedPorts() { return {BT::OutputPort<Goal>("goal")}; }
  NodeStatus tick() override {
    setOutput("goal", Goal{1.5, 2});
    return NodeStatus::SUCCESS;
  }
};

class UseGoal : public BT::SyncActionNode {
 public:
  UseGoal(const std::string& name, const BT::NodeConfig& config, int factor)
      : SyncActionNode(name, config), factor_(factor) {}
  static BT::PortsList providedPorts() {
    return {BT::InputPort<Goal>("goal"), BT::InputPort<std::string>("note", "none", "a note")};
  }
  NodeStatus tick() override {
    const auto goal = getInput<Goal>("goal");
    if (!goal) throw BT::RuntimeError("error reading port [goal]:", goal.error());
    std::ostringstream text;
    text << factor_ * goal->x << ' ' << goal->y << ' ' << getInput<std::string>("note").value();
    events.push_back(text.str());
    return NodeStatus::SUCCESS;
  }

 private:
  int factor_;
};

/// Needs some ticks, and notes what happens to it.
class Job : public BT::StatefulActionNode {
 public:
  Job(const std::string& name, const BT::NodeConfig& config) : StatefulActionNode(name, config) {}
  static BT::PortsList providedPorts() {
    return {BT::InputPort<int>("ticks", 2, "how many"), BT::InputPort<bool>("fails", false, "")};
  }
  NodeStatus onStart() override {
    events.push_back(name() + " starts");
    left_ = getInput<int>("ticks").value();
    return onRunning();
  }
  NodeStatus onRunning() override {
    if (--left_ > 0) return NodeStatus::RUNNING;
    events.push_back(name() + " ends");
    return getInput<bool>("fails").value() ? NodeStatus::FAILURE : NodeStatus::SUCCESS;
  }
  void onHalted() override { events.push_back(name() + " is halted"); }

 private:
  int left_ = 0;
};

class IsOn : public BT::ConditionNode {
 public:
  explicit IsOn(const std::string& name) : ConditionNode(name, {}) {}
  NodeStatus tick() override { return is_on ? NodeStatus::SUCCESS : NodeStatus::FAILURE; }

  static inline bool is_on = true;
};

BT::BehaviorTreeFactory make_factory() {
  BT::BehaviorTreeFactory factory;
  factory.registerNodeType<MakeGoal>("MakeGoal");
  factory.registerNodeType<UseGoal>("UseGoal", 2);
  factory.registerNodeType<Job>("Job");
  factory.registerNodeType<IsOn>("IsOn");
  return factory;
}

/// The answers of each tick until it has none that is RUNNING.
std::string answers(BT::BehaviorTreeFactory& factory, const std::string& inside) {
  events.clear();
  auto tree = factory.createTreeFromText(R"(<root BTCPP_format="4"><BehaviorTree ID="Main">)" +
                                         inside + "</BehaviorTree></root>");
  std::string result;
  for (int i = 0; i < 20; ++i) {
    const NodeStatus status = tree.tickExactlyOnce();
    result += BT::toStr(status)[0];
    if (status != NodeStatus::RUNNING) break;
  }
  return result;
}

std::string told() {
  std::string all;
  for (const std::string& one : events) all += one + ", ";
  return all;
}

void check_ports(Checks& checks, BT::BehaviorTreeFactory& factory) {
  CHECK(answers(factory, R"(<Sequence><MakeGoal goal="{there}"/><UseGoal goal="{there}"/>
    <UseGoal goal="-1;3" note="text"/></Sequence>)") == "S");
  CHECK(told() == "3 2 none, -2 3 text, ");
  CHECK_THROWS(BT::RuntimeError, answers(factory, R"(<UseGoal goal="{nowhere}"/>)"));
  CHECK_THROWS(BT::RuntimeError, answers(factory, R"(<UseGoal/>)"));
  CHECK_THROWS(BT::RuntimeError, answers(factory, R"(<UseGoal gaol="1;2"/>)"));
  CHECK_THROWS(BT::RuntimeError, answers(factory, "<Nobody/>"));
  CHECK_THROWS(BT::RuntimeError, answers(factory, "<Sequence/>"));
  CHECK_THROWS(BT::RuntimeError, answers(factory, "<Inverter><IsOn/><IsOn/></Inverter>"));
  CHECK_THROWS(BT::RuntimeError, answers(factory, R"(<IsOn _skipIf="true"/>)"));
  CHECK_THROWS(BT::RuntimeError, auto tree = factory.createTreeFromText("<root"));
  CHECK_THROWS(BT::BehaviorTreeException, factory.registerNodeType<Job>("Job"));

  const auto board = BT::Blackboard::create();
  board->set("level", "42");
  board->set<double>("speed", 1.5);
  CHECK(board->get<int>("level") == 42 && board->get<std::string>("level") == "42");
  int whole = 0;
  CHECK(board->get("speed", whole) && whole == 1 && !board->get("none", whole));
  CHECK_THROWS(BT::RuntimeError, (void)board->get<int>("none"));
  CHECK(BT::convertFromString<std::vector<double>>("1;2.5").at(1) == 2.5);
  CHECK(BT::convertFromString<NodeStatus>("FAILURE") == NodeStatus::FAILURE);
  CHECK_THROWS(BT::RuntimeError, (void)BT::convertFromString<int>("1x"));
  CHECK_THROWS(BT::LogicError, (void)BT::convertFromString<std::vector<Goal>>("1"));
}

void check_controls(Checks& checks, BT::BehaviorTreeFactory& factory) {
  CHECK(answers(
            factory,
            R"(<Sequence><Job name="a"/><Job name="b" fails="true"/><Job name="c"/></Sequence>)") ==
        "RRF");
  CHECK(told() == "a starts, a ends, b starts, b ends, ");
  CHECK(answers(factory, R"(<Fallback><Job name="a" fails="1"/><Job name="b"/></Fallback>)") ==
        "RRS");
  IsOn::is_on = false;
  CHECK(answers(factory,
                R"(<ReactiveFallback><IsOn/><Job name="a" ticks="3"/></ReactiveFallback>)") ==
        "RRS");
  CHECK(answers(factory, R"(<IfThenElse><IsOn/><Job name="a"/><Job name="b"/></IfThenElse>)") ==
            "RS" &&
        told() == "b starts, b ends, ");
  CHECK(answers(factory, R"(<Parallel success_count="2"><Job name="a" ticks="1"/><Job name="b"/>
    <Job name="c" ticks="9"/></Parallel>)") == "RS");
  CHECK(told() == "a starts, a ends, b starts, c starts, b ends, c is halted, ");
  CHECK(answers(factory, R"(<Parallel failure_count="-1"><Job name="a" fails="1" ticks="1"/>
    <Job name="b" fails="1"/></Parallel>)") == "F");
  CHECK(
      answers(factory, R"(<Switch2 variable="b" case_1="a" case_2="b"><Job name="a"/><Job name="b"/>
    <Job name="c"/></Switch2>)") == "RS" &&
      told() == "b starts, b ends, ");

  // What was begun ends when a condition before it says no.
  IsOn::is_on = true;
  events.clear();
  auto tree = factory.createTreeFromText(R"(<root BTCPP_format="4"><BehaviorTree ID="Main">
    <ReactiveSequence><IsOn/><Job name="a" ticks="5"/></ReactiveSequence></BehaviorTree></root>)");
  CHECK(tree.tickOnce() == NodeStatus::RUNNING);
  IsOn::is_on = false;
  CHECK(tree.tickOnce() == NodeStatus::FAILURE && told() == "a starts, a is halted, ");
  IsOn::is_on = true;
  CHECK(answers(factory, R"(<WhileDoElse><IsOn/><Job name="a"/><Job name="b"/></WhileDoElse>)") ==
        "RS");
}

/// An error on request: the child that runs is another than before.
void check_reactive(Checks& checks, BT::BehaviorTreeFactory& factory) {
  const std::string two = R"(<ReactiveSequence><Job name="a"/><Job name="b"/></ReactiveSequence>)";
  BT::ReactiveSequence::EnableException(true);
  CHECK_THROWS(BT::LogicError, (void)answers(factory, two));
  BT::ReactiveSequence::EnableException(false);
  CHECK(
      answers(factory,
              R"(<ReactiveSequence><Job name="a" ticks="1"/><Job name="b"/></ReactiveSequence>)") ==
      "RS");
}

void check_texts(Checks& checks, BT::BehaviorTreeFactory& factory) {
  BT::RegisterJsonDefinition<Speed>();
  const auto speed = BT::convertFromString<Speed>(R"(json:{"linear": 0.5, "angular": -1})");
  CHECK(speed.linear == 0.5 && speed.angular == -1);
  CHECK(BT::JsonExporter::get().toJson(speed).dump() ==
        R"({"__type":"Speed","angular":-1.0,"linear":0.5})");
  CHECK(BT::convertFromString<std::vector<Speed>>(R"(json:[{"linear": 2, "angular": 0}])")
            .at(0)
            .linear == 2);
  CHECK_THROWS(BT::RuntimeError, (void)BT::convertFromJSON<Speed>("{"));
  CHECK_THROWS(BT::RuntimeError, (void)BT::convertFromJSON<Speed>(R"({"linear": 1})"));
  CHECK(BT::StartWith("json:{}", "json:") && !BT::StartWith("js", "json:") &&
        BT::StartWith("{a}", '{'));
  const std::string model = BT::writeTreeNodesModelXML(factory);
  CHECK(model.find("<Condition ID=\"IsOn\"/>") != std::string::npos);
  CHECK(model.find("<input_port name=\"goal\" type=\"Goal\"/>") != std::string::npos);
  CHECK(model.find("default=\"none\">a note</input_port>") != std::string::npos);
  CHECK(model.find("Sequence") == std::string::npos);
}

void check_decorators(Checks& checks, BT::BehaviorTreeFactory& factory) {
  CHECK(answers(factory, "<Inverter><AlwaysFailure/></Inverter>") == "S");
  CHECK(answers(factory, "<ForceFailure><AlwaysSuccess/></ForceFailure>") == "F");
  CHECK(answers(factory, R"(<Repeat num_cycles="3"><Job name="a" ticks="1"/></Repeat>)") == "S" &&
        events.size() == 6);
  CHECK(
      answers(factory, R"(<RetryUntilSuccessful num_attempts="2"><Job name="a" ticks="1" fails="1"/>
    </RetryUntilSuccessful>)") == "F" &&
      events.size() == 4);
  CHECK(answers(factory, R"(<Timeout msec="0"><Job name="a" ticks="9"/></Timeout>)") == "RF" &&
        told() == "a starts, a is halted, ");
  factory.registerSimpleDecorator("Twice", [](NodeStatus status, BT::TreeNode&) { return status; });
  CHECK(answers(factory, "<Twice><AlwaysFailure/></Twice>") == "F");
  auto tree = factory.createTreeFromText(R"(<root BTCPP_format="4"><BehaviorTree ID="Main">
    <Delay delay_msec="20"><AlwaysSuccess/></Delay></BehaviorTree></root>)");
  const auto begin = std::chrono::steady_clock::now();
  CHECK(tree.tickWhileRunning() == NodeStatus::SUCCESS);
  CHECK(std::chrono::steady_clock::now() - begin >= std::chrono::milliseconds(20));
}

void check_subtrees(Checks& checks, BT::BehaviorTreeFactory& factory) {
  events.clear();
  factory.registerBehaviorTreeFromText(R"(<root BTCPP_format="4">
    <BehaviorTree ID="Main"><Sequence><MakeGoal goal="{there}"/>
      <SubTree ID="Go" target="{there}" note="by hand"/>
      <SubTree ID="Rest" _autoremap="true"/></Sequence></BehaviorTree>
    <BehaviorTree ID="Go"><UseGoal goal="{target}" note="{note}"/></BehaviorTree>
    <BehaviorTree ID="Rest"><UseGoal goal="{there}"/></BehaviorTree></root>)");
  CHECK(factory.registeredBehaviorTrees().size() == 3);
  auto tree = factory.createTree("Main");
  const BT::StdCoutLogger logger(tree);
  const BT::Groot2Publisher groot(tree);
  CHECK(tree.tickWhileRunning() == NodeStatus::SUCCESS);
  CHECK(told() == "3 2 by hand, 3 2 none, " && tree.subtrees.size() == 3);
  std::ostringstream text;
  BT::printTreeRecursively(tree.rootNode(), text);
  CHECK(text.str().find("   MakeGoal\n   Go\n      UseGoal\n") != std::string::npos);
  int changes = 0;
  const auto subscription = tree.rootNode()->subscribeToStatusChange(
      [&](BT::TimePoint, const BT::TreeNode&, NodeStatus, NodeStatus) { ++changes; });
  tree.tickOnce();
  CHECK(changes == 3);  // RUNNING, SUCCESS, IDLE
  CHECK_THROWS(BT::RuntimeError, (void)factory.createTree("Nobody"));
  factory.registerBehaviorTreeFromText(
      R"(<root><BehaviorTree ID="Loop"><SubTree ID="Loop"/></BehaviorTree></root>)");
  CHECK_THROWS(BT::RuntimeError, (void)factory.createTree("Loop"));
}

}  // namespace

int main(int argc, char* argv[]) {
  rclcpp::init(argc, argv);
  Checks checks("trees");
  auto factory = make_factory();
  check_ports(checks, factory);
  check_controls(checks, factory);
  check_reactive(checks, factory);
  check_texts(checks, factory);
  check_decorators(checks, factory);
  check_subtrees(checks, factory);
  return checks.finish();
}
