// Which C headers of messages a text includes.
#include "bundler/languages/c_messages.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

TEST(CMessages, HeadersThatATextIncludes) {
  const std::set<std::string> expected{"geometry_msgs/msg/transform_stamped", "nav_msgs/action/go",
                                       "std_srvs/srv/set_bool"};
  EXPECT_EQ(
      c_message_headers("#include \"geometry_msgs/msg/transform_stamped.h\"\r\n"
                        "  #  include <std_srvs/srv/detail/set_bool__struct.h>\n"
                        "#include \"geometry_msgs/msg/detail/transform_stamped__functions.h\"\n"
                        "#include \"std_msgs/msg/string.hpp\"\n"
                        "#include <msg/own.h>\n#include \"a/include/b.h\"\n"
                        "// #include \"std_msgs/msg/string.h\"\n"
                        "#include <nav_msgs/action/go.h>"),
      expected);
  EXPECT_TRUE(c_message_headers("").empty());
}

}  // namespace
}  // namespace ros2wasm
