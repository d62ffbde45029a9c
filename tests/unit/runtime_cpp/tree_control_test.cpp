// The control nodes of Nav2's trees: which child they tick, when they try again, and what they
// answer.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "behaviortree_cpp/bt_factory.h"

namespace {

using BT::NodeStatus;
using Answers = std::vector<NodeStatus>;
using Answer = std::pair<NodeStatus, std::string>;
constexpr NodeStatus kYes = NodeStatus::SUCCESS;
constexpr NodeStatus kNo = NodeStatus::FAILURE;
constexpr NodeStatus kRuns = NodeStatus::RUNNING;
constexpr NodeStatus kSkipped = NodeStatus::SKIPPED;

/// Answers of the leaves of a tree, and the leaves that were ticked or halted.
struct Script {
  std::map<std::string, Answers> answers;  ///< the last one lasts
  std::string log;
};

class Leaf : public BT::ActionNodeBase {
 public:
  Leaf(const std::string& name, const BT::NodeConfig& config, Script* script)
      : BT::ActionNodeBase(name, config), script_(*script) {}
  static BT::PortsList providedPorts() { return {}; }

  void halt() override {
    script_.log += "-" + name();
    resetStatus();
  }

 private:
  NodeStatus tick() override {
    script_.log += name();
    Answers& answers = script_.answers.at(name());
    const NodeStatus answer = answers.front();
    if (answers.size() > 1) answers.erase(answers.begin());
    return answer;
  }

  Script& script_;
};

class TreeControl : public testing::Test {
 protected:
  TreeControl() {
    for (const char* library : {"recovery_node", "round_robin_node", "pipeline_sequence"}) {
      factory_.registerFromPlugin("libnav2_" + std::string(library) + "_bt_node.so");
    }
    for (const char* name : {"A", "B", "C"}) factory_.registerNodeType<Leaf>(name, &script_);
  }

  void make(const std::string& body, std::map<std::string, Answers> answers) {
    script_.answers = std::move(answers);
    tree_ = factory_.createTreeFromText(
        "<root BTCPP_format=\"4\" main_tree_to_execute=\"T\"><BehaviorTree ID=\"T\">" + body +
        "</BehaviorTree></root>");
  }

  /// The answer of the tree, and the leaves that were ticked, or halted (-), for it.
  Answer tick() {
    script_.log.clear();
    const NodeStatus answer = tree_.tickOnce();
    return {answer, script_.log};
  }

