// Endpoints and waiting, on the imports of host.h.
#include "ros2wasm/endpoint.hpp"

#include <time.h>

#include <algorithm>
#include <stdexcept>

namespace ros2wasm {
namespace {

uint32_t address(const void* pointer) {
  return static_cast<uint32_t>(reinterpret_cast<uintptr_t>(pointer));
}

// Creating and destroying is serialised for the whole participant.
std::mutex& creation_mutex() {
  static std::mutex mutex;
  return mutex;
}

int64_t read_clock(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<int64_t>(now.tv_sec) * 1000000000 + now.tv_nsec;
}

}  // namespace

NodeEntry::NodeEntry(std::string_view name, std::string_view ns) {
  const std::lock_guard<std::mutex> lock(creation_mutex());
  id_ = ros2wasm_node_create(name.data(), static_cast<uint32_t>(name.size()), ns.data(),
                             static_cast<uint32_t>(ns.size()));
  if (id_ < 0) {
    throw std::runtime_error("the bus refused node '" + std::string(name) + "', error " +
                             std::to_string(id_));
  }
}

NodeEntry::~NodeEntry() {
  const std::lock_guard<std::mutex> lock(creation_mutex());
  ros2wasm_node_destroy(id_);
}

Endpoint::Endpoint(EndpointKind kind, int32_t node, std::string_view name, std::string_view type,
                   std::string_view hash, const EndpointQos& qos) {
  ros2wasm_endpoint_desc desc{};
  desc.kind = static_cast<uint32_t>(kind);
  desc.node = static_cast<uint32_t>(node);
  desc.name = address(name.data());
  desc.name_len = static_cast<uint32_t>(name.size());
  desc.type = address(type.data());
  desc.type_len = static_cast<uint32_t>(type.size());
  desc.hash = address(hash.data());
  desc.hash_len = static_cast<uint32_t>(hash.size());
  desc.reliability = qos.reliability;
  desc.durability = qos.durability;
  desc.history = qos.history;
  desc.depth = qos.depth;
  desc.liveliness = qos.liveliness;
  desc.flags = qos.ignore_local_publications ? 1 : 0;
  desc.deadline_ns = qos.deadline_ns;
  desc.lifespan_ns = qos.lifespan_ns;
  desc.lease_ns = qos.lease_ns;
  const std::lock_guard<std::mutex> lock(creation_mutex());
  id_ = ros2wasm_endpoint_create(&desc);
  if (id_ < 0) {
    throw std::runtime_error("the bus refused '" + std::string(name) + "' of type " +
                             std::string(type) + ", error " + std::to_string(id_));
  }
  ros2wasm_endpoint_gid(id_, gid_.data());
}

Endpoint::~Endpoint() {
  const std::lock_guard<std::mutex> lock(creation_mutex());
  ros2wasm_endpoint_destroy(id_);
}

int32_t Endpoint::write(const void* data, size_t size, SampleInfo& info) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ros2wasm_write(id_, data, static_cast<uint32_t>(size), &info);
}

bool Endpoint::take(Bytes& buffer, SampleInfo& info) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (buffer.size() < size_hint_) {
    buffer.resize(size_hint_);
  }
  while (true) {
    const int32_t size =
        ros2wasm_take(id_, buffer.data(), static_cast<uint32_t>(buffer.size()), &info);
    if (size < 0) {
      return false;
    }
    size_hint_ = std::max<size_t>(size_hint_, static_cast<size_t>(size));
    const bool taken = static_cast<size_t>(size) <= buffer.size();
    buffer.resize(static_cast<size_t>(size));
    if (taken) {
      return true;
    }
  }
}

void Endpoint::drain() {
  Bytes buffer;
  SampleInfo info;
  while (take(buffer, info)) {
  }
}

int32_t Endpoint::matched() const {
  return ros2wasm_matched(id_);
}

bool Endpoint::status(int32_t kind, EndpointStatus& out) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ros2wasm_endpoint_status(id_, kind, &out) >= 0;
}

bool Endpoint::assert_liveliness() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ros2wasm_assert_liveliness(id_) >= 0;
}

int32_t status_version() {
  return ros2wasm_status_version();
}

int32_t wake_token() {
  return ros2wasm_wake_token();
}

WaitOutcome wait(int32_t token, int64_t timeout_ns) {
  switch (ros2wasm_wait(token, timeout_ns)) {
    case 1:
      return WaitOutcome::timeout;
    case 2:
      return WaitOutcome::stopped;
    default:
      return WaitOutcome::woken;
  }
}

void wake() {
  ros2wasm_wake();
}

bool stop_requested() {
  return ros2wasm_stop_requested() != 0;
}

bool sleep_for(int64_t duration_ns) {
  return ros2wasm_sleep(duration_ns) == 0;
}

void ready_endpoints(std::vector<uint32_t>& out) {
  out.resize(std::max<size_t>(out.capacity(), 32));
  while (true) {
    const int32_t count = ros2wasm_ready(out.data(), static_cast<uint32_t>(out.size()));
    const auto found = static_cast<size_t>(std::max<int32_t>(count, 0));
    const bool complete = found <= out.size();
    out.resize(found);
    if (complete) {
      return;
    }
  }
}

int64_t system_now_ns() {
  return read_clock(CLOCK_REALTIME);
}

int64_t steady_now_ns() {
  return read_clock(CLOCK_MONOTONIC);
}

}  // namespace ros2wasm
