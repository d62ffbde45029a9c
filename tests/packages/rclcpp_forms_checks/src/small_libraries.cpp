// rcutils, rcpputils, class_loader, rmw and the headers of rclcpp that name small things.

// Compatibility, works: of rcutils also files, folders, splitting, string arrays, string maps, hash
// maps, array lists and sorting; of rcpputils all headers but `shared_library`;
// `MultiLibraryClassLoader`; packages that list the type support packages, rcl_action,
// rcl_lifecycle, rcl_yaml_param_parser or libstatistics_collector are built

#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "checks.hpp"
#include "class_loader/exceptions.hpp"
#include "class_loader/multi_library_class_loader.hpp"
#include "class_loader/register_macro.hpp"
#include "rclcpp/copy_all_parameter_values.hpp"
#include "rclcpp/create_generic_client.hpp"
#include "rclcpp/expand_topic_or_service_name.hpp"
#include "rclcpp/get_message_type_support_handle.hpp"
#include "rclcpp/is_ros_compatible_type.hpp"
#include "rclcpp/strategies/message_pool_memory_strategy.hpp"
#include "rclcpp/subscription_traits.hpp"
#include "rclcpp_action/qos.hpp"
#include "rcppmath/clamp.hpp"
#include "rcppmath/rolling_mean_accumulator.hpp"
#include "rcpputils/asserts.hpp"
#include "rcpputils/endian.hpp"
#include "rcpputils/find_library.hpp"
#include "rcpputils/get_env.hpp"
#include "rcpputils/process.hpp"
#include "rcpputils/unique_lock.hpp"
#include "rcutils/filesystem.h"
#include "rcutils/qsort.h"
#include "rcutils/repl_str.h"
#include "rcutils/split.h"
#include "rcutils/strerror.h"
#include "rcutils/types/array_list.h"
#include "rcutils/types/hash_map.h"
#include "rcutils/types/string_array.h"
#include "rcutils/types/string_map.h"
#include "rmw/macros.h"
#include "rmw/ret_types.h"
#include "std_msgs/msg/int32.hpp"
#include "std_msgs/msg/string.hpp"

