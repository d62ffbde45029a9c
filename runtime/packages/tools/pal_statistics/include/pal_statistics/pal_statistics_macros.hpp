// Registries by key or by node and topic, and the macros that use them.
#pragma once

#include <memory>
#include <string>

#include "pal_statistics/pal_statistics.hpp"
#include "pal_statistics/registration_utils.hpp"

constexpr char DEFAULT_STATISTICS_TOPIC[] = "pal_statistics";

namespace pal_statistics {

/// One for each key in a program; made when it is asked for first.
std::shared_ptr<StatisticsRegistry> getRegistry(const std::string& key);
/// One for each topic of a node.
template <typename NodeT>
std::shared_ptr<StatisticsRegistry> getRegistry(const std::shared_ptr<NodeT>& node,
                                                const std::string& topic);
/// Gives the registry of a key its node and topic.
template <typename NodeT>
void initializeRegistry(const std::shared_ptr<NodeT>& node, const std::string& topic,
                        const std::string& key) {
  getRegistry(key)->attach(node, topic);
}
void clearAllRegistries();

namespace detail {
std::shared_ptr<StatisticsRegistry> registry_of(const std::string& key, bool& is_new);
}

template <typename NodeT>
std::shared_ptr<StatisticsRegistry> getRegistry(const std::shared_ptr<NodeT>& node,
                                                const std::string& topic) {
  bool is_new = false;
  const std::string name = node->get_node_topics_interface()->resolve_topic_name(topic);
  auto registry = detail::registry_of(name, is_new);
  if (is_new) registry->attach(node, topic);
  return registry;
}

}  // namespace pal_statistics

#define INITIALIZE_REGISTRY(NODE, TOPIC, KEY) pal_statistics::initializeRegistry(NODE, TOPIC, KEY)
#define CLEAR_ALL_REGISTRIES() pal_statistics::clearAllRegistries()
/// KEY, ID, ENTITY, and if wanted BOOKKEEPING and ENABLED.
#define REGISTER_ENTITY(KEY, ...) \
  pal_statistics::customRegister(*pal_statistics::getRegistry(KEY), __VA_ARGS__)
/// KEY, ID, and if wanted BOOKKEEPING.
#define UNREGISTER_ENTITY(KEY, ...) \
  pal_statistics::getRegistry(KEY)->unregisterVariable(__VA_ARGS__)

/// NODE, TOPIC, ID, VARIABLE, and if wanted BOOKKEEPING.
#define REGISTER_VARIABLE(NODE, TOPIC, ...) \
  pal_statistics::customRegister(*pal_statistics::getRegistry(NODE, TOPIC), __VA_ARGS__)
#define REGISTER_VARIABLE_SIMPLE(NODE, TOPIC, VARIABLE, BOOKKEEPING) \
  REGISTER_VARIABLE(NODE, TOPIC, #VARIABLE, VARIABLE, BOOKKEEPING)
#define UNREGISTER_VARIABLE(NODE, TOPIC, ...) \
  pal_statistics::getRegistry(NODE, TOPIC)->unregisterVariable(__VA_ARGS__)

/// A key, or a node and a topic.
#define PUBLISH_STATISTICS(...) pal_statistics::getRegistry(__VA_ARGS__)->publish()
#define PUBLISH_ASYNC_STATISTICS(...) pal_statistics::getRegistry(__VA_ARGS__)->publishAsync()
#define START_PUBLISH_THREAD(...) pal_statistics::getRegistry(__VA_ARGS__)->startPublishThread()
#define PUBLISH_CUSTOM_STATISTIC(NODE, TOPIC, ID, VALUE) \
  pal_statistics::getRegistry(NODE, TOPIC)->publishCustomStatistic(ID, VALUE)
#define PUBLISH_CUSTOM_STATISTICS_MSG(NODE, TOPIC, MSG) \
  pal_statistics::getRegistry(NODE, TOPIC)->publishCustomStatistics(MSG)
