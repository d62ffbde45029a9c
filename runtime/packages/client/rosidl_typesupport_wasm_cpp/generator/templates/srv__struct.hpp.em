@# The structs of a service (request, response, event), and the one that names them.
@{
from service_events import own_headers

include_directives |= own_headers(service, 'struct')
for message in (service.request_message, service.response_message, service.event_message):
    TEMPLATE(
        'msg__struct.hpp.em', package_name=package_name, interface_path=interface_path,
        message=message, include_directives=include_directives)

space = '::'.join(service.namespaced_type.namespaces)
name = service.namespaced_type.name
}@

namespace @(space)
{

struct @(name)
{
  using Request = @(space)::@(name)_Request;
  using Response = @(space)::@(name)_Response;
  using Event = @(space)::@(name)_Event;
};

}  // namespace @(space)

