// One publisher, subscription, client or server on the bus, and the participant's wait.
// Knows bytes only; messages, callbacks and executors live above.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "ros2wasm/host.h"

namespace ros2wasm {

enum class EndpointKind : uint32_t { publisher = 1, subscription = 2, client = 3, server = 4 };

/// Policies carry rmw's numbers; a time of 0 means "no limit".
struct EndpointQos {
  uint32_t reliability = 1;
  uint32_t durability = 2;
  uint32_t history = 1;
  uint32_t depth = 10;
  uint32_t liveliness = 1;
  int64_t deadline_ns = 0;
  int64_t lifespan_ns = 0;
  int64_t lease_ns = 0;
  bool ignore_local_publications = false;
};

/// A serialised message. New bytes are left as they are: what fills the buffer overwrites them.
class Bytes {
 public:
  Bytes() = default;
  explicit Bytes(size_t size) { resize(size); }
  [[nodiscard]] uint8_t* data() { return data_.get(); }
  [[nodiscard]] const uint8_t* data() const { return data_.get(); }
  [[nodiscard]] size_t size() const { return size_; }
  /// Loses the content when the buffer has to grow.
  void resize(size_t size) {
    if (size > capacity_) {
      data_.reset(new uint8_t[size]);
      capacity_ = size;
    }
    size_ = size;
  }

 private:
  std::unique_ptr<uint8_t[]> data_;
  size_t size_ = 0;
  size_t capacity_ = 0;
};

using Gid = std::array<uint8_t, 16>;
using SampleInfo = ros2wasm_sample_info;
using EndpointStatus = ros2wasm_status;

/// A node's entry in the graph; goes away with the object.
class NodeEntry {
 public:
  /// Throws std::runtime_error when the bus has no room.
  NodeEntry(std::string_view name, std::string_view ns);
  ~NodeEntry();
  NodeEntry(const NodeEntry&) = delete;
  NodeEntry& operator=(const NodeEntry&) = delete;
  [[nodiscard]] int32_t id() const { return id_; }

 private:
  int32_t id_;
};

/// Owner of one endpoint; calls on it are serialised here, so any thread may use it.
class Endpoint {
 public:
  /// Throws std::runtime_error, with the bus's error number, when it cannot be made.
  Endpoint(EndpointKind kind, int32_t node, std::string_view name, std::string_view type,
           std::string_view hash, const EndpointQos& qos);
  ~Endpoint();
  Endpoint(const Endpoint&) = delete;
  Endpoint& operator=(const Endpoint&) = delete;

  [[nodiscard]] int32_t id() const { return id_; }
  [[nodiscard]] const Gid& gid() const { return gid_; }
  /// 0, or the bus's error number (< 0).
  int32_t write(const void* data, size_t size, SampleInfo& info);
  /// Resizes `buffer` to the payload; false when there is nothing.
  bool take(Bytes& buffer, SampleInfo& info);
  /// Throws away whatever waits to be taken.
  void drain();
  [[nodiscard]] int32_t matched() const;
  /// False when the endpoint has no such status.
  bool status(int32_t kind, EndpointStatus& out);
  /// Tells the readers of a publisher with manual liveliness that it lives.
  bool assert_liveliness();

 private:
  int32_t id_;
  Gid gid_{};
  std::mutex mutex_;
  size_t size_hint_ = 256;
};

enum class WaitOutcome { woken, timeout, stopped };

/// Read the token, look whether there is work, then wait on the token: no wake-up is lost.
int32_t wake_token();
WaitOutcome wait(int32_t token, int64_t timeout_ns);
void wake();
bool stop_requested();
/// Sleeps in steady time; false when a stop was requested meanwhile.
bool sleep_for(int64_t duration_ns);
/// Ids of this participant's readers that have something to take.
void ready_endpoints(std::vector<uint32_t>& out);
/// Changes with every status of an own endpoint; waits end when one that was ever read changes.
int32_t status_version();
int64_t system_now_ns();
int64_t steady_now_ns();

}  // namespace ros2wasm
