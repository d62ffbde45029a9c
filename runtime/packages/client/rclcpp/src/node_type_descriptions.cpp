// Tells what the types are that a node uses.
#include "rclcpp/node_interfaces/node_type_descriptions.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <string>

#include "rclcpp/detail/type_use.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/service.hpp"
#include "type_description_interfaces/srv/get_type_description.hpp"

namespace rclcpp {
namespace node_interfaces {
namespace {

using ros2wasm_typesupport::FieldInfo;
using ros2wasm_typesupport::TypeInfo;
using type_description_interfaces::srv::GetTypeDescription;
using Individual = type_description_interfaces::msg::IndividualTypeDescription;
using Referenced = std::map<std::string, const TypeInfo*>;

bool is_type_hash(const std::string& text) {
  constexpr char kPrefix[] = "RIHS01_";
  constexpr size_t kPrefixSize = sizeof(kPrefix) - 1;
  constexpr size_t kDigits = 64;
  return text.size() == kPrefixSize + kDigits && text.compare(0, kPrefixSize, kPrefix) == 0 &&
         std::all_of(text.begin() + kPrefixSize, text.end(),
                     [](unsigned char digit) { return std::isxdigit(digit) != 0; });
}

void collect(const TypeInfo& type, Referenced& into) {
  for (size_t i = 0; i < type.field_count; ++i) {
    const TypeInfo* nested = type.fields[i].nested;
    if (nested != nullptr && into.emplace(nested->type_name, nested).second) {
      collect(*nested, into);
    }
  }
}

Individual describe(const TypeInfo& type) {
  Individual result;
  result.type_name = type.type_name;
  result.fields.resize(type.field_count);
  for (size_t i = 0; i < type.field_count; ++i) {
    const FieldInfo& from = type.fields[i];
    auto& to = result.fields[i];
    to.name = from.name;
    to.default_value = from.default_value;
    to.type.type_id = from.type_id;
    to.type.capacity = from.capacity;
    to.type.string_capacity = from.string_capacity;
    to.type.nested_type_name = from.nested == nullptr ? "" : from.nested->type_name;
  }
  return result;
}

type_description_interfaces::msg::TypeSource source_of(const TypeInfo& type) {
  type_description_interfaces::msg::TypeSource source;
  source.type_name = type.type_name;
  source.encoding = type.encoding;
  source.raw_file_contents = type.source;
  return source;
}

void answer(int32_t node_id, const GetTypeDescription::Request& request,
            GetTypeDescription::Response& response) {
  response.successful = false;
  if (!is_type_hash(request.type_hash)) {
    RCLCPP_ERROR(rclcpp::get_logger("rcl"), "Failed to parse type hash '%s'",
                 request.type_hash.c_str());
    response.failure_reason = "Failed to parse type hash";
    return;
  }
  const TypeInfo* type = detail::find_used_type(node_id, request.type_hash);
  if (type == nullptr) {
    response.failure_reason = "Type not currently in use by this node";
    return;
  }
  Referenced referenced;
  collect(*type, referenced);
  response.type_description.type_description = describe(*type);
  for (const auto& [name, one] : referenced) {
    response.type_description.referenced_type_descriptions.push_back(describe(*one));
  }
  if (request.include_type_sources) {
    response.type_sources.push_back(source_of(*type));
    for (const auto& [name, one] : referenced) {
      response.type_sources.push_back(source_of(*one));
    }
  }
  response.successful = true;
}

bool is_wanted(NodeLoggingInterface& node_logging, NodeParametersInterface& node_parameters) {
  constexpr char kName[] = "start_type_description_service";
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.name = kName;
  descriptor.type = rclcpp::PARAMETER_BOOL;
  descriptor.description = "Start the ~/get_type_description service for this node.";
  descriptor.read_only = true;
  try {
    return node_parameters.declare_parameter(kName, rclcpp::ParameterValue(true), descriptor, false)
        .get<bool>();
  } catch (const rclcpp::exceptions::InvalidParameterTypeException& error) {
    RCLCPP_ERROR(node_logging.get_logger(), "%s", error.what());
    throw;
  }
}

}  // namespace

NodeTypeDescriptions::NodeTypeDescriptions(NodeBaseInterface::SharedPtr node_base,
                                           NodeLoggingInterface::SharedPtr node_logging,
                                           NodeParametersInterface::SharedPtr node_parameters,
                                           NodeServicesInterface::SharedPtr node_services) {
  if (!is_wanted(*node_logging, *node_parameters)) {
    return;
  }
  AnyServiceCallback<GetTypeDescription> callback;
  callback.set([node_id = node_base->get_node_id()](
                   const std::shared_ptr<GetTypeDescription::Request> request,
                   std::shared_ptr<GetTypeDescription::Response> response) {
    answer(node_id, *request, *response);
  });
  service_ = std::make_shared<rclcpp::Service<GetTypeDescription>>(
      node_base.get(), "~/get_type_description", std::move(callback), rclcpp::ServicesQoS());
  node_services->add_service(service_, nullptr);
}

NodeTypeDescriptions::~NodeTypeDescriptions() = default;

}  // namespace node_interfaces
}  // namespace rclcpp
