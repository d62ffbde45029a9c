// Reads the tags `<ros2_control>`.
#include "control_tags.hpp"

#include <stdexcept>

#include "hardware_interface/helpers.hpp"
#include "hardware_interface/lexical_casts.hpp"
#include "ros2wasm_xml/xml_document.hpp"

namespace hardware_interface {
namespace {

using ros2wasm_xml::XmlDocument;
using ros2wasm_xml::XmlElement;
using Parameters = std::unordered_map<std::string, std::string>;

std::runtime_error problem(const std::string& text) {
  return std::runtime_error(text);
}

std::string attribute(const XmlElement& element, const char* name) {
  const std::string* const value = element.attribute(name);
  if (value == nullptr) {
    const std::string* const label = element.attribute("name");
    throw problem(std::string("no attribute '") + name + "' in '" + element.name + "' tag" +
                  (label != nullptr && !label->empty() ? " with name '" + *label + "'" : ""));
  }
  return ros2_control::strip(*value);
}

std::string attribute_or(const XmlElement& element, const char* name, const char* otherwise) {
  const std::string* const value = element.attribute(name);
  return value == nullptr ? otherwise : ros2_control::strip(*value);
}

/// A whole number above zero, without a sign.
int positive_number(const XmlElement& element, const char* name, int otherwise) {
  if (element.attribute(name) == nullptr) {
    return otherwise;
  }
  const std::string text = attribute(element, name);
  const bool is_number = !text.empty() && text.size() < 10 && text[0] != '0' &&
                         text.find_first_not_of("0123456789") == std::string::npos;
  if (!is_number) {
    throw problem(std::string("Could not parse ") + name + " tag in \"" + element.name +
                  "\". Got \"" + text + "\", but expected a non-zero positive integer.");
  }
  return std::stoi(text);
}

unsigned int rate_of(const XmlElement& element) {
  const std::string text = attribute_or(element, "rw_rate", "0");
  const auto refuse = [&element, &text](const std::string& why) {
    return problem("Could not parse rw_rate tag in \"" + element.name + "\". " + why + " \"" +
                   text + "\", expected a positive integer.");
  };
  try {
    const int rate = std::stoi(text);
    if (rate < 0) {
      throw problem("Could not parse rw_rate tag in \"" + element.name + "\". Got \"" + text +
                    "\", but expected a positive integer.");
    }
    return static_cast<unsigned int>(rate);
  } catch (const std::invalid_argument&) {
    throw refuse("Invalid value:");
  } catch (const std::out_of_range&) {
    throw refuse("Out of range value:");
  }
}

class ControlTag {
 public:
  explicit ControlTag(const XmlDocument& document) : document_(document) {}

  HardwareInfo hardware(const XmlElement& tag) const {
    HardwareInfo info;
    info.name = attribute(tag, "name");
    info.type = attribute(tag, "type");
    info.rw_rate = rate_of(tag);
    info.is_async = parse_bool(attribute_or(tag, "is_async", "false"));
    info.thread_priority = info.is_async ? positive_number(tag, "thread_priority", 50)
                                         : std::numeric_limits<int>::max();
    info.async_params.thread_priority = info.thread_priority;
    for (const XmlElement* const child : document_.children(tag)) {
      add_child(*child, info);
    }
    for (TransmissionInfo& transmission : info.transmissions) {
      fill_interfaces(transmission, info);
    }
    return info;
  }

 private:
  void add_child(const XmlElement& child, HardwareInfo& info) const {
    if (child.name == "hardware") {
      add_plugin(child, info);
    } else if (child.name == "properties") {
      add_properties(child, info);
    } else if (child.name == "joint") {
      info.joints.push_back(component(child));
    } else if (child.name == "sensor") {
      info.sensors.push_back(component(child));
    } else if (child.name == "gpio") {
      info.gpios.push_back(component(child));
    } else if (child.name == "transmission") {
      info.transmissions.push_back(transmission(child));
    } else {
      throw problem("invalid tag name '" + child.name + "'");
    }
  }

