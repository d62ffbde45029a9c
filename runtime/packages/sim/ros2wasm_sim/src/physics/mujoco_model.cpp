// See mujoco_model.hpp.
#include "physics/mujoco_model.hpp"

#include <cstring>

#include "physics/physics.hpp"

namespace ros2wasm_sim {
namespace {

struct FreeFiles {
  void operator()(mjVFS* files) const {
    mj_deleteVFS(files);
    delete files;
  }
};

}  // namespace

ModelPointer compile_model(const std::string& xml) {
  std::unique_ptr<mjVFS, FreeFiles> files(new mjVFS);
  mj_defaultVFS(files.get());
  if (mj_makeEmptyFileVFS(files.get(), "world.xml", static_cast<int>(xml.size())) != 0)
    throw PhysicsError("there is not enough memory for the world");
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), "world.xml")], xml.data(), xml.size());
  char error[1000] = "";
  ModelPointer model(mj_loadXML("world.xml", files.get(), error, sizeof error));
  if (!model) throw PhysicsError(error);
  mj_freeLastXML();
  return model;
}

}  // namespace ros2wasm_sim
