// Publishes "Hello World: <n>" every 20 ms, as CDR, until a stop is requested.
#include <stdio.h>
#include <string.h>

#include "ros2wasm/host.h"

int main(void) {
  static const char topic[] = "/chatter", type[] = "std_msgs/msg/String";
  int32_t node = ros2wasm_node_create("talker", 6, "/", 1);
  struct ros2wasm_endpoint_desc desc = {
      .kind = 1, .node = (uint32_t)node, .name = (uint32_t)topic, .name_len = sizeof topic - 1,
      .type = (uint32_t)type, .type_len = sizeof type - 1,
      .reliability = 1, .durability = 2, .history = 1, .depth = 10, .liveliness = 1};
  int32_t publisher = ros2wasm_endpoint_create(&desc);
  if (publisher < 0) return 3;
  for (int n = 1; !ros2wasm_stop_requested(); ++n) {
    unsigned char buffer[64] = {0, 1, 0, 0};
    int length = sprintf((char*)buffer + 8, "Hello World: %d", n) + 1;
    memcpy(buffer + 4, &length, 4);
    struct ros2wasm_sample_info info = {0};
    if (ros2wasm_write(publisher, buffer, 8 + (uint32_t)length, &info) != 0) return 4;
    fprintf(stderr, "Publishing: '%s' as %lld\n", buffer + 8, (long long)info.sequence);
    if (ros2wasm_sleep(20000000) == 2) break;
  }
  puts("talker stops");
  return 0;
}
