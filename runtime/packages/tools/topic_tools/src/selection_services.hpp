// The services of mux and demux: ~/add, ~/delete, ~/list and ~/select, with upstream's texts.
#pragma once

#include <functional>
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <string>

#include "topic_selection.hpp"

namespace topic_tools {

/// Types is a struct with the service types Add, Delete, List and Select.
template <typename Types>
class SelectionServices {
 public:
  /// `name` is mux or demux; `on_select` is called after the selection has changed. The node and
  /// the selection outlive this.
  SelectionServices(rclcpp::Node& node, std::string name, TopicSelection& selection,
                    std::function<void()> on_select)
      : logger_(node.get_logger()),
        name_(std::move(name)),
        selection_(selection),
        on_select_(std::move(on_select)) {
    add_ = serve<typename Types::Add>(node, "~/add", &SelectionServices::add);
    delete_ = serve<typename Types::Delete>(node, "~/delete", &SelectionServices::erase);
    list_ = serve<typename Types::List>(node, "~/list", &SelectionServices::list);
    select_ = serve<typename Types::Select>(node, "~/select", &SelectionServices::select);
  }

 private:
  template <typename ServiceT>
  using Method = void (SelectionServices::*)(const typename ServiceT::Request&,
                                             typename ServiceT::Response&);

  template <typename ServiceT>
  std::shared_ptr<rclcpp::Service<ServiceT>> serve(rclcpp::Node& node, const char* name,
                                                   Method<ServiceT> method) {
    return node.create_service<ServiceT>(
        name, [this, method](const std::shared_ptr<typename ServiceT::Request> request,
                             std::shared_ptr<typename ServiceT::Response> response) {
          (this->*method)(*request, *response);
        });
  }

  void add(const typename Types::Add::Request& request, typename Types::Add::Response& response) {
    const char* topic = request.topic.c_str();
    const char* name = name_.c_str();
    RCLCPP_INFO(logger_, "trying to add %s to %s", topic, name);
    const auto added = selection_.add(request.topic);
    response.success = added == TopicSelection::Added::kYes;
    switch (added) {
      case TopicSelection::Added::kReserved:
        RCLCPP_WARN(logger_, "failed to add topic %s to %s, because it's reserved for special use",
                    topic, name);
        return;
      case TopicSelection::Added::kKnown:
        RCLCPP_WARN(logger_, "tried to add a topic that %s was already listening to: [%s]", name,
                    topic);
        return;
      case TopicSelection::Added::kYes:
        RCLCPP_INFO(logger_, "added %s to %s", topic, name);
        return;
    }
  }

  void erase(const typename Types::Delete::Request& request,
             typename Types::Delete::Response& response) {
    const char* topic = request.topic.c_str();
    const char* name = name_.c_str();
    RCLCPP_INFO(logger_, "trying to delete %s to %s", topic, name);
    const auto deleted = selection_.erase(request.topic);
    response.success = deleted == TopicSelection::Deleted::kYes;
    switch (deleted) {
      case TopicSelection::Deleted::kSelected:
        RCLCPP_WARN(logger_, "tried to delete currently selected topic %s from %s", topic, name);
        return;
      case TopicSelection::Deleted::kUnknown:
        RCLCPP_WARN(logger_, "tried to delete non-subscribed topic %s from %s", topic, name);
        return;
      case TopicSelection::Deleted::kYes:
        RCLCPP_INFO(logger_, "deleted topic %s from %s", topic, name);
        return;
    }
  }

  void list(const typename Types::List::Request&, typename Types::List::Response& response) {
    response.topics = selection_.topics();
  }

  void select(const typename Types::Select::Request& request,
              typename Types::Select::Response& response) {
    const char* name = name_.c_str();
    const bool is_none = request.topic == kNoTopic;
    response.prev_topic = selection_.selected_of_topics();
    if (is_none) {
      RCLCPP_INFO(logger_, "%s selected to no input.", name);
    } else {
      RCLCPP_INFO(logger_, "trying to switch %s to %s", name, request.topic.c_str());
    }
    response.success = selection_.select(request.topic);
    if (!response.success) return;
    on_select_();
    if (!is_none) RCLCPP_INFO(logger_, "%s selected input: [%s]", name, request.topic.c_str());
  }

  rclcpp::Logger logger_;
  std::string name_;
  TopicSelection& selection_;
  std::function<void()> on_select_;
  std::shared_ptr<rclcpp::Service<typename Types::Add>> add_;
  std::shared_ptr<rclcpp::Service<typename Types::Delete>> delete_;
  std::shared_ptr<rclcpp::Service<typename Types::List>> list_;
  std::shared_ptr<rclcpp::Service<typename Types::Select>> select_;
};

}  // namespace topic_tools
