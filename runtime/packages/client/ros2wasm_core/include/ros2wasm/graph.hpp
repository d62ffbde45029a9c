// The graph as the bus shows it at one moment.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros2wasm/endpoint.hpp"

namespace ros2wasm {

struct GraphNode {
  uint32_t participant;
  std::string ns;
  std::string name;
};

struct GraphEndpoint {
  EndpointKind kind;
  uint32_t node_index;
  std::string name;
  std::string type;
  std::string hash;
  EndpointQos qos;
  Gid gid;
};

struct Graph {
  std::vector<GraphNode> nodes;
  std::vector<GraphEndpoint> endpoints;
};

/// Empty when the bus hands out something that cannot be read.
Graph take_graph_snapshot();
/// Reads the binary form; false when it is cut short or inconsistent.
bool parse_graph(const uint8_t* bytes, size_t size, Graph& out);
int32_t graph_version();

}  // namespace ros2wasm
