// Shared by the tests of the simulator's readers of worlds and models.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "sdf/read_sdf.hpp"

namespace sdf_texts {

using namespace ros2wasm_sim;

/// Resources that are texts by path. A URI is found when it is a path, or a folder of one, after
/// `model://` or `file://` was replaced by /models/ and nothing.
inline Resources files(const std::map<std::string, std::string>& texts) {
  Resources result;
  result.read = [texts](const std::string& path) -> std::optional<std::string> {
    const auto found = texts.find(path);
    return found == texts.end() ? std::nullopt : std::optional(found->second);
  };
  result.find = [texts](const std::string& uri,
                        std::vector<std::string>& searched) -> std::optional<std::string> {
    searched.push_back("/models");
    std::string path = uri;
    for (const char* scheme : {"model://", "package://"}) {
      const std::string prefix = scheme;
      path = uri.compare(0, prefix.size(), prefix) == 0 ? "/models/" + uri.substr(prefix.size())
                                                        : path;
    }
    path = path.compare(0, 7, "file://") == 0 ? path.substr(7) : path;
    const auto found = texts.lower_bound(path);
    const bool is_there =
        found != texts.end() &&
        (found->first == path || found->first.compare(0, path.size() + 1, path + "/") == 0);
    return is_there ? std::optional(path) : std::nullopt;
  };
  return result;
}

/// `error world:3: text`, one a line.
inline std::string said(const std::vector<Note>& notes) {
  std::string result;
  for (const Note& note : notes) {
    result += (note.severity == Severity::kError ? "error " : "warning ") + note.file + ":" +
              std::to_string(note.line) + ": " + note.text + "\n";
  }
  return result;
}

inline std::string world_text(const std::string& inside, const std::string& version = "1.9") {
  return "<sdf version='" + version + "'><world name='w'>" + inside + "</world></sdf>";
}
inline std::string model_text(const std::string& inside, const std::string& version = "1.9") {
  return "<sdf version='" + version + "'><model name='m'>" + inside + "</model></sdf>";
}

inline World world_of(const std::string& inside,
                      const std::map<std::string, std::string>& texts = {},
                      const std::string& version = "1.9") {
  const Reading<World> reading = read_world(world_text(inside, version), "world", files(texts));
  EXPECT_EQ(said(reading.notes), "");
  return reading.value.value_or(World());
}
inline Model model_of(const std::string& inside, const std::string& version = "1.9") {
  const Reading<Model> reading = read_model(model_text(inside, version), "model", files({}));
  EXPECT_EQ(said(reading.notes), "");
  return reading.value.value_or(Model());
}
/// Says what is wrong; the value is missing exactly when there is an error.
inline std::string notes_of_world(const std::string& inside,
                                  const std::map<std::string, std::string>& texts = {}) {
  const Reading<World> reading = read_world(world_text(inside), "world", files(texts));
  const std::string result = said(reading.notes);
  EXPECT_EQ(reading.value.has_value(), result.find("error ") == std::string::npos) << result;
  return result;
}
inline std::string notes_of_model(const std::string& inside) {
  const Reading<Model> reading = read_model(model_text(inside), "model", files({}));
  const std::string result = said(reading.notes);
  EXPECT_EQ(reading.value.has_value(), result.find("error ") == std::string::npos) << result;
  return result;
}

inline void expect_near(const Vector3& value, const Vector3& expected) {
  EXPECT_NEAR(value.x, expected.x, 1e-12);
  EXPECT_NEAR(value.y, expected.y, 1e-12);
  EXPECT_NEAR(value.z, expected.z, 1e-12);
}
inline void expect_near(const Pose& value, const Pose& expected) {
  expect_near(value.position, expected.position);
  // q and -q are the same rotation.
  const Quaternion difference = inverse(value.orientation) * expected.orientation;
  EXPECT_NEAR(std::fabs(difference.w), 1, 1e-12);
}
inline Pose pose_of(double x, double y, double z, double roll = 0, double pitch = 0,
                    double yaw = 0) {
  return {{x, y, z}, from_roll_pitch_yaw(roll, pitch, yaw)};
}

constexpr double kPi = 3.14159265358979323846;

}  // namespace sdf_texts
