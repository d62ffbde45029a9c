@# The traits of a service and of its messages.
@{
from service_events import own_headers

include_directives |= own_headers(service, 'traits')
for message in (service.request_message, service.response_message, service.event_message):
    TEMPLATE(
        'msg__traits.hpp.em', package_name=package_name, interface_path=interface_path,
        message=message, include_directives=include_directives)

parts = service.namespaced_type.namespaced_name()
cpp = '::'.join(parts)
}@

namespace rosidl_generator_traits
{

template<> inline const char * data_type<@(cpp)>() {return "@(cpp)";}
template<> inline const char * name<@(cpp)>() {return "@('/'.join(parts))";}
@[for kind in ('has_fixed_size', 'has_bounded_size')]@
template<> struct @(kind)<@(cpp)>
  : std::bool_constant<@(kind)<@(cpp)_Request>::value && @(kind)<@(cpp)_Response>::value> {};
@[end for]@
template<> struct is_service<@(cpp)> : std::true_type {};
template<> struct is_service_request<@(cpp)_Request> : std::true_type {};
template<> struct is_service_response<@(cpp)_Response> : std::true_type {};

}  // namespace rosidl_generator_traits

