// Reading the graph snapshot.
#include "ros2wasm/graph.hpp"

#include <cstring>

namespace ros2wasm {
namespace {

class Reader {
 public:
  Reader(const uint8_t* bytes, size_t size) : bytes_(bytes), size_(size) {}

  template <typename T>
  T number() {
    T value{};
    copy(&value, sizeof(value));
    return value;
  }
  std::string text() {
    const uint32_t length = number<uint32_t>();
    if (length > size_ - at_) {
      ok_ = false;
      return {};
    }
    std::string value(reinterpret_cast<const char*>(bytes_ + at_), length);
    at_ += length;
    return value;
  }
  void copy(void* out, size_t count) {
    if (count > size_ - at_) {
      ok_ = false;
      return;
    }
    std::memcpy(out, bytes_ + at_, count);
    at_ += count;
  }
  [[nodiscard]] bool ok() const { return ok_; }

 private:
  const uint8_t* bytes_;
  size_t size_;
  size_t at_ = 0;
  bool ok_ = true;
};

GraphEndpoint read_endpoint(Reader& reader) {
  GraphEndpoint endpoint;
  endpoint.kind = static_cast<EndpointKind>(reader.number<uint32_t>());
  endpoint.node_index = reader.number<uint32_t>();
  endpoint.name = reader.text();
  endpoint.type = reader.text();
  endpoint.hash = reader.text();
  endpoint.qos.reliability = reader.number<uint32_t>();
  endpoint.qos.durability = reader.number<uint32_t>();
  endpoint.qos.history = reader.number<uint32_t>();
  endpoint.qos.depth = reader.number<uint32_t>();
  endpoint.qos.liveliness = reader.number<uint32_t>();
  endpoint.qos.deadline_ns = reader.number<int64_t>();
  endpoint.qos.lifespan_ns = reader.number<int64_t>();
  endpoint.qos.lease_ns = reader.number<int64_t>();
  reader.copy(endpoint.gid.data(), endpoint.gid.size());
  return endpoint;
}

}  // namespace

bool parse_graph(const uint8_t* bytes, size_t size, Graph& out) {
  Reader reader(bytes, size);
  const uint32_t node_count = reader.number<uint32_t>();
  for (uint32_t i = 0; i < node_count && reader.ok(); ++i) {
    GraphNode node;
    node.participant = reader.number<uint32_t>();
    node.ns = reader.text();
    node.name = reader.text();
    out.nodes.push_back(std::move(node));
  }
  const uint32_t endpoint_count = reader.number<uint32_t>();
  for (uint32_t i = 0; i < endpoint_count && reader.ok(); ++i) {
    out.endpoints.push_back(read_endpoint(reader));
    if (out.endpoints.back().node_index >= out.nodes.size()) {
      return false;
    }
  }
  return reader.ok();
}

Graph take_graph_snapshot() {
  std::vector<uint8_t> bytes(4096);
  while (true) {
    const int32_t size = ros2wasm_graph_snapshot(bytes.data(), static_cast<uint32_t>(bytes.size()));
    if (size < 0) {
      return {};
    }
    if (static_cast<size_t>(size) <= bytes.size()) {
      Graph graph;
      return parse_graph(bytes.data(), static_cast<size_t>(size), graph) ? graph : Graph();
    }
    bytes.resize(static_cast<size_t>(size) * 2);
  }
}

int32_t graph_version() {
  return ros2wasm_graph_version();
}

}  // namespace ros2wasm
