// Groot asks for trees by sockets, which a browser has not: it is told nothing here.
#pragma once

#include <cstdio>

#include "behaviortree_cpp/bt_factory.h"

namespace BT {

class Groot2Publisher {
 public:
  explicit Groot2Publisher(const Tree& /*tree*/, unsigned /*server_port*/ = 1667) {
    std::fputs("Groot cannot see this tree: a browser has no sockets.\n", stderr);
  }
};
/// That of version 3.
class PublisherZMQ {
 public:
  explicit PublisherZMQ(const Tree& /*tree*/, unsigned /*max_msg_per_second*/ = 25,
                        unsigned /*publisher_port*/ = 1666, unsigned /*server_port*/ = 1667) {
    std::fputs("Groot cannot see this tree: a browser has no sockets.\n", stderr);
  }
};

}  // namespace BT
