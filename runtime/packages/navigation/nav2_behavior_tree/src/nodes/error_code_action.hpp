// An action whose error code goes to the port `error_code_id`.
#pragma once

#include "nav2_behavior_tree/bt_action_node.hpp"

namespace nav2_behavior_tree {

template <typename ActionT>
class ErrorCodeAction : public BtActionNode<ActionT> {
 public:
  using BtActionNode<ActionT>::BtActionNode;

  static BT::PortsList ports_and_code(BT::PortsList ports) {
    ports.insert(BT::OutputPort<uint16_t>("error_code_id", "Error code of the action, 0 for none"));
    return BtActionNode<ActionT>::providedBasicPorts(ports);
  }

  BT::NodeStatus on_success() override {
    write_code(ActionT::Result::NONE);
    return BT::NodeStatus::SUCCESS;
  }
  BT::NodeStatus on_aborted() override {
    write_code(this->result_.result->error_code);
    return BT::NodeStatus::FAILURE;
  }
  BT::NodeStatus on_cancelled() override {
    write_code(ActionT::Result::NONE);
    return BT::NodeStatus::SUCCESS;
  }

 private:
  void write_code(uint16_t code) { this->setOutput("error_code_id", code); }
};

}  // namespace nav2_behavior_tree