  void add_plugin(const XmlElement& tag, HardwareInfo& info) const {
    info.hardware_plugin_name = plugin_of(tag, info.name);
    if (const XmlElement* const group = document_.child(tag, "group")) {
      info.group = ros2_control::strip(group->text);
    }
    info.hardware_parameters = parameters(tag, info.name);
  }

  std::string plugin_of(const XmlElement& tag, const std::string& name) const {
    const XmlElement* const plugin = document_.child(tag, "plugin");
    if (plugin == nullptr) {
      throw problem("Missing <plugin> tag of <" + tag.name + "> element for '" + name +
                    "' in your URDF.");
    }
    return ros2_control::strip(plugin->text);
  }

  void add_properties(const XmlElement& tag, HardwareInfo& info) const {
    const XmlElement* const async = document_.child(tag, "async");
    if (async == nullptr) {
      return;
    }
    HardwareAsyncParams& params = info.async_params;
    try {
      params.cpu_affinity_cores = parse_array<int>(attribute_or(*async, "affinity", "[]"));
      params.scheduling_policy =
          to_lower_case(attribute_or(*async, "scheduling_policy", "synchronized"));
      params.thread_priority = positive_number(*async, "thread_priority", params.thread_priority);
      info.thread_priority = params.thread_priority;
      params.print_warnings = parse_bool(attribute_or(*async, "print_warnings", "true"));
    } catch (const std::exception& error) {
      throw problem(std::string("Error parsing async tag: ") + error.what());
    }
  }

  Parameters parameters(const XmlElement& tag, const std::string& context) const {
    Parameters result;
    for (const XmlElement* const child : document_.children(tag, "param")) {
      const std::string* const name = child->attribute("name");
      if (name == nullptr) {
        throw problem("no parameter name attribute set in param tag for '" + context + "'");
      }
      result[ros2_control::strip(*name)] = ros2_control::strip(child->text);
    }
    return result;
  }

  bool limits_are_enabled(const XmlElement& tag) const {
    const XmlElement* const limits = document_.child(tag, "limits");
    return limits == nullptr || parse_bool(attribute(*limits, "enable"));
  }

  InterfaceInfo interface(const XmlElement& tag, const std::string& context) const {
    InterfaceInfo info;
    info.name = attribute(tag, "name");
    info.parameters = parameters(tag, context);
    const auto take = [&info](const char* name, std::string& into) {
      const auto found = info.parameters.find(name);
      if (found != info.parameters.end()) {
        into = found->second;
      }
    };
    take("min", info.min);
    take("max", info.max);
    take("initial_value", info.initial_value);
    info.enable_limits = limits_are_enabled(tag);
    info.data_type = attribute_or(tag, "data_type", "double");
    info.size = positive_number(tag, "size", 1);
    return info;
  }

  ComponentInfo component(const XmlElement& tag) const {
    ComponentInfo info;
    info.type = tag.name;
    info.name = attribute(tag, "name");
    if (tag.name == "joint" && tag.attribute("mimic") != nullptr) {
      info.is_mimic =
          parse_bool(attribute(tag, "mimic")) ? MimicAttribute::TRUE : MimicAttribute::FALSE;
    }
    info.enable_limits = limits_are_enabled(tag);
    const auto add_all = [&](const char* name, std::vector<InterfaceInfo>& into) {
      for (const XmlElement* const child : document_.children(tag, name)) {
        into.push_back(interface(*child, info.name));
        into.back().enable_limits = into.back().enable_limits && info.enable_limits;
      }
    };
    add_all("command_interface", info.command_interfaces);
    add_all("state_interface", info.state_interfaces);
    info.parameters = parameters(tag, info.name);
    return info;
  }

