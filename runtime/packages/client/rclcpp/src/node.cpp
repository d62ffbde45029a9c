// Node: puts its parts together.
#include "rclcpp/node.hpp"

#include <stdexcept>

#include "rclcpp/detail/qos_parameters.hpp"
#include "rclcpp/node_interfaces/node_base.hpp"
#include "rclcpp/node_interfaces/node_clock.hpp"
#include "rclcpp/node_interfaces/node_graph.hpp"
#include "rclcpp/node_interfaces/node_logging.hpp"
#include "rclcpp/node_interfaces/node_parameters.hpp"
#include "rclcpp/node_interfaces/node_services.hpp"
#include "rclcpp/node_interfaces/node_time_source.hpp"
#include "rclcpp/node_interfaces/node_timers.hpp"
#include "rclcpp/node_interfaces/node_topics.hpp"
#include "rclcpp/node_interfaces/node_type_descriptions.hpp"
#include "rclcpp/node_interfaces/node_waitables.hpp"

namespace rclcpp {
namespace {

node_interfaces::NodeBaseOptions base_options(const NodeOptions& options) {
  node_interfaces::NodeBaseOptions result;
  result.arguments = options.arguments();
  result.use_global_arguments = options.use_global_arguments();
  result.use_intra_process_default = options.use_intra_process_comms();
  result.enable_topic_statistics_default = options.enable_topic_statistics();
  return result;
}

node_interfaces::NodeParametersOptions parameters_options(const NodeOptions& options) {
  node_interfaces::NodeParametersOptions result;
  result.parameter_overrides = options.parameter_overrides();
  result.start_parameter_services = options.start_parameter_services();
  result.start_parameter_event_publisher = options.start_parameter_event_publisher();
  result.parameter_event_qos = options.parameter_event_qos();
  result.parameter_event_publisher_options = options.parameter_event_publisher_options();
  result.allow_undeclared_parameters = options.allow_undeclared_parameters();
  result.automatically_declare_parameters_from_overrides =
      options.automatically_declare_parameters_from_overrides();
  return result;
}

std::string join_sub_namespace(const std::string& existing, const std::string& extension) {
  if (extension.empty()) {
    throw exceptions::NameValidationError("sub_namespace", extension.c_str(),
                                          "sub-nodes should not extend nodes by an empty "
                                          "sub-namespace",
                                          0);
  }
  if (extension.front() == '/') {
    throw exceptions::NameValidationError("sub_namespace", extension.c_str(),
                                          "a sub-namespace should not have a leading /", 0);
  }
  std::string joined = existing.empty() ? extension : existing + "/" + extension;
  if (joined.back() == '/') {
    joined.pop_back();
  }
  return joined;
}

std::string effective_namespace(const std::string& ns, const std::string& sub_namespace) {
  if (sub_namespace.empty()) {
    return ns;
  }
  return ns == "/" ? ns + sub_namespace : ns + "/" + sub_namespace;
}

}  // namespace

node_interfaces::NodeTimeSource::NodeTimeSource(
    std::shared_ptr<NodeBaseInterface> node_base, std::shared_ptr<NodeTopicsInterface> node_topics,
    std::shared_ptr<NodeGraphInterface> node_graph,
    std::shared_ptr<NodeServicesInterface> node_services,
    std::shared_ptr<NodeLoggingInterface> node_logging,
    std::shared_ptr<NodeClockInterface> node_clock,
    std::shared_ptr<NodeParametersInterface> node_parameters, const rclcpp::QoS& qos,
    bool use_clock_thread)
    : time_source_(qos, use_clock_thread) {
  time_source_.attachNode(node_base, node_topics, node_graph, node_services, node_logging,
                          node_clock, node_parameters);
  if (node_clock->get_clock()->get_clock_type() == RCL_ROS_TIME) {
    time_source_.attachClock(node_clock->get_clock());
  }
}

namespace detail {

std::string extend_name_with_sub_namespace(const std::string& name,
                                           const std::string& sub_namespace) {
  const bool extends =
      !sub_namespace.empty() && !name.empty() && name.front() != '/' && name.front() != '~';
  return extends ? sub_namespace + "/" + name : name;
}

CommonNode::CommonNode(const std::string& node_name, const std::string& ns,
                       const NodeOptions& options)
    : node_base_(std::make_shared<node_interfaces::NodeBase>(node_name, ns, options.context(),
                                                             base_options(options))),
      node_graph_(std::make_shared<node_interfaces::NodeGraph>(node_base_.get())),
      node_logging_(std::make_shared<node_interfaces::NodeLogging>(
          node_base_.get(), options.enable_rosout(), options.rosout_qos())),
      node_timers_(std::make_shared<node_interfaces::NodeTimers>(node_base_.get())),
      node_topics_(
          std::make_shared<node_interfaces::NodeTopics>(node_base_.get(), node_timers_.get())),
      node_services_(std::make_shared<node_interfaces::NodeServices>(node_base_.get())),
      node_clock_(std::make_shared<node_interfaces::NodeClock>(options.clock_type())),
      node_parameters_(std::make_shared<node_interfaces::NodeParameters>(
          node_base_, node_logging_, node_topics_, node_services_, node_clock_,
          parameters_options(options))),
      node_time_source_(std::make_shared<node_interfaces::NodeTimeSource>(
          node_base_, node_topics_, node_graph_, node_services_, node_logging_, node_clock_,
          node_parameters_, options.clock_qos(), options.use_clock_thread())),
      node_type_descriptions_(std::make_shared<node_interfaces::NodeTypeDescriptions>(
          node_base_, node_logging_, node_parameters_, node_services_)),
      node_waitables_(std::make_shared<node_interfaces::NodeWaitables>(node_base_.get())),
      node_options_(options) {
  if (options.enable_logger_service()) {
    node_logging_->create_logger_services(node_base_.get(), node_services_.get());
  }
}

CommonNode::CommonNode(const CommonNode& other, std::string sub_namespace)
    : sub_namespace_(std::move(sub_namespace)),
      node_base_(other.node_base_),
      node_graph_(other.node_graph_),
      node_logging_(other.node_logging_),
      node_timers_(other.node_timers_),
      node_topics_(other.node_topics_),
      node_services_(other.node_services_),
      node_clock_(other.node_clock_),
      node_parameters_(other.node_parameters_),
      node_time_source_(other.node_time_source_),
      node_type_descriptions_(other.node_type_descriptions_),
      node_waitables_(other.node_waitables_),
      node_options_(other.node_options_) {}

// The parts go in an order in which none refers to one that is gone.
CommonNode::~CommonNode() {
  node_waitables_.reset();
  node_type_descriptions_.reset();
  node_time_source_.reset();
  node_parameters_.reset();
  node_clock_.reset();
  node_services_.reset();
  node_topics_.reset();
  node_timers_.reset();
  node_logging_.reset();
  node_graph_.reset();
}

const char* CommonNode::get_name() const {
  return node_base_->get_name();
}
const char* CommonNode::get_namespace() const {
  return node_base_->get_namespace();
}
const char* CommonNode::get_fully_qualified_name() const {
  return node_base_->get_fully_qualified_name();
}
rclcpp::Logger CommonNode::get_logger() const {
  return node_logging_->get_logger();
}

rclcpp::CallbackGroup::SharedPtr CommonNode::create_callback_group(
    rclcpp::CallbackGroupType group_type, bool automatically_add_to_executor_with_node) {
  return node_base_->create_callback_group(group_type, automatically_add_to_executor_with_node);
}
void CommonNode::for_each_callback_group(
    const node_interfaces::NodeBaseInterface::CallbackGroupFunction& func) {
  node_base_->for_each_callback_group(func);
}

const rclcpp::ParameterValue& CommonNode::declare_parameter(
    const std::string& name, const rclcpp::ParameterValue& default_value,
    const rcl_interfaces::msg::ParameterDescriptor& parameter_descriptor, bool ignore_override) {
  return node_parameters_->declare_parameter(
      detail::extend_name_with_sub_namespace(name, sub_namespace_), default_value,
      parameter_descriptor, ignore_override);
}
const rclcpp::ParameterValue& CommonNode::declare_parameter(
    const std::string& name, rclcpp::ParameterType type,
    const rcl_interfaces::msg::ParameterDescriptor& parameter_descriptor, bool ignore_override) {
  return node_parameters_->declare_parameter(
      detail::extend_name_with_sub_namespace(name, sub_namespace_), type, parameter_descriptor,
      ignore_override);
}
void CommonNode::undeclare_parameter(const std::string& name) {
  node_parameters_->undeclare_parameter(name);
}
bool CommonNode::has_parameter(const std::string& name) const {
  return node_parameters_->has_parameter(name);
}
rcl_interfaces::msg::SetParametersResult CommonNode::set_parameter(
    const rclcpp::Parameter& parameter) {
  return set_parameters_atomically({parameter});
}
std::vector<rcl_interfaces::msg::SetParametersResult> CommonNode::set_parameters(
    const std::vector<rclcpp::Parameter>& parameters) {
  return node_parameters_->set_parameters(parameters);
}
rcl_interfaces::msg::SetParametersResult CommonNode::set_parameters_atomically(
    const std::vector<rclcpp::Parameter>& parameters) {
  return node_parameters_->set_parameters_atomically(parameters);
}
rclcpp::Parameter CommonNode::get_parameter(const std::string& name) const {
  return node_parameters_->get_parameter(name);
}
bool CommonNode::get_parameter(const std::string& name, rclcpp::Parameter& parameter) const {
  return node_parameters_->get_parameter(name, parameter);
}
std::vector<rclcpp::Parameter> CommonNode::get_parameters(
    const std::vector<std::string>& names) const {
  return node_parameters_->get_parameters(names);
}
rcl_interfaces::msg::ParameterDescriptor CommonNode::describe_parameter(
    const std::string& name) const {
  return node_parameters_->describe_parameters({name}).at(0);
}
std::vector<rcl_interfaces::msg::ParameterDescriptor> CommonNode::describe_parameters(
    const std::vector<std::string>& names) const {
  return node_parameters_->describe_parameters(names);
}
std::vector<uint8_t> CommonNode::get_parameter_types(const std::vector<std::string>& names) const {
  return node_parameters_->get_parameter_types(names);
}
rcl_interfaces::msg::ListParametersResult CommonNode::list_parameters(
    const std::vector<std::string>& prefixes, uint64_t depth) const {
  return node_parameters_->list_parameters(prefixes, depth);
}
CommonNode::PreSetParametersCallbackHandle::SharedPtr CommonNode::add_pre_set_parameters_callback(
    PreSetParametersCallbackType callback) {
  return node_parameters_->add_pre_set_parameters_callback(std::move(callback));
}
CommonNode::OnSetParametersCallbackHandle::SharedPtr CommonNode::add_on_set_parameters_callback(
    OnSetParametersCallbackType callback) {
  return node_parameters_->add_on_set_parameters_callback(std::move(callback));
}
CommonNode::PostSetParametersCallbackHandle::SharedPtr CommonNode::add_post_set_parameters_callback(
    PostSetParametersCallbackType callback) {
  return node_parameters_->add_post_set_parameters_callback(std::move(callback));
}
void CommonNode::remove_pre_set_parameters_callback(
    const PreSetParametersCallbackHandle* const handler) {
  node_parameters_->remove_pre_set_parameters_callback(handler);
}
void CommonNode::remove_on_set_parameters_callback(
    const OnSetParametersCallbackHandle* const handler) {
  node_parameters_->remove_on_set_parameters_callback(handler);
}
void CommonNode::remove_post_set_parameters_callback(
    const PostSetParametersCallbackHandle* const handler) {
  node_parameters_->remove_post_set_parameters_callback(handler);
}

std::vector<std::string> CommonNode::get_node_names() const {
  return node_graph_->get_node_names();
}
std::map<std::string, std::vector<std::string>> CommonNode::get_topic_names_and_types(
    bool no_demangle) const {
  return node_graph_->get_topic_names_and_types(no_demangle);
}
std::map<std::string, std::vector<std::string>> CommonNode::get_service_names_and_types() const {
  return node_graph_->get_service_names_and_types();
}
std::map<std::string, std::vector<std::string>> CommonNode::get_service_names_and_types_by_node(
    const std::string& node_name, const std::string& ns) const {
  return node_graph_->get_service_names_and_types_by_node(node_name, ns);
}
size_t CommonNode::count_publishers(const std::string& topic_name) const {
  return node_graph_->count_publishers(topic_name);
}
size_t CommonNode::count_subscribers(const std::string& topic_name) const {
  return node_graph_->count_subscribers(topic_name);
}
size_t CommonNode::count_clients(const std::string& service_name) const {
  return node_graph_->count_clients(service_name);
}
size_t CommonNode::count_services(const std::string& service_name) const {
  return node_graph_->count_services(service_name);
}
std::vector<TopicEndpointInfo> CommonNode::get_publishers_info_by_topic(
    const std::string& topic_name, bool no_mangle) const {
  return node_graph_->get_publishers_info_by_topic(topic_name, no_mangle);
}
std::vector<TopicEndpointInfo> CommonNode::get_subscriptions_info_by_topic(
    const std::string& topic_name, bool no_mangle) const {
  return node_graph_->get_subscriptions_info_by_topic(topic_name, no_mangle);
}
rclcpp::Event::SharedPtr CommonNode::get_graph_event() {
  return node_graph_->get_graph_event();
}
void CommonNode::wait_for_graph_change(rclcpp::Event::SharedPtr event,
                                       std::chrono::nanoseconds timeout) {
  node_graph_->wait_for_graph_change(std::move(event), timeout);
}

rclcpp::Clock::SharedPtr CommonNode::get_clock() {
  return node_clock_->get_clock();
}
rclcpp::Clock::ConstSharedPtr CommonNode::get_clock() const {
  return node_clock_->get_clock();
}
rclcpp::Time CommonNode::now() const {
  return node_clock_->get_clock()->now();
}

node_interfaces::NodeBaseInterface::SharedPtr CommonNode::get_node_base_interface() {
  return node_base_;
}
node_interfaces::NodeClockInterface::SharedPtr CommonNode::get_node_clock_interface() {
  return node_clock_;
}
node_interfaces::NodeGraphInterface::SharedPtr CommonNode::get_node_graph_interface() {
  return node_graph_;
}
node_interfaces::NodeLoggingInterface::SharedPtr CommonNode::get_node_logging_interface() {
  return node_logging_;
}
node_interfaces::NodeTimersInterface::SharedPtr CommonNode::get_node_timers_interface() {
  return node_timers_;
}
node_interfaces::NodeTopicsInterface::SharedPtr CommonNode::get_node_topics_interface() {
  return node_topics_;
}
node_interfaces::NodeServicesInterface::SharedPtr CommonNode::get_node_services_interface() {
  return node_services_;
}
node_interfaces::NodeWaitablesInterface::SharedPtr CommonNode::get_node_waitables_interface() {
  return node_waitables_;
}
node_interfaces::NodeParametersInterface::SharedPtr CommonNode::get_node_parameters_interface() {
  return node_parameters_;
}
node_interfaces::NodeTimeSourceInterface::SharedPtr CommonNode::get_node_time_source_interface() {
  return node_time_source_;
}
node_interfaces::NodeTypeDescriptionsInterface::SharedPtr
CommonNode::get_node_type_descriptions_interface() {
  return node_type_descriptions_;
}

const rclcpp::NodeOptions& CommonNode::get_node_options() const {
  return node_options_;
}

}  // namespace detail

Node::Node(const std::string& node_name, const NodeOptions& options)
    : Node(node_name, "", options) {}

Node::Node(const std::string& node_name, const std::string& ns, const NodeOptions& options)
    : CommonNode(node_name, ns, options), effective_namespace_(get_namespace()) {
  // So that they can be seen; a publisher's QoS does not change any more.
  detail::declare_qos_parameters(
      {QosPolicyKind::Depth, QosPolicyKind::Durability, QosPolicyKind::History,
       QosPolicyKind::Reliability},
      *get_node_parameters_interface(),
      get_node_topics_interface()->resolve_topic_name("/parameter_events"),
      options.parameter_event_qos(), detail::QosEntity::publisher);
}

Node::Node(const Node& other, const std::string& sub_namespace)
    : std::enable_shared_from_this<Node>(),
      CommonNode(other, join_sub_namespace(other.sub_namespace_, sub_namespace)),
      effective_namespace_(effective_namespace(other.get_namespace(), sub_namespace_)) {}

Node::~Node() = default;

const std::string& Node::get_sub_namespace() const {
  return sub_namespace_;
}
const std::string& Node::get_effective_namespace() const {
  return effective_namespace_;
}

rclcpp::Node::SharedPtr Node::create_sub_node(const std::string& sub_namespace) {
  return std::shared_ptr<rclcpp::Node>(new rclcpp::Node(*this, sub_namespace));
}

}  // namespace rclcpp
