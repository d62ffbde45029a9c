// See particle_filter.hpp.
#include "nav2_amcl/pf/particle_filter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "nav2_amcl/pf/pf_pdf.hpp"

namespace nav2_amcl {
namespace {

constexpr double kConvergedWithin = 0.5;  // m

/// Draws from a normal distribution in the plane: its axes are those of the covariance.
class NormalPoses {
 public:
  NormalPoses(const pf_vector_t& mean, const pf_matrix_t& covariance)
      : mean_(mean), yaw_deviation_(deviation_of(covariance.m[2][2])) {
    const double xx = covariance.m[0][0];
    const double yy = covariance.m[1][1];
    const double xy = (covariance.m[0][1] + covariance.m[1][0]) / 2;
    const double angle = std::atan2(2 * xy, xx - yy) / 2;
    const double middle = (xx + yy) / 2;
    const double radius = std::hypot((xx - yy) / 2, xy);
    cos_ = std::cos(angle);
    sin_ = std::sin(angle);
    long_deviation_ = deviation_of(middle + radius);
    short_deviation_ = deviation_of(middle - radius);
  }

  pf_vector_t draw(Random& random) const {
    const double along = long_deviation_ * random.gaussian();
    const double across = short_deviation_ * random.gaussian();
    return {{mean_.v[0] + along * cos_ - across * sin_, mean_.v[1] + along * sin_ + across * cos_,
             mean_.v[2] + yaw_deviation_ * random.gaussian()}};
  }

 private:
  static double deviation_of(double variance) { return std::sqrt(std::max(variance, 0.0)); }

  pf_vector_t mean_;
  double yaw_deviation_;
  double cos_ = 1.0;
  double sin_ = 0.0;
  double long_deviation_ = 0.0;
  double short_deviation_ = 0.0;
};

/// Sums from which a PoseEstimate is made.
class PoseSums {
 public:
  void add(const pf_sample_t& sample) {
    const double w = sample.weight;
    const auto& p = sample.pose.v;
    weight_ += w;
    x_ += w * p[0];
    y_ += w * p[1];
    cos_ += w * std::cos(p[2]);
    sin_ += w * std::sin(p[2]);
    xx_ += w * p[0] * p[0];
    xy_ += w * p[0] * p[1];
    yy_ += w * p[1] * p[1];
  }

  PoseEstimate estimate() const {
    PoseEstimate result;
    result.weight = weight_;
    const double x = x_ / weight_;
    const double y = y_ / weight_;
    result.mean = {{x, y, std::atan2(sin_, cos_)}};
    result.covariance.m[0][0] = xx_ / weight_ - x * x;
    result.covariance.m[0][1] = result.covariance.m[1][0] = xy_ / weight_ - x * y;
    result.covariance.m[1][1] = yy_ / weight_ - y * y;
    // The variance of a wrapped normal distribution with this length of the mean direction.
    result.covariance.m[2][2] = -2 * std::log(std::hypot(cos_, sin_) / weight_);
    return result;
  }

 private:
  double weight_ = 0.0;
  double x_ = 0.0;
  double y_ = 0.0;
  double cos_ = 0.0;
  double sin_ = 0.0;
  double xx_ = 0.0;
  double xy_ = 0.0;
  double yy_ = 0.0;
};

/// Draws particles with a chance that is proportional to their weights.
class WeightedDraw {
 public:
  explicit WeightedDraw(const Particles& from) : from_(from) {
    sums_.reserve(from.size());
    double sum = 0.0;
    for (const pf_sample_t& particle : from) sums_.push_back(sum += particle.weight);
  }

  const pf_vector_t& draw(Random& random) const {
    const double at = random.uniform() * sums_.back();
    const auto found = std::upper_bound(sums_.begin(), sums_.end(), at);
    const auto index = std::min<std::ptrdiff_t>(found - sums_.begin(),
                                                static_cast<std::ptrdiff_t>(from_.size()) - 1);
    return from_[static_cast<size_t>(index)].pose;
  }

