// See noise.hpp.
#include "sensors/noise.hpp"

#include "plugins/parameters.hpp"

namespace ros2wasm_sim {

Noise Noise::read(const XmlView& xml, const ros2wasm_xml::XmlElement* element, Random& random) {
  Noise noise;
  if (element == nullptr) return noise;
  const Parameters given({xml.document, element});
  // SDF 1.6 and later have the type as an attribute, older files as an element.
  const std::string* attribute = element->attribute("type");
  const std::string type = attribute != nullptr ? *attribute : given.text("type", "none");
  if (type != "gaussian" && type != "gaussian_quantized") return noise;
  noise.exists_ = true;
  noise.mean_ = given.number("mean", 0);
  noise.stddev_ = given.number("stddev", 0);
  noise.precision_ = given.number("precision", 0);
  noise.bias_ = given.number("bias_mean", 0) + given.number("bias_stddev", 0) * random.gaussian();
  if (random.uniform() < 0.5) noise.bias_ = -noise.bias_;
  return noise;
}

}  // namespace ros2wasm_sim
