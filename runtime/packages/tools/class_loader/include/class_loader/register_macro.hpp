// CLASS_LOADER_REGISTER_CLASS(Derived, Base), once per class, in a source file. The build of a
// library of classes defines CLASS_LOADER_LIBRARY, its file name.
#pragma once

#include "class_loader/class_loader.hpp"

#ifndef CLASS_LOADER_LIBRARY
#define CLASS_LOADER_LIBRARY ""
#endif

#define CLASS_LOADER_JOIN_(A, B) A##B
#define CLASS_LOADER_REGISTRAR_(Derived, Base, ID)                                           \
  namespace {                                                                                \
  const ::class_loader::impl::Registrar<Derived, Base> CLASS_LOADER_JOIN_(g_registrar_, ID){ \
      #Derived, CLASS_LOADER_LIBRARY};                                                       \
  }
#define CLASS_LOADER_REGISTER_CLASS_WITH_ID_(Derived, Base, ID) \
  CLASS_LOADER_REGISTRAR_(Derived, Base, ID)
#define CLASS_LOADER_REGISTER_CLASS(Derived, Base) \
  CLASS_LOADER_REGISTER_CLASS_WITH_ID_(Derived, Base, __COUNTER__)
#define CLASS_LOADER_REGISTER_CLASS_WITH_MESSAGE(Derived, Base, Message) \
  CLASS_LOADER_REGISTER_CLASS(Derived, Base)