 private:
  const Particles& from_;
  std::vector<double> sums_;
};

void set_equal_weights(Particles& particles) {
  const double weight = 1.0 / static_cast<double>(particles.size());
  for (pf_sample_t& particle : particles) particle.weight = weight;
}

double sum_of_weights(const Particles& particles) {
  double sum = 0.0;
  for (const pf_sample_t& particle : particles) sum += particle.weight;
  return sum;
}

}  // namespace

int particles_needed(const FilterSettings& settings, size_t bins) {
  if (bins <= 1) return settings.max_particles;
  const auto freedom = static_cast<double>(bins - 1);
  const double b = 2 / (9 * freedom);
  const double root = 1 - b + std::sqrt(b) * settings.z;
  const double needed = std::ceil(freedom / (2 * settings.error) * root * root * root);
  // Not clamp(): an error of 0 gives no number, and then the most particles.
  if (needed < settings.min_particles) return settings.min_particles;
  return needed <= settings.max_particles ? static_cast<int>(needed) : settings.max_particles;
}

ParticleFilter::ParticleFilter(const FilterSettings& settings, Random& random)
    : settings_(settings), random_(random) {}

void ParticleFilter::reset(const pf_vector_t& mean, const pf_matrix_t& covariance) {
  const NormalPoses poses(mean, covariance);
  reset([&poses](Random& random) { return poses.draw(random); });
}

void ParticleFilter::reset(const MakePose& make_pose) {
  particles_.assign(static_cast<size_t>(std::max(settings_.max_particles, 0)), pf_sample_t{});
  bins_.clear();
  for (pf_sample_t& particle : particles_) {
    particle.pose = make_pose(random_);
    bins_.insert(particle.pose);
  }
  set_equal_weights(particles_);
  slow_average_ = fast_average_ = 0.0;
  is_converged_ = false;
  estimate();
}

void ParticleFilter::move(MotionModel& model, const pf_vector_t& pose, const pf_vector_t& delta) {
  const RandomSource source(random_);
  pf_t view{};
  view.sets[0] = {static_cast<int>(particles_.size()), particles_.data()};
  model.odometryUpdate(&view, pose, delta);
}

void ParticleFilter::measure(const WeighParticles& weigh) {
  if (particles_.empty() || !weigh(particles_, is_converged_)) return;
  const double total = sum_of_weights(particles_);
  if (!(total > 0.0)) {
    set_equal_weights(particles_);
    return;
  }
  for (pf_sample_t& particle : particles_) particle.weight /= total;
  const double average = total / static_cast<double>(particles_.size());
  const auto follow = [average](double& value, double alpha) {
    value = value == 0.0 ? average : value + alpha * (average - value);
  };
  follow(slow_average_, settings_.alpha_slow);
  follow(fast_average_, settings_.alpha_fast);
}

double ParticleFilter::share_of_random_poses() const {
  return slow_average_ > 0.0 ? std::max(0.0, 1.0 - fast_average_ / slow_average_) : 0.0;
}

void ParticleFilter::resample(const MakePose& make_pose) {
  if (particles_.empty()) return;
  const WeightedDraw weighted(particles_);
  const double share = share_of_random_poses();
  Particles drawn;
  bins_.clear();
  while (drawn.size() < static_cast<size_t>(settings_.max_particles)) {
    const bool is_random = random_.uniform() < share && make_pose;
    drawn.push_back({is_random ? make_pose(random_) : weighted.draw(random_), 0.0});
    bins_.insert(drawn.back().pose);
    if (drawn.size() > static_cast<size_t>(particles_needed(settings_, bins_.count()))) break;
  }
  // Else ever more random poses would follow.
  if (share > 0.0) slow_average_ = fast_average_ = 0.0;
  set_equal_weights(drawn);
  particles_ = std::move(drawn);
  estimate();
  check_convergence();
}

void ParticleFilter::estimate() {
  clusters_.clear();
  whole_ = {};
  if (particles_.empty()) return;
  std::vector<PoseSums> sums(static_cast<size_t>(bins_.find_clusters()));
  PoseSums all;
  for (const pf_sample_t& particle : particles_) {
    sums[static_cast<size_t>(bins_.cluster_of(particle.pose))].add(particle);
    all.add(particle);
  }
  for (const PoseSums& each : sums) clusters_.push_back(each.estimate());
  whole_ = all.estimate();
}

const PoseEstimate* ParticleFilter::best_cluster() const {
  const auto best = std::max_element(
      clusters_.begin(), clusters_.end(),
      [](const PoseEstimate& a, const PoseEstimate& b) { return a.weight < b.weight; });
  return best == clusters_.end() ? nullptr : &*best;
}

void ParticleFilter::check_convergence() {
  double x = 0.0;
  double y = 0.0;
  for (const pf_sample_t& particle : particles_) {
    x += particle.pose.v[0];
    y += particle.pose.v[1];
  }
  x /= static_cast<double>(particles_.size());
  y /= static_cast<double>(particles_.size());
  is_converged_ =
      std::all_of(particles_.begin(), particles_.end(), [x, y](const pf_sample_t& particle) {
        return std::abs(particle.pose.v[0] - x) <= kConvergedWithin &&
               std::abs(particle.pose.v[1] - y) <= kConvergedWithin;
      });
}

}  // namespace nav2_amcl
