// Registers destructors that run when the program or a thread ends. In WebAssembly a destructor
// returns its object; the C++ runtime calls it as a function that returns nothing, which
// WebAssembly refuses. Mostly the compiler writes a function of the right type that takes no
// object, but for a temporary that a static or thread_local reference is bound to it passes the
// destructor itself.

#include <new>

namespace {

using Destructor = void* (*)(void*);
using Farewell = void (*)(void*);

struct Ending {
  Destructor destructor;
  void* object;
};

void end(void* ending) {
  const Ending known = *static_cast<Ending*>(ending);
  delete static_cast<Ending*>(ending);
  known.destructor(known.object);
}

// atexit() of the C library has no module; what the compiler wrote has no object.
bool is_destructor(const void* object, const void* module) {
  return object != nullptr && module != nullptr;
}

int registered(int (*real)(Farewell, void*, void*), Farewell farewell, void* object, void* module) {
  if (!is_destructor(object, module)) {
    return real(farewell, object, module);
  }
  auto* ending = new (std::nothrow) Ending{reinterpret_cast<Destructor>(farewell), object};
  return ending == nullptr ? -1 : real(&end, ending, module);
}

}  // namespace

extern "C" {

int __real___cxa_atexit(Farewell farewell, void* object, void* module);
int __wrap___cxa_atexit(Farewell farewell, void* object, void* module) {
  return registered(&__real___cxa_atexit, farewell, object, module);
}

int __real___cxa_thread_atexit(Farewell farewell, void* object, void* module);
int __wrap___cxa_thread_atexit(Farewell farewell, void* object, void* module) {
  return registered(&__real___cxa_thread_atexit, farewell, object, module);
}

}  // extern "C"