  BT::BehaviorTreeFactory factory_;
  Script script_;
  BT::Tree tree_;
};

TEST_F(TreeControl, RecoversAsOftenAsItMay) {
  const std::string body = R"(<RecoveryNode number_of_retries="2"><A/><B/></RecoveryNode>)";
  make(body, {{"A", {kNo, kNo, kYes}}, {"B", {kYes}}});
  EXPECT_EQ(tick(), Answer(kYes, "ABABA"));
  make(body, {{"A", {kNo}}, {"B", {kYes}}});
  EXPECT_EQ(tick(), Answer(kNo, "ABABA"));
  EXPECT_EQ(tick(), Answer(kNo, "ABABA")) << "it counts from the beginning";
  make(body, {{"A", {kNo}}, {"B", {kNo}}});
  EXPECT_EQ(tick(), Answer(kNo, "AB")) << "a recovery that fails ends it";
}

TEST_F(TreeControl, RecoversOverSeveralTicks) {
  make(R"(<RecoveryNode number_of_retries="1"><A/><B/></RecoveryNode>)",
       {{"A", {kRuns, kNo, kRuns, kYes}}, {"B", {kRuns, kYes}}});
  EXPECT_EQ(tick(), Answer(kRuns, "A"));
  EXPECT_EQ(tick(), Answer(kRuns, "AB"));
  EXPECT_EQ(tick(), Answer(kRuns, "BA"));
  EXPECT_EQ(tick(), Answer(kYes, "A"));
}

TEST_F(TreeControl, RecoversNothingThatIsSkipped) {
  const std::string body = "<RecoveryNode><A/><B/></RecoveryNode>";
  make(body, {{"A", {kSkipped}}, {"B", {kYes}}});
  EXPECT_EQ(tick(), Answer(kSkipped, "A"));
  make(body, {{"A", {kNo}}, {"B", {kSkipped}}});
  EXPECT_EQ(tick(), Answer(kNo, "AB"));
  make("<RecoveryNode><A/></RecoveryNode>", {{"A", {kYes}}});
  EXPECT_THROW(tick(), BT::BehaviorTreeException);
}

TEST_F(TreeControl, HaltsTheChildThatRuns) {
  make("<RecoveryNode><A/><B/></RecoveryNode>", {{"A", {kNo}}, {"B", {kRuns}}});
  EXPECT_EQ(tick(), Answer(kRuns, "AB"));
  script_.log.clear();
  tree_.haltTree();
  EXPECT_EQ(script_.log, "-B");
  EXPECT_EQ(tick(), Answer(kRuns, "AB"));
}

TEST_F(TreeControl, RefusesTreesWithoutEnd) {
  std::string doubling;
  for (int i = 0; i < 30; ++i) {
    const std::string used = "<SubTree ID=\"T" + std::to_string(i + 1) + "\"/>";
    doubling += "<BehaviorTree ID=\"T" + std::to_string(i) + "\"><Sequence>" + used + used +
                "</Sequence></BehaviorTree>";
  }
  const std::string text = "<root BTCPP_format=\"4\" main_tree_to_execute=\"T0\">" + doubling +
                           "<BehaviorTree ID=\"T30\"><A/></BehaviorTree></root>";
  EXPECT_THROW((void)factory_.createTreeFromText(text), BT::RuntimeError);

  const std::string path = testing::TempDir() + "includes_itself.xml";
  std::ofstream(path)
      << "<root BTCPP_format=\"4\"><include path=\"./includes_itself.xml\"/></root>";
  EXPECT_THROW((void)factory_.createTreeFromFile(path), BT::RuntimeError);
  std::remove(path.c_str());
}

TEST_F(TreeControl, TakesTheNextChildEachTime) {
  const std::string body = "<RoundRobin><A/><B/><C/></RoundRobin>";
  make(body, {{"A", {kYes}}, {"B", {kYes}}, {"C", {kRuns, kYes}}});
  EXPECT_EQ(tick(), Answer(kYes, "A"));
  EXPECT_EQ(tick(), Answer(kYes, "B"));
  EXPECT_EQ(tick(), Answer(kRuns, "C"));
  EXPECT_EQ(tick(), Answer(kYes, "C"));
  EXPECT_EQ(tick(), Answer(kYes, "A"));
  make(body, {{"A", {kNo}}, {"B", {kNo, kYes, kNo}}, {"C", {kNo}}});
  EXPECT_EQ(tick(), Answer(kNo, "ABC")) << "all have failed";
  EXPECT_EQ(tick(), Answer(kYes, "AB")) << "from the first child again";
  EXPECT_EQ(tick(), Answer(kNo, "CAB")) << "on from the child after the last";
  make(body, {{"A", {kSkipped}}, {"B", {kSkipped}}, {"C", {kSkipped}}});
  EXPECT_EQ(tick(), Answer(kSkipped, "ABC"));
}

TEST_F(TreeControl, TicksAllChildrenUpToTheOneThatRuns) {
  const std::string body = "<PipelineSequence><A/><B/><C/></PipelineSequence>";
  make(body,
       {{"A", {kYes, kRuns, kYes}}, {"B", {kRuns, kRuns, kYes, kRuns}}, {"C", {kRuns, kYes}}});
  EXPECT_EQ(tick(), Answer(kRuns, "AB"));
  EXPECT_EQ(tick(), Answer(kRuns, "AB")) << "a child before may run, too";
  EXPECT_EQ(tick(), Answer(kRuns, "ABC"));
  EXPECT_EQ(tick(), Answer(kYes, "ABC-B")) << "one that runs still is halted at the end";
  make(body, {{"A", {kYes, kNo}}, {"B", {kRuns}}, {"C", {kYes}}});
  EXPECT_EQ(tick(), Answer(kRuns, "AB"));
  EXPECT_EQ(tick(), Answer(kNo, "A-B"));
  make(body, {{"A", {kSkipped}}, {"B", {kSkipped}}, {"C", {kSkipped}}});
  EXPECT_EQ(tick(), Answer(kSkipped, "ABC"));
}

}  // namespace
