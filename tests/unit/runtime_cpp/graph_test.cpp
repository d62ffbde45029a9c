// Graph snapshots: what is read back, and what is refused.
#include "ros2wasm/graph.hpp"

#include <gtest/gtest.h>

#include <cstring>

// The import that the snapshot comes from; these tests hand their own bytes to the parser.
extern "C" int32_t ros2wasm_graph_snapshot(uint8_t*, uint32_t) {
  return -1;
}
extern "C" int32_t ros2wasm_graph_version(void) {
  return 0;
}

namespace ros2wasm {
namespace {

class Bytes {
 public:
  template <typename T>
  Bytes& number(T value) {
    const size_t at = bytes.size();
    bytes.resize(at + sizeof(value));
    std::memcpy(bytes.data() + at, &value, sizeof(value));
    return *this;
  }
  Bytes& text(const std::string& value) {
    number(static_cast<uint32_t>(value.size()));
    bytes.insert(bytes.end(), value.begin(), value.end());
    return *this;
  }
  std::vector<uint8_t> bytes;
};

Bytes sample(uint32_t node_index) {
  Bytes bytes;
  bytes.number(1u).number(7u).text("/ns").text("talker");
  bytes.number(1u).number(1u).number(node_index).text("/chatter").text("std_msgs/msg/String");
  bytes.text("RIHS01_x").number(1u).number(2u).number(1u).number(10u).number(1u);
  bytes.number(int64_t{5}).number(int64_t{6}).number(int64_t{7});
  for (uint8_t i = 0; i < 16; ++i) {
    bytes.number(i);
  }
  return bytes;
}

TEST(Graph, ReadsNodesAndEndpoints) {
  const Bytes bytes = sample(0);
  Graph graph;
  ASSERT_TRUE(parse_graph(bytes.bytes.data(), bytes.bytes.size(), graph));
  ASSERT_EQ(graph.nodes.size(), 1u);
  EXPECT_EQ(graph.nodes[0].ns, "/ns");
  EXPECT_EQ(graph.nodes[0].name, "talker");
  ASSERT_EQ(graph.endpoints.size(), 1u);
  const GraphEndpoint& endpoint = graph.endpoints[0];
  EXPECT_EQ(endpoint.kind, EndpointKind::publisher);
  EXPECT_EQ(endpoint.name, "/chatter");
  EXPECT_EQ(endpoint.qos.depth, 10u);
  EXPECT_EQ(endpoint.qos.lease_ns, 7);
  EXPECT_EQ(endpoint.gid[15], 15);
}

TEST(Graph, RefusesWhatIsCutShortOrInconsistent) {
  const Bytes bytes = sample(0);
  for (size_t size = 0; size < bytes.bytes.size(); ++size) {
    Graph graph;
    EXPECT_FALSE(parse_graph(bytes.bytes.data(), size, graph)) << size;
  }
  const Bytes wrong_node = sample(1);
  Graph graph;
  EXPECT_FALSE(parse_graph(wrong_node.bytes.data(), wrong_node.bytes.size(), graph));
}

}  // namespace
}  // namespace ros2wasm