namespace {

struct Shape {
  virtual ~Shape() = default;
  virtual int corners() const = 0;
};
struct Triangle : Shape {
  int corners() const override { return 3; }
};

std::string taken(char* text) {
  std::string result(text == nullptr ? "(null)" : text);
  free(text);
  return result;
}

int by_value(const void* a, const void* b) {
  return *static_cast<const int*>(a) - *static_cast<const int*>(b);
}

std::string joined(const rcutils_string_array_t& array) {
  std::string all;
  for (size_t i = 0; i < array.size; ++i) {
    all += std::string(array.data[i]) + "|";
  }
  return all;
}

void check_strings(Checks& checks, const rcutils_allocator_t& allocator) {
  rcutils_string_array_t parts = rcutils_get_zero_initialized_string_array();
  CHECK(rcutils_split("/a//b/c/", '/', allocator, &parts) == RCUTILS_RET_OK);
  CHECK(joined(parts) == "a|b|c|");
  CHECK(rcutils_string_array_resize(&parts, 4) == RCUTILS_RET_OK);
  parts.data[3] = strdup("0");
  CHECK(rcutils_string_array_sort(&parts) == RCUTILS_RET_OK);
  CHECK(joined(parts) == "0|a|b|c|");
  rcutils_string_array_t last = rcutils_get_zero_initialized_string_array();
  CHECK(rcutils_split_last("/a/b/c", '/', allocator, &last) == RCUTILS_RET_OK);
  CHECK(joined(last) == "a/b|c|");
  int order = 0;
  CHECK(rcutils_string_array_cmp(&parts, &last, &order) == RCUTILS_RET_OK);
  CHECK(order < 0);
  CHECK(rcutils_string_array_fini(&parts) == RCUTILS_RET_OK);
  CHECK(rcutils_string_array_fini(&last) == RCUTILS_RET_OK);
  CHECK(rcutils_split("a", ',', allocator, nullptr) == RCUTILS_RET_INVALID_ARGUMENT);
  rcutils_reset_error();
  CHECK(taken(rcutils_repl_str("one two one", "one", "1", &allocator)) == "1 two 1");
  int numbers[] = {3, 1, 2};
  CHECK(rcutils_qsort(numbers, 3, sizeof(int), by_value) == RCUTILS_RET_OK);
  CHECK(numbers[0] == 1 && numbers[1] == 2 && numbers[2] == 3);
  char reason[64];
  errno = ENOENT;
  rcutils_strerror(reason, sizeof(reason));
  CHECK(std::strstr(reason, "No such file") != nullptr);
}

void check_containers(Checks& checks, const rcutils_allocator_t& allocator) {
  rcutils_array_list_t list = rcutils_get_zero_initialized_array_list();
  CHECK(rcutils_array_list_init(&list, 2, sizeof(int), &allocator) == RCUTILS_RET_OK);
  for (int i = 0; i < 5; ++i) {
    CHECK(rcutils_array_list_add(&list, &i) == RCUTILS_RET_OK);
  }
  CHECK(rcutils_array_list_remove(&list, 1) == RCUTILS_RET_OK);
  int value = 0;
  size_t size = 0;
  CHECK(rcutils_array_list_get(&list, 1, &value) == RCUTILS_RET_OK && value == 2);
  CHECK(rcutils_array_list_get_size(&list, &size) == RCUTILS_RET_OK && size == 4);
  CHECK(rcutils_array_list_get(&list, 4, &value) != RCUTILS_RET_OK);
  rcutils_reset_error();
  CHECK(rcutils_array_list_fini(&list) == RCUTILS_RET_OK);

  rcutils_hash_map_t map = rcutils_get_zero_initialized_hash_map();
  CHECK(rcutils_hash_map_init(&map, 2, sizeof(const char*), sizeof(int),
                              rcutils_hash_map_string_hash_func, rcutils_hash_map_string_cmp_func,
                              &allocator) == RCUTILS_RET_OK);
  const char* const keys[] = {"one", "two", "three"};
  for (int i = 0; i < 3; ++i) {
    CHECK(rcutils_hash_map_set(&map, &keys[i], &i) == RCUTILS_RET_OK);
  }
  const std::string equal = "two";
  const char* same_text = equal.c_str();
  CHECK(rcutils_hash_map_get(&map, &same_text, &value) == RCUTILS_RET_OK && value == 1);
  CHECK(rcutils_hash_map_unset(&map, &same_text) == RCUTILS_RET_OK);
  CHECK(!rcutils_hash_map_key_exists(&map, &same_text));
  int seen = 0;
  const char* key = nullptr;
  rcutils_ret_t result = rcutils_hash_map_get_next_key_and_data(&map, nullptr, &key, &value);
  while (result == RCUTILS_RET_OK) {
    ++seen;
    result = rcutils_hash_map_get_next_key_and_data(&map, &key, &key, &value);
  }
  CHECK(seen == 2);
  CHECK(result == RCUTILS_RET_HASH_MAP_NO_MORE_ENTRIES);
  CHECK(rcutils_hash_map_fini(&map) == RCUTILS_RET_OK);

  rcutils_string_map_t strings = rcutils_get_zero_initialized_string_map();
  CHECK(rcutils_string_map_init(&strings, 1, allocator) == RCUTILS_RET_OK);
  CHECK(rcutils_string_map_set(&strings, "a", "1") == RCUTILS_RET_OK);
  CHECK(rcutils_string_map_set_no_resize(&strings, "b", "2") == RCUTILS_RET_NOT_ENOUGH_SPACE);
  CHECK(rcutils_string_map_set(&strings, "b", "2") == RCUTILS_RET_OK);
  CHECK(std::string(rcutils_string_map_get(&strings, "b")) == "2");
  CHECK(std::string(rcutils_string_map_getn(&strings, "banana", 1)) == "2");
  const char* const first = rcutils_string_map_get_next_key(&strings, nullptr);
  CHECK(std::string(first) == "a");
  CHECK(std::string(rcutils_string_map_get_next_key(&strings, first)) == "b");
  CHECK(rcutils_string_map_unset(&strings, "a") == RCUTILS_RET_OK);
  CHECK(!rcutils_string_map_key_exists(&strings, "a"));
  CHECK(rcutils_string_map_fini(&strings) == RCUTILS_RET_OK);
}

void check_files(Checks& checks, const rcutils_allocator_t& allocator) {
  CHECK(rcutils_mkdir("/tmp/small_libraries"));
  CHECK(rcutils_mkdir("/tmp/small_libraries/inner"));
  CHECK(!rcutils_mkdir("relative"));
  for (const char* path : {"/tmp/small_libraries/five", "/tmp/small_libraries/inner/five"}) {
    FILE* const file = fopen(path, "w");
    fputs("12345", file);
    fclose(file);
  }
  CHECK(rcutils_is_directory("/tmp/small_libraries"));
  CHECK(rcutils_is_file("/tmp/small_libraries/five"));
  CHECK(!rcutils_exists("/tmp/small_libraries/none"));
  CHECK(rcutils_is_readable_and_writable("/tmp/small_libraries/five"));
  CHECK(rcutils_get_file_size("/tmp/small_libraries/five") == 5);
  uint64_t size = 0;
  CHECK(rcutils_calculate_directory_size("/tmp/small_libraries", &size, allocator) ==
        RCUTILS_RET_OK);
  CHECK(size == 5);
  CHECK(rcutils_calculate_directory_size_with_recursion("/tmp/small_libraries", 0, &size,
                                                        allocator) == RCUTILS_RET_OK);
  CHECK(size == 10);
  CHECK(taken(rcutils_join_path("a", "b", allocator)) == "a/b");
  CHECK(taken(rcutils_expand_user("~/x", allocator)) == rcpputils::get_env_var("HOME") + "/x");
  std::vector<std::string> names;
  rcutils_dir_iter_t* const iter = rcutils_dir_iter_start("/tmp/small_libraries", allocator);
  if (iter != nullptr) {
    do {
      names.emplace_back(iter->entry_name);
    } while (rcutils_dir_iter_next(iter));
    rcutils_dir_iter_end(iter);
  }
  CHECK(std::count(names.begin(), names.end(), "five") == 1);
  CHECK(std::count(names.begin(), names.end(), "inner") == 1);
}

void check_rclcpp(Checks& checks) {
  using rclcpp::expand_topic_or_service_name;
  CHECK(expand_topic_or_service_name("~/x", "node", "/ns") == "/ns/node/x");
  CHECK(expand_topic_or_service_name("{node}/x", "node", "/") == "/node/x");
  CHECK_THROWS(rclcpp::exceptions::InvalidTopicNameError,
               expand_topic_or_service_name("a b", "node", "/ns"));
  CHECK_THROWS(rclcpp::exceptions::InvalidServiceNameError,
               expand_topic_or_service_name("a b", "node", "/ns", true));
  CHECK_THROWS(rclcpp::exceptions::InvalidNodeNameError,
               expand_topic_or_service_name("a", "n e", "/ns"));
  CHECK_THROWS(rclcpp::exceptions::InvalidNamespaceError,
               expand_topic_or_service_name("a", "node", "ns"));
  static_assert(rclcpp::is_ros_compatible_type<std_msgs::msg::String>::value);
  static_assert(!rclcpp::is_ros_compatible_type<std::string>::value);
  CHECK(&rclcpp::get_message_type_support_handle<std_msgs::msg::String>() ==
        rosidl_typesupport_cpp::get_message_type_support_handle<std_msgs::msg::String>());
  using Callback = std::function<void(std_msgs::msg::String::ConstSharedPtr)>;
  static_assert(std::is_same_v<rclcpp::subscription_traits::has_message_type<Callback>::type,
                               std_msgs::msg::String>);
  using Pool = rclcpp::strategies::message_pool_memory_strategy::MessagePoolMemoryStrategy<
      std_msgs::msg::Int32, 2>;
  Pool pool;
  auto one = pool.borrow_message();
  auto two = pool.borrow_message();
  CHECK(one != two);
  CHECK_THROWS(std::runtime_error, pool.borrow_message());
  const void* const place = one.get();
  one.reset();
  CHECK(pool.borrow_message().get() == place);

  auto from = std::make_shared<rclcpp::Node>("copied_from");
  auto to = std::make_shared<rclcpp::Node>("copied_to");
  from->declare_parameter("gain", 2.5);
  from->declare_parameter("name", "from");
  to->declare_parameter("name", "to");
  rclcpp::copy_all_parameter_values(from, to);
  CHECK(to->get_parameter("gain").as_double() == 2.5);
  CHECK(to->get_parameter("name").as_string() == "to");
  rclcpp::copy_all_parameter_values(from, to, true);
  CHECK(to->get_parameter("name").as_string() == "from");
  const rclcpp_action::DefaultActionStatusQoS qos;
  CHECK(qos.depth() == 1 && qos.durability() == rclcpp::DurabilityPolicy::TransientLocal);
  const auto graph = from->get_node_graph_interface();
  CHECK(graph->count_graph_users() == 0);
  auto event = graph->get_graph_event();
  CHECK(graph->count_graph_users() == 1);
  bool enclave = false;
  for (const auto& [name, ns, where] : graph->get_node_names_with_enclaves()) {
    enclave = enclave || (name == "copied_from" && ns == "/" && where == "/");
  }
  CHECK(enclave);
  CHECK(rcpputils::set_env_var("ROS_LOG_DIR", "/logs"));
  CHECK(rclcpp::get_log_directory() == "/logs");
  rcpputils::set_env_var("ROS_LOG_DIR", nullptr);
  CHECK(rclcpp::get_logging_directory().filename() == "log");
}

}  // namespace

