// Wait sets of the C library: arrays of pointers, filled one by one.
#include "rcl/wait.h"

#include <vector>

#include "rcl/error_handling.h"

namespace {

// The places of one kind, and how many are filled.
template <typename EntityT>
struct Places {
  std::vector<const EntityT*> entities;
  size_t used = 0;
};

rcl_ret_t refuse(const char* reason, rcl_ret_t code) {
  rcutils_set_error_state(reason, __FILE__, __LINE__);
  return code;
}

}  // namespace

struct rcl_wait_set_impl_s {
  rcl_allocator_t allocator;
  Places<rcl_subscription_t> subscriptions;
  Places<rcl_guard_condition_t> guard_conditions;
  Places<rcl_timer_t> timers;
  Places<rcl_client_t> clients;
  Places<rcl_service_t> services;
  Places<rcl_event_t> events;
};

namespace {

template <typename EntityT>
void resize(Places<EntityT>& places, size_t size, const EntityT**& data, size_t& count) {
  places.entities.assign(size, nullptr);
  places.used = 0;
  data = size == 0 ? nullptr : places.entities.data();
  count = size;
}

template <typename EntityT>
void clear(Places<EntityT>& places) {
  places.entities.assign(places.entities.size(), nullptr);
  places.used = 0;
}

template <typename EntityT>
rcl_ret_t add(rcl_wait_set_t* wait_set, Places<EntityT> rcl_wait_set_impl_t::*kind,
              const EntityT* entity, size_t* index) {
  if (wait_set == nullptr || entity == nullptr) {
    return refuse("wait set or entity argument is null", RCL_RET_INVALID_ARGUMENT);
  }
  if (wait_set->impl == nullptr) {
    return refuse("wait set is invalid", RCL_RET_WAIT_SET_INVALID);
  }
  Places<EntityT>& places = wait_set->impl->*kind;
  if (places.used == places.entities.size()) {
    return refuse("wait set is full", RCL_RET_WAIT_SET_FULL);
  }
  if (index != nullptr) {
    *index = places.used;
  }
  places.entities[places.used++] = entity;
  return RCL_RET_OK;
}

}  // namespace

extern "C" {

rcl_wait_set_t rcl_get_zero_initialized_wait_set(void) {
  return rcl_wait_set_t{};
}

bool rcl_wait_set_is_valid(const rcl_wait_set_t* wait_set) {
  return wait_set != nullptr && wait_set->impl != nullptr;
}

rcl_ret_t rcl_wait_set_init(rcl_wait_set_t* wait_set, size_t number_of_subscriptions,
                            size_t number_of_guard_conditions, size_t number_of_timers,
                            size_t number_of_clients, size_t number_of_services,
                            size_t number_of_events, rcl_context_t*, rcl_allocator_t allocator) {
  if (wait_set == nullptr) {
    return refuse("wait_set argument is null", RCL_RET_INVALID_ARGUMENT);
  }
  if (rcl_wait_set_is_valid(wait_set)) {
    return refuse("wait_set already initialized, or memory was uninitialized.",
                  RCL_RET_ALREADY_INIT);
  }
  wait_set->impl = new rcl_wait_set_impl_t{};
  wait_set->impl->allocator = allocator;
  return rcl_wait_set_resize(wait_set, number_of_subscriptions, number_of_guard_conditions,
                             number_of_timers, number_of_clients, number_of_services,
                             number_of_events);
}

rcl_ret_t rcl_wait_set_fini(rcl_wait_set_t* wait_set) {
  if (wait_set == nullptr) {
    return refuse("wait_set argument is null", RCL_RET_INVALID_ARGUMENT);
  }
  delete wait_set->impl;
  *wait_set = rcl_wait_set_t{};
  return RCL_RET_OK;
}

rcl_ret_t rcl_wait_set_get_allocator(const rcl_wait_set_t* wait_set, rcl_allocator_t* allocator) {
  if (allocator == nullptr) {
    return refuse("allocator argument is null", RCL_RET_INVALID_ARGUMENT);
  }
  if (!rcl_wait_set_is_valid(wait_set)) {
    return refuse("wait set is invalid", RCL_RET_WAIT_SET_INVALID);
  }
  *allocator = wait_set->impl->allocator;
  return RCL_RET_OK;
}

rcl_ret_t rcl_wait_set_clear(rcl_wait_set_t* wait_set) {
  if (!rcl_wait_set_is_valid(wait_set)) {
    return refuse("wait set is invalid", RCL_RET_WAIT_SET_INVALID);
  }
  rcl_wait_set_impl_t& impl = *wait_set->impl;
  clear(impl.subscriptions);
  clear(impl.guard_conditions);
  clear(impl.timers);
  clear(impl.clients);
  clear(impl.services);
  clear(impl.events);
  return RCL_RET_OK;
}

rcl_ret_t rcl_wait_set_resize(rcl_wait_set_t* wait_set, size_t subscriptions_size,
                              size_t guard_conditions_size, size_t timers_size, size_t clients_size,
                              size_t services_size, size_t events_size) {
  if (!rcl_wait_set_is_valid(wait_set)) {
    return refuse("wait set is invalid", RCL_RET_WAIT_SET_INVALID);
  }
  rcl_wait_set_impl_t& impl = *wait_set->impl;
  resize(impl.subscriptions, subscriptions_size, wait_set->subscriptions,
         wait_set->size_of_subscriptions);
  resize(impl.guard_conditions, guard_conditions_size, wait_set->guard_conditions,
         wait_set->size_of_guard_conditions);
  resize(impl.timers, timers_size, wait_set->timers, wait_set->size_of_timers);
  resize(impl.clients, clients_size, wait_set->clients, wait_set->size_of_clients);
  resize(impl.services, services_size, wait_set->services, wait_set->size_of_services);
  resize(impl.events, events_size, wait_set->events, wait_set->size_of_events);
  return RCL_RET_OK;
}

rcl_ret_t rcl_wait_set_add_subscription(rcl_wait_set_t* wait_set,
                                        const rcl_subscription_t* subscription, size_t* index) {
  return add(wait_set, &rcl_wait_set_impl_t::subscriptions, subscription, index);
}

rcl_ret_t rcl_wait_set_add_guard_condition(rcl_wait_set_t* wait_set,
                                           const rcl_guard_condition_t* guard_condition,
                                           size_t* index) {
  return add(wait_set, &rcl_wait_set_impl_t::guard_conditions, guard_condition, index);
}

rcl_ret_t rcl_wait_set_add_timer(rcl_wait_set_t* wait_set, const rcl_timer_t* timer,
                                 size_t* index) {
  return add(wait_set, &rcl_wait_set_impl_t::timers, timer, index);
}

rcl_ret_t rcl_wait_set_add_client(rcl_wait_set_t* wait_set, const rcl_client_t* client,
                                  size_t* index) {
  return add(wait_set, &rcl_wait_set_impl_t::clients, client, index);
}

rcl_ret_t rcl_wait_set_add_service(rcl_wait_set_t* wait_set, const rcl_service_t* service,
                                   size_t* index) {
  return add(wait_set, &rcl_wait_set_impl_t::services, service, index);
}

rcl_ret_t rcl_wait_set_add_event(rcl_wait_set_t* wait_set, const rcl_event_t* event,
                                 size_t* index) {
  return add(wait_set, &rcl_wait_set_impl_t::events, event, index);
}

}  // extern "C"