  double number_in(const XmlElement& tag, const char* name, double otherwise) const {
    const XmlElement* const child = document_.child(tag, name);
    try {
      return child == nullptr ? otherwise
                              : hardware_interface::stod(ros2_control::strip(child->text));
    } catch (const std::invalid_argument&) {
      return otherwise;
    }
  }

  template <typename EndT>
  EndT end_of_transmission(const XmlElement& tag) const {
    EndT end;
    end.name = attribute(tag, "name");
    end.role = attribute(tag, "role");
    end.read_only = parse_bool(attribute_or(tag, "read_only", "false"));
    end.mechanical_reduction = number_in(tag, "mechanical_reduction", 1.0);
    end.offset = number_in(tag, "offset", 0.0);
    return end;
  }

  TransmissionInfo transmission(const XmlElement& tag) const {
    TransmissionInfo info;
    info.name = attribute(tag, "name");
    info.type = plugin_of(tag, info.name);
    for (const XmlElement* const joint : document_.children(tag, "joint")) {
      info.joints.push_back(end_of_transmission<JointInfo>(*joint));
    }
    for (const XmlElement* const actuator : document_.children(tag, "actuator")) {
      info.actuators.push_back(end_of_transmission<ActuatorInfo>(*actuator));
    }
    info.parameters = parameters(tag, info.name);
    return info;
  }

  /// The joints of a transmission have the interfaces of the joints of the component.
  static void fill_interfaces(TransmissionInfo& transmission, const HardwareInfo& info) {
    for (JointInfo& joint : transmission.joints) {
      const ComponentInfo* found = nullptr;
      for (const ComponentInfo& candidate : info.joints) {
        found = candidate.name == joint.name ? &candidate : found;
      }
      if (found == nullptr) {
        throw problem("Error while parsing '" + info.name + "'. Transmission '" +
                      transmission.name + "' declared joint '" + joint.name +
                      "' is not available in component '" + info.name + "'.");
      }
      for (const InterfaceInfo& interface : found->command_interfaces) {
        joint.command_interfaces.push_back(interface.name);
      }
      for (const InterfaceInfo& interface : found->state_interfaces) {
        joint.state_interfaces.push_back(interface.name);
      }
    }
    if (info.type != "actuator") {
      return;
    }
    if (transmission.joints.size() != 1) {
      throw problem("Error while parsing '" + info.name +
                    "'. There should be exactly one joint defined in this component but found " +
                    std::to_string(transmission.joints.size()) + ".");
    }
    const JointInfo& joint = transmission.joints.front();
    transmission.actuators.push_back({"actuator1", joint.state_interfaces, joint.command_interfaces,
                                      "actuator1", 1.0, 0.0, false});
  }

  const XmlDocument& document_;
};

XmlDocument document_of(const std::string& urdf) {
  if (urdf.empty()) {
    throw problem("empty URDF passed to robot");
  }
  try {
    return XmlDocument(urdf);
  } catch (const ros2wasm_xml::XmlError& error) {
    throw problem(std::string("invalid URDF passed in to robot parser: ") + error.what());
  }
}

}  // namespace

std::vector<HardwareInfo> read_control_tags(const std::string& urdf) {
  const XmlDocument document = document_of(urdf);
  const XmlElement* parent = &document.root();
  if (parent->name == "sdf") {
    parent = document.child(*parent, "model");
  } else if (parent->name != "robot") {
    parent = nullptr;
  }
  if (parent == nullptr) {
    throw problem(
        "the robot tag is not root element in URDF or sdf tag is not root element in SDF");
  }
  const auto tags = document.children(*parent, "ros2_control");
  if (tags.empty()) {
    throw problem("no 'ros2_control' tag found in the URDF");
  }
  const ControlTag reader(document);
  std::vector<HardwareInfo> result;
  for (const XmlElement* const tag : tags) {
    result.push_back(reader.hardware(*tag));
    result.back().original_xml = urdf;
  }
  return result;
}

}  // namespace hardware_interface
