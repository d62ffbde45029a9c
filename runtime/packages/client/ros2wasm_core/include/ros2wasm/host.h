/* The functions a node program asks of its loader (module "ros2wasm"), and the structs they pass.
 * Pointers and lengths are offsets into the program's own memory; integers are little endian.
 * The loader's side is runtime/site; numbers (kinds, policies, errors) are in
 * runtime/protocol/constants.json. Nothing else may be imported from this module. */
#ifndef ROS2WASM__HOST_H_
#define ROS2WASM__HOST_H_

#include <stdint.h>

#if defined(__wasm__)
#define ROS2WASM_IMPORT(NAME) __attribute__((import_module("ros2wasm"), import_name(NAME)))
#else
#define ROS2WASM_IMPORT(NAME)
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** The parameters of `endpoint_create`. 0 in a time field means "no limit". 112 bytes. */
struct ros2wasm_endpoint_desc {
  uint32_t kind, node;
  uint32_t name, name_len; /* fully qualified and remapped */
  uint32_t type, type_len; /* "std_msgs/msg/String" */
  uint32_t hash, hash_len; /* "RIHS01_..." or empty */
  uint32_t reliability, durability, history, depth, liveliness, flags;
  uint32_t reserved0, reserved1;
  int64_t deadline_ns, lifespan_ns, lease_ns;
  int64_t reserved2[3];
};

/** The metadata of each sample that is written or taken. 64 bytes. */
struct ros2wasm_sample_info {
  uint32_t length, flags;
  int64_t sequence;            /* per writer, from 1 */
  int64_t source_timestamp_ns; /* system clock, since 1970 */
  int64_t related_sequence;    /* requests and replies, else 0 */
  uint8_t related_gid[16];     /* the client that asked */
  uint8_t writer_gid[16];
};

/** Counters of one status kind; the changes count since they were last read. 32 bytes. */
struct ros2wasm_status {
  int32_t total_count, total_change, current_count, current_change, last_policy, reserved[3];
};

ROS2WASM_IMPORT("abi_version") int32_t ros2wasm_abi_version(void);
/** Node id, or < 0. */
ROS2WASM_IMPORT("node_create")
int32_t ros2wasm_node_create(const char* name, uint32_t name_len, const char* ns, uint32_t ns_len);
ROS2WASM_IMPORT("node_destroy") void ros2wasm_node_destroy(int32_t node);
/** Endpoint id, or < 0. */
ROS2WASM_IMPORT("endpoint_create")
int32_t ros2wasm_endpoint_create(const struct ros2wasm_endpoint_desc* desc);
ROS2WASM_IMPORT("endpoint_destroy") void ros2wasm_endpoint_destroy(int32_t endpoint);
ROS2WASM_IMPORT("endpoint_gid") int32_t ros2wasm_endpoint_gid(int32_t endpoint, uint8_t out[16]);
/** 0, or < 0. `io` brings time and relation and takes the sequence number home. */
ROS2WASM_IMPORT("write")
int32_t ros2wasm_write(int32_t endpoint, const void* data, uint32_t len,
                       struct ros2wasm_sample_info* io);
/** Payload bytes; -1: nothing there. More than `capacity`: nothing was taken, ask with more room.
 */
ROS2WASM_IMPORT("take")
int32_t ros2wasm_take(int32_t endpoint, void* buffer, uint32_t capacity,
                      struct ros2wasm_sample_info* out);
/** Ids of own readers that have something; returns how many there are. */
ROS2WASM_IMPORT("ready") int32_t ros2wasm_ready(uint32_t* out_endpoints, uint32_t capacity);
/** Changes at every event for this participant. Read it before looking, then wait on it. */
ROS2WASM_IMPORT("wake_token") int32_t ros2wasm_wake_token(void);
/** 0 woken, 1 timeout, 2 stop requested. `timeout_ns` < 0: no limit. May suspend the program. */
ROS2WASM_IMPORT("wait") int32_t ros2wasm_wait(int32_t token, int64_t timeout_ns);
/** Wakes all waits of this participant. */
ROS2WASM_IMPORT("wake") void ros2wasm_wake(void);
/** Real ns that `site_ns` take at the site's speed, -1: time is held before. Returns the law's
 * version. */
ROS2WASM_IMPORT("real_timeout") int32_t ros2wasm_real_timeout(int64_t* real_ns, int64_t site_ns);
/** 0 slept, 2 stop requested. Steady time. May suspend the program. */
ROS2WASM_IMPORT("sleep") int32_t ros2wasm_sleep(int64_t duration_ns);
ROS2WASM_IMPORT("stop_requested") int32_t ros2wasm_stop_requested(void);
/** How the program reads its standard input: 0 lines, 1 keys, 2 keys and Ctrl-C too. */
ROS2WASM_IMPORT("terminal_mode") void ros2wasm_terminal_mode(int32_t mode);
/** Matched peers now; of a client: servers that are ready in both directions. */
ROS2WASM_IMPORT("matched") int32_t ros2wasm_matched(int32_t endpoint);
ROS2WASM_IMPORT("endpoint_status")
int32_t ros2wasm_endpoint_status(int32_t endpoint, int32_t status_kind,
                                 struct ros2wasm_status* out);
/** Changes with every status of an own endpoint. */
ROS2WASM_IMPORT("status_version") int32_t ros2wasm_status_version(void);
/** A sign of life of a publisher with manual liveliness. 0, or < 0. */
ROS2WASM_IMPORT("assert_liveliness") int32_t ros2wasm_assert_liveliness(int32_t endpoint);
/** Changes when nodes, endpoints or matches of the graph do. */
ROS2WASM_IMPORT("graph_version") int32_t ros2wasm_graph_version(void);
/** Size of the snapshot; larger than `capacity`: nothing was written. */
ROS2WASM_IMPORT("graph_snapshot")
int32_t ros2wasm_graph_snapshot(uint8_t* buffer, uint32_t capacity);
/** The files that the site has for programs; SPEC.md 3.4. Size; larger than `capacity`: nothing was
 * written. */
ROS2WASM_IMPORT("file_list") int32_t ros2wasm_file_list(void* buffer, uint32_t capacity);
/** The whole of one of them. Its size, or < 0: it cannot be had, or has another size. */
ROS2WASM_IMPORT("file_read")
int32_t ros2wasm_file_read(const char* path, uint32_t path_len, void* buffer, uint32_t size);
/** A file that the program has written, whole: whoever runs the site may keep it. */
ROS2WASM_IMPORT("file_give")
void ros2wasm_file_give(const char* path, uint32_t path_len, const void* data, uint32_t size);
/** The same, of any that it has closed or put in another's place. 0: not now; it may be offered
 * again. */
ROS2WASM_IMPORT("file_closed")
int32_t ros2wasm_file_closed(const char* path, uint32_t path_len, const void* data, uint32_t size);

#ifdef __cplusplus
}
#endif

#endif /* ROS2WASM__HOST_H_ */
