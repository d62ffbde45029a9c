// Prints what it hears on /chatter until a stop is requested.
#include <stdio.h>

#include "ros2wasm/host.h"

int main(void) {
  static const char topic[] = "/chatter", type[] = "std_msgs/msg/String";
  int32_t node = ros2wasm_node_create("listener", 8, "/", 1);
  struct ros2wasm_endpoint_desc desc = {
      .kind = 2, .node = (uint32_t)node, .name = (uint32_t)topic, .name_len = sizeof topic - 1,
      .type = (uint32_t)type, .type_len = sizeof type - 1,
      .reliability = 1, .durability = 2, .history = 1, .depth = 10, .liveliness = 1};
  int32_t subscription = ros2wasm_endpoint_create(&desc);
  if (subscription < 0) return 3;
  for (;;) {
    int32_t token = ros2wasm_wake_token();
    unsigned char buffer[256];
    struct ros2wasm_sample_info info;
    int32_t length;
    while ((length = ros2wasm_take(subscription, buffer, sizeof buffer, &info)) >= 0) {
      printf("I heard: [%s] after %d\n", buffer + 8, ros2wasm_matched(subscription));
    }
    fflush(stdout);
    if (ros2wasm_wait(token, -1) == 2) return 0;
  }
}
