// The functions that rosidl's headers declare to find the handle of one kind of type support.
#include <string.h>

#include "rosidl_runtime_c/message_type_support_struct.h"
#include "rosidl_runtime_c/service_type_support_struct.h"

const rosidl_message_type_support_t * get_message_typesupport_handle(
  const rosidl_message_type_support_t * handle, const char * identifier)
{
  return handle->func(handle, identifier);
}

const rosidl_message_type_support_t * get_message_typesupport_handle_function(
  const rosidl_message_type_support_t * handle, const char * identifier)
{
  return strcmp(handle->typesupport_identifier, identifier) == 0 ? handle : NULL;
}

const rosidl_service_type_support_t * get_service_typesupport_handle(
  const rosidl_service_type_support_t * handle, const char * identifier)
{
  return handle->func(handle, identifier);
}

const rosidl_service_type_support_t * get_service_typesupport_handle_function(
  const rosidl_service_type_support_t * handle, const char * identifier)
{
  return strcmp(handle->typesupport_identifier, identifier) == 0 ? handle : NULL;
}
