// Clients of services that are known by name, and the list of the types that can be.
#include "rclcpp/generic_client.hpp"

#include "rclcpp/create_generic_client.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp {
namespace detail {
namespace {

struct KnownServices {
  std::mutex mutex;
  KnownService* first = nullptr;
};

KnownServices& known_services() {
  static KnownServices services;
  return services;
}

const KnownService& require_service(const std::string& type_name,
                                    node_interfaces::NodeBaseInterface& node) {
  const KnownService* service = find_known_service(type_name);
  if (service != nullptr) {
    return *service;
  }
  const std::string reason = "the program has no code for the service type '" + type_name +
                             "'; make a client or a service of the type first";
  RCLCPP_ERROR(rclcpp::get_logger(node.get_logger_name()).get_child("rclcpp"),
               "Invalid service type: %s", reason.c_str());
  throw exceptions::InvalidServiceTypeError(reason);
}

}  // namespace

void enter_known_service(KnownService& service) {
  const std::lock_guard<std::mutex> lock(known_services().mutex);
  if (!service.entered) {
    service.entered = true;
    service.next = known_services().first;
    known_services().first = &service;
  }
}

const KnownService* find_known_service(const std::string& type_name) {
  const std::lock_guard<std::mutex> lock(known_services().mutex);
  const KnownService* service = known_services().first;
  while (service != nullptr && type_name != callbacks_of(*service->type_support).type_name) {
    service = service->next;
  }
  return service;
}

}  // namespace detail

GenericClient::GenericClient(node_interfaces::NodeBaseInterface* node_base,
                             std::shared_ptr<node_interfaces::NodeGraphInterface>,
                             const std::string& service_name, const std::string& service_type,
                             const rcl_client_options_t& client_options)
    : GenericClient(
          node_base, service_name, detail::require_service(service_type, *node_base),
          rclcpp::QoS(QoSInitialization::from_rmw(client_options.qos), client_options.qos)) {}

GenericClient::GenericClient(node_interfaces::NodeBaseInterface* node_base,
                             const std::string& service_name, const detail::KnownService& service,
                             const rclcpp::QoS& qos)
    : ClientBase(node_base, service_name, *service.type_support, qos), service_(service) {}

void GenericClient::handle_response(std::shared_ptr<rmw_request_id_t> request_header,
                                    std::shared_ptr<void> response) {
  std::function<void(SharedResponse)> finish;
  {
    const std::lock_guard<std::mutex> lock(pending_mutex_);
    const auto found = pending_.find(request_header->sequence_number);
    if (found == pending_.end()) {
      return;
    }
    finish = std::move(found->second.finish);
    pending_.erase(found);
  }
  finish(std::move(response));
}

GenericClient::FutureAndRequestId GenericClient::async_send_request(const Request request) {
  auto promise = std::make_shared<Promise>();
  auto future = promise->get_future();
  const int64_t id = send(
      request, [promise](SharedResponse response) { promise->set_value(std::move(response)); });
  return {std::move(future), id};
}

int64_t GenericClient::send(const void* request, std::function<void(SharedResponse)> finish) {
  // Under the lock: the answer may come before the number is noted.
  const std::lock_guard<std::mutex> lock(pending_mutex_);
  const int64_t id = send_request_object(request);
  pending_[id] = Pending{std::chrono::system_clock::now(), std::move(finish)};
  return id;
}

bool GenericClient::remove_pending_request(int64_t request_id) {
  const std::lock_guard<std::mutex> lock(pending_mutex_);
  return pending_.erase(request_id) != 0;
}

size_t GenericClient::prune_pending_requests() {
  const std::lock_guard<std::mutex> lock(pending_mutex_);
  const size_t count = pending_.size();
  pending_.clear();
  return count;
}

GenericClient::SharedPtr create_generic_client(
    std::shared_ptr<node_interfaces::NodeBaseInterface> node_base,
    std::shared_ptr<node_interfaces::NodeGraphInterface> node_graph,
    std::shared_ptr<node_interfaces::NodeServicesInterface> node_services,
    const std::string& service_name, const std::string& service_type, const rclcpp::QoS& qos,
    rclcpp::CallbackGroup::SharedPtr group) {
  rcl_client_options_t options = rcl_client_get_default_options();
  options.qos = qos.get_rmw_qos_profile();
  auto client = GenericClient::make_shared(node_base.get(), std::move(node_graph), service_name,
                                           service_type, options);
  node_services->add_client(client, std::move(group));
  return client;
}

GenericClient::SharedPtr detail::CommonNode::create_generic_client(
    const std::string& service_name, const std::string& service_type, const rclcpp::QoS& qos,
    rclcpp::CallbackGroup::SharedPtr group) {
  return rclcpp::create_generic_client(node_base_, node_graph_, node_services_,
                                       extend_name_with_sub_namespace(service_name, sub_namespace_),
                                       service_type, qos, std::move(group));
}

}  // namespace rclcpp
