// Names of topics that belong together.
#pragma once

#include <string>

namespace image_transport {

/// The CameraInfo topic beside an image topic: /front/image_raw -> /front/camera_info.
std::string getCameraInfoTopic(const std::string& base_topic);

/// Takes the last part of a lookup name away when it ends so: image_transport/raw_pub -> .../raw.
std::string erase_last_copy(const std::string& input, const std::string& search);

}  // namespace image_transport
