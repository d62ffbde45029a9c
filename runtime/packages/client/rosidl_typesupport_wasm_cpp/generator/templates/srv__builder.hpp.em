@# The builders of a service's messages.
@{
for message in (service.request_message, service.response_message, service.event_message):
    TEMPLATE(
        'msg__builder.hpp.em', package_name=package_name, interface_path=interface_path,
        message=message, include_directives=include_directives)
}@
