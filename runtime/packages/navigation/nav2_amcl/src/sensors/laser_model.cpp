// See laser_model.hpp.
#include "nav2_amcl/sensors/laser_model.hpp"

#include <algorithm>
#include <utility>

#include "laser_models.hpp"

namespace nav2_amcl {

LaserModel::LaserModel(const LaserSettings& settings, std::shared_ptr<const OccupancyMap> map,
                       const pf_vector_t& laser_pose)
    : settings_(settings), map_(std::move(map)), laser_pose_(laser_pose) {}

bool LaserModel::weigh(const LaserData& data, Particles& particles, bool is_converged) {
  if (settings_.max_beams < 2) return false;
  weigh_beams(data, particles, is_converged);
  return true;
}

size_t LaserModel::step_of(const LaserData& data) const {
  if (data.beams.empty()) return 1;
  return std::max<size_t>(1,
                          (data.beams.size() - 1) / static_cast<size_t>(settings_.max_beams - 1));
}

std::unique_ptr<LaserModel> make_laser_model(const std::string& type, const LaserSettings& settings,
                                             const std::shared_ptr<OccupancyMap>& map,
                                             const pf_vector_t& laser_pose) {
  if (type == "beam") return std::make_unique<BeamModel>(settings, map, laser_pose);
  map->measure_distances(settings.likelihood_max_dist);
  if (type == "likelihood_field_prob") {
    return std::make_unique<LikelihoodFieldModelProb>(settings, map, laser_pose);
  }
  return std::make_unique<LikelihoodFieldModel>(settings, map, laser_pose);
}

}  // namespace nav2_amcl
