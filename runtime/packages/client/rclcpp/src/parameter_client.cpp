// Parameter clients: one service client per question.
#include "rclcpp/parameter_client.hpp"

#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_parameter_types.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters_atomically.hpp"
#include "rclcpp/create_client.hpp"
#include "ros2wasm/endpoint.hpp"

namespace rclcpp {

using rcl_interfaces::srv::DescribeParameters;
using rcl_interfaces::srv::GetParameters;
using rcl_interfaces::srv::GetParameterTypes;
using rcl_interfaces::srv::ListParameters;
using rcl_interfaces::srv::SetParameters;
using rcl_interfaces::srv::SetParametersAtomically;

struct AsyncParametersClient::Clients {
  Client<GetParameters>::SharedPtr get;
  Client<GetParameterTypes>::SharedPtr types;
  Client<SetParameters>::SharedPtr set;
  Client<SetParametersAtomically>::SharedPtr set_atomically;
  Client<ListParameters>::SharedPtr list;
  Client<DescribeParameters>::SharedPtr describe;
};

namespace {

// Sends a request; the future gets what `convert` makes of the response, then the callback runs.
template <typename ResultT, typename ServiceT, typename ConvertT>
std::shared_future<ResultT> ask(const std::shared_ptr<Client<ServiceT>>& client,
                                typename ServiceT::Request::SharedPtr request,
                                std::function<void(std::shared_future<ResultT>)> callback,
                                ConvertT convert) {
  auto promise = std::make_shared<std::promise<ResultT>>();
  std::shared_future<ResultT> future(promise->get_future());
  client->async_send_request(
      std::move(request),
      [promise, future, callback = std::move(callback),
       convert = std::move(convert)](typename Client<ServiceT>::SharedFuture response) {
        promise->set_value(convert(*response.get()));
        if (callback) {
          callback(future);
        }
      });
  return future;
}

std::vector<rcl_interfaces::msg::Parameter> to_messages(
    const std::vector<rclcpp::Parameter>& parameters) {
  std::vector<rcl_interfaces::msg::Parameter> messages;
  for (const rclcpp::Parameter& parameter : parameters) {
    messages.push_back(parameter.to_parameter_msg());
  }
  return messages;
}

}  // namespace

AsyncParametersClient::AsyncParametersClient(
    const node_interfaces::NodeBaseInterface::SharedPtr node_base,
    const node_interfaces::NodeTopicsInterface::SharedPtr node_topics,
    const node_interfaces::NodeGraphInterface::SharedPtr node_graph,
    const node_interfaces::NodeServicesInterface::SharedPtr node_services,
    const std::string& remote_node_name, const rclcpp::QoS& qos,
    rclcpp::CallbackGroup::SharedPtr group)
    : node_topics_interface_(node_topics),
      clients_(std::make_shared<Clients>()),
      remote_node_name_(remote_node_name.empty() ? node_base->get_fully_qualified_name()
                                                 : remote_node_name) {
  const std::string prefix = remote_node_name_ + "/";
  const auto connect = [&](auto& client, const char* name) {
    using ServiceClient = typename std::decay_t<decltype(client)>::element_type;
    client = ServiceClient::make_shared(node_base.get(), prefix + name, qos);
    node_services->add_client(client, group);
  };
  static_cast<void>(node_graph);
  connect(clients_->get, "get_parameters");
  connect(clients_->types, "get_parameter_types");
  connect(clients_->set, "set_parameters");
  connect(clients_->set_atomically, "set_parameters_atomically");
  connect(clients_->list, "list_parameters");
  connect(clients_->describe, "describe_parameters");
}

std::shared_future<std::vector<rclcpp::Parameter>> AsyncParametersClient::get_parameters(
    const std::vector<std::string>& names,
    std::function<void(std::shared_future<std::vector<rclcpp::Parameter>>)> callback) {
  auto request = std::make_shared<GetParameters::Request>();
  request->names = names;
  return ask(clients_->get, request, std::move(callback),
             [names](const GetParameters::Response& response) {
               std::vector<rclcpp::Parameter> parameters;
               for (size_t i = 0; i < response.values.size() && i < names.size(); ++i) {
                 parameters.emplace_back(names[i], ParameterValue(response.values[i]));
               }
               return parameters;
             });
}

std::shared_future<std::vector<rcl_interfaces::msg::ParameterDescriptor>>
AsyncParametersClient::describe_parameters(
    const std::vector<std::string>& names,
    std::function<void(std::shared_future<std::vector<rcl_interfaces::msg::ParameterDescriptor>>)>
        callback) {
  auto request = std::make_shared<DescribeParameters::Request>();
  request->names = names;
  return ask(clients_->describe, request, std::move(callback),
             [](const DescribeParameters::Response& response) { return response.descriptors; });
}

std::shared_future<std::vector<rclcpp::ParameterType>> AsyncParametersClient::get_parameter_types(
    const std::vector<std::string>& names,
    std::function<void(std::shared_future<std::vector<rclcpp::ParameterType>>)> callback) {
  auto request = std::make_shared<GetParameterTypes::Request>();
  request->names = names;
  return ask(clients_->types, request, std::move(callback),
             [](const GetParameterTypes::Response& response) {
               std::vector<rclcpp::ParameterType> types;
               for (const uint8_t type : response.types) {
                 types.push_back(static_cast<rclcpp::ParameterType>(type));
               }
               return types;
             });
}

std::shared_future<std::vector<rcl_interfaces::msg::SetParametersResult>>
AsyncParametersClient::set_parameters(
    const std::vector<rclcpp::Parameter>& parameters,
    std::function<void(std::shared_future<std::vector<rcl_interfaces::msg::SetParametersResult>>)>
        callback) {
  auto request = std::make_shared<SetParameters::Request>();
  request->parameters = to_messages(parameters);
  return ask(clients_->set, request, std::move(callback),
             [](const SetParameters::Response& response) { return response.results; });
}

std::shared_future<rcl_interfaces::msg::SetParametersResult>
AsyncParametersClient::set_parameters_atomically(
    const std::vector<rclcpp::Parameter>& parameters,
    std::function<void(std::shared_future<rcl_interfaces::msg::SetParametersResult>)> callback) {
  auto request = std::make_shared<SetParametersAtomically::Request>();
  request->parameters = to_messages(parameters);
  return ask(clients_->set_atomically, request, std::move(callback),
             [](const SetParametersAtomically::Response& response) { return response.result; });
}

std::shared_future<rcl_interfaces::msg::ListParametersResult>
AsyncParametersClient::list_parameters(
    const std::vector<std::string>& prefixes, uint64_t depth,
    std::function<void(std::shared_future<rcl_interfaces::msg::ListParametersResult>)> callback) {
  auto request = std::make_shared<ListParameters::Request>();
  request->prefixes = prefixes;
  request->depth = depth;
  return ask(clients_->list, request, std::move(callback),
             [](const ListParameters::Response& response) { return response.result; });
}

std::shared_future<std::vector<rcl_interfaces::msg::SetParametersResult>>
AsyncParametersClient::delete_parameters(const std::vector<std::string>& names) {
  std::vector<rclcpp::Parameter> unset;
  for (const std::string& name : names) {
    unset.emplace_back(name);
  }
  return set_parameters(unset);
}

std::shared_future<std::vector<rcl_interfaces::msg::SetParametersResult>>
AsyncParametersClient::load_parameters(const std::string& yaml_filename) {
  return load_parameters(
      rclcpp::parameter_map_from_yaml_file(yaml_filename, remote_node_name_.c_str()));
}

std::shared_future<std::vector<rcl_interfaces::msg::SetParametersResult>>
AsyncParametersClient::load_parameters(const rclcpp::ParameterMap& parameter_map) {
  return set_parameters(rclcpp::parameters_from_map(parameter_map, remote_node_name_.c_str()));
}

bool AsyncParametersClient::service_is_ready() const {
  return clients_->get->service_is_ready() && clients_->types->service_is_ready() &&
         clients_->set->service_is_ready() && clients_->set_atomically->service_is_ready() &&
         clients_->list->service_is_ready() && clients_->describe->service_is_ready();
}

bool AsyncParametersClient::wait_for_service_nanoseconds(std::chrono::nanoseconds timeout) {
  const bool limited = timeout.count() >= 0;
  const int64_t until = ros2wasm::steady_now_ns() + timeout.count();
  const auto wait = [&](auto& client) {
    const int64_t left = limited ? std::max<int64_t>(until - ros2wasm::steady_now_ns(), 0) : -1;
    return client->wait_for_service(std::chrono::nanoseconds(left));
  };
  return wait(clients_->get) && wait(clients_->types) && wait(clients_->set) &&
         wait(clients_->set_atomically) && wait(clients_->list) && wait(clients_->describe);
}

bool SyncParametersClient::has_parameter(const std::string& parameter_name) {
  const auto listed = list_parameters({parameter_name}, 1);
  return !listed.names.empty();
}

}  // namespace rclcpp