CLASS_LOADER_REGISTER_CLASS(Triangle, Shape)

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("small_libraries");
  const rcutils_allocator_t allocator = rcutils_get_default_allocator();
  check_strings(checks, allocator);
  check_containers(checks, allocator);
  check_files(checks, allocator);
  check_rclcpp(checks);

  CHECK(rcppmath::clamp(5, 1, 3) == 3);
  CHECK(rcppmath::clamp(-1, 1, 3) == 1);
  rcppmath::RollingMeanAccumulator<double> mean(2);
  mean.accumulate(1);
  mean.accumulate(2);
  mean.accumulate(4);
  CHECK(mean.getRollingMean() == 3);
  CHECK(rcpputils::endian::native == rcpputils::endian::little);
  CHECK(rcpputils::filename_for_library("x") == "libx.so");
  CHECK(rcpputils::find_library_path("no_such_library").empty());
  CHECK(!rcpputils::get_executable_name().empty());
  std::mutex mutex;
  {
    const rcpputils::unique_lock<std::mutex> lock(mutex);
    CHECK(lock.owns_lock());
  }
  CHECK_THROWS(rcpputils::IllegalStateException, rcpputils::check_true(false));
  static_assert(RMW_RET_OK == 0);
  CHECK(std::string(RMW_STRINGIFY(ok)) == "ok");

  class_loader::MultiLibraryClassLoader loader(false);
  CHECK_THROWS(class_loader::LibraryLoadException, loader.loadLibrary("libnone.so"));
  CHECK_THROWS(class_loader::NoClassLoaderExistsException,
               loader.createSharedInstance<Shape>("Triangle", "libnone.so"));
  CHECK_THROWS(class_loader::CreateClassException, loader.createUniqueInstance<Shape>("Square"));
  CHECK(loader.getRegisteredLibraries().empty());
  return checks.finish();
}
