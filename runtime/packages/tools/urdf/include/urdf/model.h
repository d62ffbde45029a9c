// A robot as its description (URDF) tells: links, joints, materials, and the link at the root.
#pragma once

#include <memory>
#include <string>

#include "urdf/visibility_control.hpp"
#include "urdf_model/joint.h"
#include "urdf_model/link.h"
#include "urdf_model/model.h"
#include "urdf_world/types.h"

namespace urdf {

/// The init functions are false, with a line on standard error, when the description is none of a
/// tree of links; the model is empty then.
class Model : public ModelInterface {
 public:
  bool initFile(const std::string& filename);
  bool initString(const std::string& xmlstring);
};

typedef std::shared_ptr<Model> ModelSharedPtr;
typedef std::shared_ptr<const Model> ModelConstSharedPtr;

}  // namespace urdf
