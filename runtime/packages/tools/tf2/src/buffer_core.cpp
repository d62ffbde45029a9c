// The tree of frames. A lookup climbs from both frames to the first that stands above both, and
// multiplies what it meets on the way.
#include "tf2/buffer_core.hpp"

#include <rcutils/logging_macros.h>

#include <algorithm>
#include <cmath>

#include "tf2/time_cache.hpp"

namespace tf2 {
namespace {

constexpr TransformableRequestHandle kNever = ~TransformableRequestHandle(0);
constexpr double kLengthTolerance = 10e-3;

std::string without_slash(const std::string& frame) {
  return frame.compare(0, 1, "/") == 0 ? frame.substr(1) : frame;
}

TimePoint time_of(const builtin_interfaces::msg::Time& stamp) {
  return TimePoint(std::chrono::seconds(stamp.sec) + std::chrono::nanoseconds(stamp.nanosec));
}

builtin_interfaces::msg::Time stamp_of(TimePoint time) {
  const auto nanoseconds = time.time_since_epoch().count();
  builtin_interfaces::msg::Time stamp;
  stamp.sec = static_cast<int32_t>(nanoseconds / 1000000000);
  stamp.nanosec = static_cast<uint32_t>(nanoseconds % 1000000000);
  return stamp;
}

Transform product(const std::vector<TransformStorage>& way) {
  Quaternion rotation = Quaternion::getIdentity();
  Vector3 translation(0, 0, 0);
  for (const TransformStorage& step : way) {
    translation = quatRotate(step.rotation_, translation) + step.translation_;
    rotation = step.rotation_ * rotation;
  }
  return Transform(rotation, translation);
}

[[noreturn]] void throw_error(TF2Error code, const std::string& text) {
  switch (code) {
    case TF2Error::TF2_CONNECTIVITY_ERROR:
      throw ConnectivityException(text);
    case TF2Error::TF2_BACKWARD_EXTRAPOLATION_ERROR:
      throw BackwardExtrapolationException(text);
    case TF2Error::TF2_FORWARD_EXTRAPOLATION_ERROR:
      throw ForwardExtrapolationException(text);
    case TF2Error::TF2_NO_DATA_FOR_EXTRAPOLATION_ERROR:
      throw NoDataForExtrapolationException(text);
    default:
      throw LookupException(text);
  }
}

geometry_msgs::msg::TransformStamped message_of(const Transform& transform, TimePoint time,
                                                const std::string& target,
                                                const std::string& source) {
  geometry_msgs::msg::TransformStamped message;
  message.header.stamp = stamp_of(time);
  message.header.frame_id = target;
  message.child_frame_id = source;
  message.transform.translation.x = transform.getOrigin().x();
  message.transform.translation.y = transform.getOrigin().y();
  message.transform.translation.z = transform.getOrigin().z();
  const Quaternion rotation = transform.getRotation();
  message.transform.rotation.x = rotation.x();
  message.transform.rotation.y = rotation.y();
  message.transform.rotation.z = rotation.z();
  message.transform.rotation.w = rotation.w();
  return message;
}

// Logs all that is wrong with a transform; false when something is.
bool is_valid(const Transform& transform, const std::string& parent, const std::string& child,
              const std::string& authority) {
  bool valid = true;
  if (child == parent) {
    RCUTILS_LOG_ERROR(
        "TF_SELF_TRANSFORM: Ignoring transform from authority \"%s\" with frame_id and  "
        "child_frame_id \"%s\" because they are the same",
        authority.c_str(), child.c_str());
    valid = false;
  }
  if (child.empty()) {
    RCUTILS_LOG_ERROR(
        "TF_NO_CHILD_FRAME_ID: Ignoring transform from authority \"%s\" because child_frame_id "
        "not set ",
        authority.c_str());
    valid = false;
  }
  if (parent.empty()) {
    RCUTILS_LOG_ERROR(
        "TF_NO_FRAME_ID: Ignoring transform with child_frame_id \"%s\"  from authority \"%s\" "
        "because frame_id not set",
        child.c_str(), authority.c_str());
    valid = false;
  }
  const Vector3& origin = transform.getOrigin();
  const Quaternion rotation = transform.getRotation();
  if (std::isnan(origin.x() + origin.y() + origin.z()) || std::isnan(rotation.length2())) {
    RCUTILS_LOG_ERROR(
        "TF_NAN_INPUT: Ignoring transform for child_frame_id \"%s\" from authority \"%s\" because "
        "of a nan value in the transform (%f %f %f) (%f %f %f %f)",
        child.c_str(), authority.c_str(), origin.x(), origin.y(), origin.z(), rotation.x(),
        rotation.y(), rotation.z(), rotation.w());
    valid = false;
  }
  if (!(std::abs(rotation.length2() - 1) < kLengthTolerance)) {
    RCUTILS_LOG_ERROR(
        "TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id \"%s\" from authority "
        "\"%s\" because of an invalid quaternion in the transform (%f %f %f %f)",
        child.c_str(), authority.c_str(), rotation.x(), rotation.y(), rotation.z(), rotation.w());
    valid = false;
  }
  return valid;
}

}  // namespace

BufferCore::BufferCore(Duration cache_time) : cache_time_(cache_time) {
  number_or_new("NO_PARENT");
}

BufferCore::~BufferCore() = default;

void BufferCore::clear() {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  for (Frame& frame : frames_) {
    if (frame.cache) {
      frame.cache->clearList();
    }
  }
}

bool BufferCore::setTransform(const geometry_msgs::msg::TransformStamped& transform,
                              const std::string& authority, bool is_static) {
  const std::string parent = without_slash(transform.header.frame_id);
  const std::string child = without_slash(transform.child_frame_id);
  const auto& rotation = transform.transform.rotation;
  const auto& translation = transform.transform.translation;
  // A matrix, so that a quaternion of any length will do.
  const Transform value(Quaternion(rotation.x, rotation.y, rotation.z, rotation.w),
                        Vector3(translation.x, translation.y, translation.z));
  if (!is_valid(value, parent, child, authority)) {
    return false;
  }
  {
    const std::lock_guard<std::mutex> lock(frame_mutex_);
    const CompactFrameID parent_number = number_or_new(parent);
    const CompactFrameID number = number_or_new(child);
    Frame& frame = frames_[number];
    const bool was_static = dynamic_cast<StaticCache*>(frame.cache.get()) != nullptr;
    if (!frame.cache || was_static != is_static) {
      frame.cache = is_static ? TimeCacheInterfacePtr(std::make_shared<StaticCache>())
                              : std::make_shared<TimeCache>(cache_time_);
    }
    const TimePoint stamp = time_of(transform.header.stamp);
    if (!frame.cache->insertData(TransformStorage(stamp, value.getRotation(), value.getOrigin(),
                                                  parent_number, number))) {
      RCUTILS_LOG_WARN(
          "TF_OLD_DATA ignoring data from the past for frame %s at time %s according to authority "
          "%s\nPossible reasons are listed at http://wiki.ros.org/tf/Errors%%20explained",
          child.c_str(), displayTimePoint(stamp).c_str(), authority.c_str());
      return false;
    }
    frame.authority = authority;
  }
  answer_requests();
  return true;
}

CompactFrameID BufferCore::number_of(const std::string& name) const {
  const auto found = numbers_.find(name);
  return found == numbers_.end() ? 0 : found->second;
}

CompactFrameID BufferCore::number_or_new(const std::string& name) {
  const auto [found, is_new] =
      numbers_.try_emplace(name, static_cast<CompactFrameID>(frames_.size()));
  if (is_new) {
    frames_.emplace_back().name = name;
  }
  return found->second;
}

const std::string& BufferCore::name_of(CompactFrameID frame) const {
  if (frame >= frames_.size()) {
    throw LookupException("Reverse lookup of frame id " + std::to_string(frame) + " failed!");
  }
  return frames_[frame].name;
}

CompactFrameID BufferCore::checked_number(const char* argument, const std::string& name) const {
  const std::string text = "\"" + name + "\" passed to " + argument;
  if (name.empty()) {
    throw InvalidArgumentException("Invalid argument " + text +
                                   " - in tf2 frame_ids cannot be empty");
  }
  if (name[0] == '/') {
    throw InvalidArgumentException("Invalid argument " + text +
                                   " - in tf2 frame_ids cannot start with a '/'");
  }
  const CompactFrameID number = number_of(name);
  if (number == 0) {
    throw LookupException(text + " does not exist. ");
  }
  return number;
}

CompactFrameID BufferCore::known_number(const char* argument, const std::string& name,
                                        std::string* error) const {
  const CompactFrameID number = name.empty() || name[0] == '/' ? 0 : number_of(name);
  if (number == 0) {
    const char* why = name.empty()     ? "in tf2 frame_ids cannot be empty"
                      : name[0] == '/' ? "in tf2 frame_ids cannot start with a '/'"
                                       : "frame does not exist";
    const std::string text =
        "Invalid frame ID \"" + name + "\" passed to " + argument + " - " + why;
    if (error != nullptr) {
      *error = text;
    } else {
      RCUTILS_LOG_WARN_THROTTLE(RCUTILS_STEADY_TIME, 2500, "%s", text.c_str());
    }
  }
  return number;
}

TF2Error BufferCore::loop_error(std::string* error) const {
  if (error != nullptr) {
    *error = "The tf tree is invalid because it contains a loop.\n" + frames_as_string() + "\n";
  }
  return TF2Error::TF2_LOOKUP_ERROR;
}

TF2Error BufferCore::unconnected(CompactFrameID target, CompactFrameID source,
                                 std::string* error) const {
  if (error != nullptr) {
    *error = "Could not find a connection between '" + name_of(target) + "' and '" +
             name_of(source) +
             "' because they are not part of the same tree."
             "Tf has two or more unconnected trees.";
  }
  return TF2Error::TF2_CONNECTIVITY_ERROR;
}

TF2Error BufferCore::find_path(CompactFrameID target, CompactFrameID source, TimePoint time,
                               Path& path, std::string* error) const {
  if (time == TimePointZero && source != target) {
    const TF2Error code = latest_common_time(target, source, time, error);
    if (code != TF2Error::TF2_NO_ERROR) {
      return code;
    }
  }
  path = Path{{}, {}, time};
  const std::string between = ", when looking up transform from frame [" + name_of(source) +
                              "] to frame [" + name_of(target) + "]";
  // A frame without data at this time may yet be above the target too.
  std::string missing;
  TF2Error missing_code = TF2Error::TF2_NO_ERROR;
  CompactFrameID top = source;
  TransformStorage step;
  while (top != target && frames_[top].cache &&
         frames_[top].cache->getData(time, step, &missing, &missing_code)) {
    path.from_source.push_back(step);
    if (path.from_source.size() > MAX_GRAPH_DEPTH) {
      return loop_error(error);
    }
    top = step.frame_id_;
  }
  for (CompactFrameID frame = target; frame != top; frame = step.frame_id_) {
    const auto met = std::find_if(
        path.from_source.begin(), path.from_source.end(),
        [frame](const TransformStorage& passed) { return passed.child_frame_id_ == frame; });
    if (met != path.from_source.end()) {
      path.from_source.erase(met, path.from_source.end());
      break;
    }
    if (!frames_[frame].cache) {
      if (missing_code == TF2Error::TF2_NO_ERROR) {
        return unconnected(target, source, error);
      }
      if (error != nullptr) {
        *error = missing + between;
      }
      return missing_code;
    }
    TF2Error code = TF2Error::TF2_NO_ERROR;
    if (!frames_[frame].cache->getData(time, step, error, &code)) {
      if (error != nullptr) {
        *error += between;
      }
      return code;
    }
    path.from_target.push_back(step);
    if (path.from_target.size() > MAX_GRAPH_DEPTH) {
      return loop_error(error);
    }
  }
  return TF2Error::TF2_NO_ERROR;
}

TF2Error BufferCore::latest_common_time(CompactFrameID target, CompactFrameID source,
                                        TimePoint& time, std::string* error) const {
  if (source == 0 || target == 0) {
    return TF2Error::TF2_LOOKUP_ERROR;
  }
  if (source == target) {
    const auto& cache = frames_[source].cache;
    time = cache ? cache->getLatestTimestamp() : TimePointZero;
    return TF2Error::TF2_NO_ERROR;
  }
  // The frames from one up to the root, each with its latest time.
  using Way = std::vector<std::pair<CompactFrameID, TimePoint>>;
  const auto climb = [this](CompactFrameID frame) {
    Way way;
    while (frame != 0 && way.size() <= MAX_GRAPH_DEPTH) {
      const auto& cache = frames_[frame].cache;
      const auto latest = cache ? cache->getLatestTimeAndParent() : P_TimeAndFrameID();
      way.emplace_back(frame, latest.first);
      frame = latest.second;
    }
    return way;
  };
  const Way from_source = climb(source);
  const Way from_target = climb(target);
  const auto common = std::find_first_of(
      from_source.begin(), from_source.end(), from_target.begin(), from_target.end(),
      [](const auto& one, const auto& other) { return one.first == other.first; });
  if (common == from_source.end()) {
    const bool loops = std::max(from_source.size(), from_target.size()) > MAX_GRAPH_DEPTH;
    return loops ? loop_error(error) : unconnected(target, source, error);
  }
  // Static frames have no time: zero.
  TimePoint latest = TimePoint::max();
  for (const Way* way : {&from_source, &from_target}) {
    for (const auto& [frame, stamp] : *way) {
      if (frame == common->first) {
        break;
      }
      latest = stamp == TimePointZero ? latest : std::min(latest, stamp);
    }
  }
  time = latest == TimePoint::max() ? TimePointZero : latest;
  return TF2Error::TF2_NO_ERROR;
}

BufferCore::Path BufferCore::checked_path(CompactFrameID target, CompactFrameID source,
                                          TimePoint time) const {
  Path path;
  std::string error;
  const TF2Error code = find_path(target, source, time, path, &error);
  if (code != TF2Error::TF2_NO_ERROR) {
    throw_error(code, error);
  }
  return path;
}

BufferCore::Found BufferCore::find(const std::string& target, const std::string& source,
                                   TimePoint time) const {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  if (target == source) {
    const auto& cache = frames_[number_of(target)].cache;
    const bool latest = time == TimePointZero && cache;
    return {Transform::getIdentity(), latest ? cache->getLatestTimestamp() : time};
  }
  const CompactFrameID target_number =
      checked_number("lookupTransform argument target_frame", target);
  const CompactFrameID source_number =
      checked_number("lookupTransform argument source_frame", source);
  const Path path = checked_path(target_number, source_number, time);
  return {product(path.from_target).inverseTimes(product(path.from_source)), path.time};
}

geometry_msgs::msg::TransformStamped BufferCore::lookupTransform(const std::string& target_frame,
                                                                 const std::string& source_frame,
                                                                 const TimePoint& time) const {
  const Found found = find(target_frame, source_frame, time);
  return message_of(found.transform, found.time, target_frame, source_frame);
}

geometry_msgs::msg::TransformStamped BufferCore::lookupTransform(
    const std::string& target_frame, const TimePoint& target_time, const std::string& source_frame,
    const TimePoint& source_time, const std::string& fixed_frame) const {
  {
    const std::lock_guard<std::mutex> lock(frame_mutex_);
    checked_number("lookupTransform argument target_frame", target_frame);
    checked_number("lookupTransform argument source_frame", source_frame);
    checked_number("lookupTransform argument fixed_frame", fixed_frame);
  }
  const Found to_fixed = find(fixed_frame, source_frame, source_time);
  const Found from_fixed = find(target_frame, fixed_frame, target_time);
  return message_of(from_fixed.transform * to_fixed.transform, from_fixed.time, target_frame,
                    source_frame);
}

geometry_msgs::msg::VelocityStamped BufferCore::lookupVelocity(
    const std::string& tracking_frame, const std::string& observation_frame, const TimePoint& time,
    const Duration& averaging_interval) const {
  return lookupVelocity(tracking_frame, observation_frame, observation_frame, Vector3(0, 0, 0),
                        tracking_frame, time, averaging_interval);
}

geometry_msgs::msg::VelocityStamped BufferCore::lookupVelocity(
    const std::string& tracking_frame, const std::string& observation_frame,
    const std::string& reference_frame, const Vector3& reference_point,
    const std::string& reference_point_frame, const TimePoint& time,
    const Duration& duration) const {
  TimePoint latest;
  _getLatestCommonTime(_lookupFrameNumber(observation_frame), _lookupFrameNumber(tracking_frame),
                       latest, nullptr);
  // Half of the interval on each side, but never after what is known, nor before time began.
  const double interval = durationToSec(duration);
  const double end = std::min(timeToSec(time) + interval / 2, timeToSec(latest));
  const double start = std::max(0.00001 + interval, end) - interval;
  const Transform before = find(observation_frame, tracking_frame, timeFromSec(start)).transform;
  const Transform after = find(observation_frame, tracking_frame, timeFromSec(end)).transform;
  const Quaternion turned = before.inverseTimes(after).getRotation();
  const Vector3 linear = (after.getOrigin() - before.getOrigin()) / (end - start);
  const Vector3 angular =
      before.getBasis() * turned.getAxis() * (turned.getAngle() / (end - start));

  const Transform reference = find(reference_frame, tracking_frame, time).transform;
  const Vector3 point =
      find(reference_frame, reference_point_frame, time).transform * reference_point;
  const Vector3 rotation = reference.getBasis() * angular;
  const Vector3 translation = reference.getBasis() * linear +
                              reference.getOrigin().cross(rotation) +
                              rotation * (point - reference.getOrigin());

  geometry_msgs::msg::VelocityStamped velocity;
  velocity.header.stamp = stamp_of(timeFromSec(start + interval / 2));
  velocity.header.frame_id = reference_frame;
  velocity.body_frame_id = tracking_frame;
  velocity.velocity.linear.x = translation.x();
  velocity.velocity.linear.y = translation.y();
  velocity.velocity.linear.z = translation.z();
  velocity.velocity.angular.x = rotation.x();
  velocity.velocity.angular.y = rotation.y();
  velocity.velocity.angular.z = rotation.z();
  return velocity;
}

bool BufferCore::can_transform(CompactFrameID target, CompactFrameID source, TimePoint time,
                               std::string* error) const {
  if (target == 0 || source == 0) {
    if (error != nullptr) {
      *error = "Source or target frame is not yet defined";
    }
    return false;
  }
  Path path;
  return target == source || find_path(target, source, time, path, error) == TF2Error::TF2_NO_ERROR;
}

bool BufferCore::canTransform(const std::string& target_frame, const std::string& source_frame,
                              const TimePoint& time, std::string* error_msg) const {
  if (target_frame == source_frame) {
    return true;
  }
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  const CompactFrameID target =
      known_number("canTransform argument target_frame", target_frame, error_msg);
  if (target == 0) {
    return false;
  }
  const CompactFrameID source =
      known_number("canTransform argument source_frame", source_frame, error_msg);
  return source != 0 && can_transform(target, source, time, error_msg);
}

bool BufferCore::canTransform(const std::string& target_frame, const TimePoint& target_time,
                              const std::string& source_frame, const TimePoint& source_time,
                              const std::string& fixed_frame, std::string* error_msg) const {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  const CompactFrameID target =
      known_number("canTransform argument target_frame", target_frame, error_msg);
  if (target == 0) {
    return false;
  }
  const CompactFrameID source =
      known_number("canTransform argument source_frame", source_frame, error_msg);
  if (source == 0) {
    return false;
  }
  const CompactFrameID fixed =
      known_number("canTransform argument fixed_frame", fixed_frame, error_msg);
  return fixed != 0 && can_transform(target, fixed, target_time, error_msg) &&
         can_transform(fixed, source, source_time, error_msg);
}

TransformableRequestHandle BufferCore::addTransformableRequest(const TransformableCallback& cb,
                                                               const std::string& target_frame,
                                                               const std::string& source_frame,
                                                               TimePoint time) {
  if (target_frame == source_frame) {
    return 0;
  }
  // Held all the way: a transform that comes meanwhile must find the request.
  const std::lock_guard<std::mutex> lock(requests_mutex_);
  Request request{0, cb, target_frame, source_frame, time};
  TransformableResult result = TransformAvailable;
  if (is_decided(request, result)) {
    return result == TransformAvailable ? 0 : kNever;
  }
  request.handle = ++last_request_;
  requests_.push_back(std::move(request));
  return last_request_;
}

void BufferCore::cancelTransformableRequest(TransformableRequestHandle handle) {
  const std::lock_guard<std::mutex> lock(requests_mutex_);
  requests_.erase(std::remove_if(requests_.begin(), requests_.end(),
                                 [handle](const Request& one) { return one.handle == handle; }),
                  requests_.end());
}

bool BufferCore::is_decided(const Request& request, TransformableResult& result) const {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  const CompactFrameID target = number_of(request.target);
  const CompactFrameID source = number_of(request.source);
  TimePoint latest;
  latest_common_time(target, source, latest, nullptr);
  const bool too_old = latest != TimePointZero && request.time + cache_time_ < latest;
  const bool latest_asked = request.time == TimePointZero;
  result = too_old && !latest_asked ? TransformFailure : TransformAvailable;
  return result == TransformFailure || can_transform(target, source, request.time, nullptr);
}

void BufferCore::answer_requests() {
  // Called without a lock, so that a callback may ask for more.
  std::vector<std::pair<Request, TransformableResult>> answers;
  {
    const std::lock_guard<std::mutex> lock(requests_mutex_);
    const auto answered = [&](Request& request) {
      TransformableResult result = TransformAvailable;
      if (!is_decided(request, result)) {
        return false;
      }
      answers.emplace_back(std::move(request), result);
      return true;
    };
    requests_.erase(std::remove_if(requests_.begin(), requests_.end(), answered), requests_.end());
  }
  for (const auto& [request, result] : answers) {
    request.callback(request.handle, request.target, request.source, request.time, result);
  }
}

}  // namespace tf2
