// See camera.hpp. First it is found out which triangle each pixel shows, then each pixel is
// coloured once. Edges and depths are linear in the picture (homogeneous rasterization), so that
// triangles that reach behind the camera need no clipping.
#include "render/camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/lighting.hpp"

namespace ros2wasm_sim {
namespace {

constexpr std::uint32_t kNothing = 0xffffffff;

/// A function of the column x and the row y of a pixel: a x + b y + c.
struct Linear {
  double a = 0, b = 0, c = 0;
  double at(double x, double y) const { return a * x + b * y + c; }
};

/// Rows of a rotation and a translation.
struct Transform {
  double rows[3][3];
  Vector3 offset;

  explicit Transform(const Pose& pose) : offset(pose.position) {
    const Vector3 x = rotate(pose.orientation, {1, 0, 0}), y = rotate(pose.orientation, {0, 1, 0}),
                  z = rotate(pose.orientation, {0, 0, 1});
    const double all[3][3] = {{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}};
    std::copy(&all[0][0], &all[0][0] + 9, &rows[0][0]);
  }
  Vector3 turn(double x, double y, double z) const {
    return {rows[0][0] * x + rows[0][1] * y + rows[0][2] * z,
            rows[1][0] * x + rows[1][1] * y + rows[1][2] * z,
            rows[2][0] * x + rows[2][1] * y + rows[2][2] * z};
  }
  Vector3 apply(const float* p) const { return turn(p[0], p[1], p[2]) + offset; }
};

/// From the axes of a body (x forward, z up) to those of a picture (x right, y down, z forward).
Vector3 optical(const Vector3& v) {
  return {-v.y, -v.z, v.x};
}

struct Bounds {
  int left, right, top, bottom;  ///< pixels, the last ones included
};

/// A triangle that may be seen.
struct Seen {
  const Item* item;
  const Corner* corners;
  std::uint32_t placed;  ///< of the item
  bool from_behind;
  std::array<Linear, 3> edges;  ///< the share of each corner, times 1 / depth and a factor
  bool is_even = false;         ///< one colour all over
  std::array<std::uint8_t, 3> color{};
};

/// The texel at a place of a texture that repeats, between the four nearest pixels.
Vector3 texel(const Picture& picture, double u, double v) {
  const double x = (u - std::floor(u)) * picture.width - 0.5;
  const double y = (v - std::floor(v)) * picture.height - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  const auto wrapped = [](double value, int size) {
    const int whole = static_cast<int>(value);
    return whole < 0 ? whole + size : whole >= size ? whole - size : whole;
  };
  const auto at = [&](double column, double row) {
    const std::uint8_t* rgb =
        &picture.rgb[3 * (std::size_t{1} * wrapped(row, picture.height) * picture.width +
                          wrapped(column, picture.width))];
    return Vector3{rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0};
  };
  const double fx = x - left, fy = y - top;
  return (1 - fy) * ((1 - fx) * at(left, top) + fx * at(left + 1, top)) +
         fy * ((1 - fx) * at(left, top + 1) + fx * at(left + 1, top + 1));
}

std::uint8_t byte_of(double value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0, 1.0) * 255 + 0.5);
}

}  // namespace

class Camera::Work {
 public:
  explicit Work(const Lens& lens)
      : lens_(lens),
        nearness_(std::size_t{1} * lens.width * lens.height),
        shown_(nearness_.size()) {}

  void begin(const Pose& pose) {
    pose_ = pose;
    std::fill(nearness_.begin(), nearness_.end(), static_cast<float>(1 / lens_.far));
    forget();
  }

  /// Later ones are only seen in front of what is there already.
  void forget() {
    seen_.clear();
    placed_.clear();
    std::fill(shown_.begin(), shown_.end(), kNothing);
  }

  void place(RenderScene& scene, bool transparent) {
    const Pose view = inverse(pose_);
    for (const Item& item : scene.items()) {
      if (item.is_transparent() != transparent) continue;
      const Pose pose = scene.pose(item);
      const Pose in_view = view * pose;
      if (!may_be_seen(in_view * Pose{item.middle, {}}, item.radius)) continue;
      placed_.emplace_back(pose);
      const Transform to_camera(in_view);
      const Triangles& triangles = *item.triangles;
      for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
        add_triangle(item, &triangles[i], to_camera);
    }
  }

  void color(const RenderScene& scene, Picture& picture) {
    const Lighting lighting(scene);
    for (Seen& one : seen_) find_even_color(one, lighting);
    std::uint8_t* rgb = picture.rgb.data();
    std::size_t pixel = 0;
    for (int y = 0; y < lens_.height; ++y)
      for (int x = 0; x < lens_.width; ++x, ++pixel, rgb += 3) {
        if (shown_[pixel] == kNothing) continue;
        const Seen& one = seen_[shown_[pixel]];
        const double alpha = one.item->look.diffuse.a;
        std::array<std::uint8_t, 3> color = one.color;
        if (!one.is_even) color = color_at(one, lighting, x, y, pixel);
        for (int c = 0; c < 3; ++c) rgb[c] = alpha >= 1 ? color[c] : mixed(rgb[c], color[c], alpha);
      }
  }

  float nearness(std::size_t pixel) const { return nearness_[pixel]; }

 private:
  static std::uint8_t mixed(std::uint8_t behind, std::uint8_t before, double alpha) {
    return static_cast<std::uint8_t>(behind + alpha * (before - behind) + 0.5);
  }

  /// Whether a sphere reaches into what the camera sees.
  bool may_be_seen(const Pose& middle, double radius) const {
    const Vector3 p = optical(middle.position);
    if (p.z + radius < lens_.near || p.z - radius > lens_.far) return false;
    const auto outside = [&](double focal, double offset, double along) {
      return focal * along + offset * p.z < -radius * std::hypot(focal, offset);
    };
    return !(outside(lens_.fx, lens_.cx, p.x) || outside(-lens_.fx, lens_.width - lens_.cx, p.x) ||
             outside(lens_.fy, lens_.cy, p.y) || outside(-lens_.fy, lens_.height - lens_.cy, p.y));
  }

  /// The same function of a pixel that `v` is of a ray (right, down, forward).
  Linear of_pixels(const Vector3& v) const {
    return {v.x / lens_.fx, v.y / lens_.fy,
            v.z - v.x * lens_.cx / lens_.fx - v.y * lens_.cy / lens_.fy};
  }

  /// Around the part in front of the camera; false when nothing of it is in the picture.
  bool bounds_of(const std::array<Vector3, 3>& p, Bounds& bounds) const {
    double left = kInfinity, right = -kInfinity, top = kInfinity, bottom = -kInfinity;
    const auto include = [&](const Vector3& one) {
      const double x = lens_.fx * one.x / one.z + lens_.cx;
      const double y = lens_.fy * one.y / one.z + lens_.cy;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    };
    for (int i = 0; i < 3; ++i) {
      const Vector3& a = p[i];
      const Vector3& b = p[(i + 1) % 3];
      if (a.z >= lens_.near) include(a);
      if ((a.z >= lens_.near) != (b.z >= lens_.near)) {
        const double share = (lens_.near - a.z) / (b.z - a.z);
        const Vector3 between = a + share * (b - a);
        include({between.x, between.y, lens_.near});
      }
    }
    // A pixel more on each side, as the middle of a pixel counts and edges are rounded.
    const auto limited = [](double value, int size) {
      return static_cast<int>(std::clamp(value, -2.0, size + 2.0));
    };
    if (!(left <= right)) return false;
    bounds = {std::max(0, limited(std::floor(left) - 1, lens_.width)),
              std::min(lens_.width - 1, limited(std::ceil(right), lens_.width)),
              std::max(0, limited(std::floor(top) - 1, lens_.height)),
              std::min(lens_.height - 1, limited(std::ceil(bottom), lens_.height))};
    return bounds.left <= bounds.right && bounds.top <= bounds.bottom;
  }

  void add_triangle(const Item& item, const Corner* corners, const Transform& to_camera) {
    std::array<Vector3, 3> p;
    for (int i = 0; i < 3; ++i) p[i] = optical(to_camera.apply(corners[i].position));
    Bounds bounds;
    if (!bounds_of(p, bounds)) return;
    const Vector3 normal = cross(p[1] - p[0], p[2] - p[0]);
    const double volume = dot(normal, p[0]);
    if (std::abs(volume) < 1e-12 * length(normal)) return;  // seen along its plane
    Seen seen{&item, corners, static_cast<std::uint32_t>(placed_.size() - 1), volume > 0, {}};
    // Neighbours have the same edge with the opposite sign, to the bit, so there is no gap.
    for (int i = 0; i < 3; ++i) {
      seen.edges[i] = of_pixels(cross(p[(i + 1) % 3], p[(i + 2) % 3]));
      if (volume < 0) seen.edges[i] = {-seen.edges[i].a, -seen.edges[i].b, -seen.edges[i].c};
    }
    const Linear nearness = of_pixels((1 / volume) * normal);
    const auto id = static_cast<std::uint32_t>(seen_.size());
    bool is_shown = false;
    for (int y = bounds.top; y <= bounds.bottom; ++y) {
      int from = bounds.left, to = bounds.right;
      if (row_of(seen.edges, y + 0.5, from, to)) is_shown |= fill(nearness, y, from, to, id);
    }
    if (is_shown) seen_.push_back(seen);
  }

  /// Narrows a row to the pixels whose middle is inside of all edges.
  static bool row_of(const std::array<Linear, 3>& edges, double y, int& from, int& to) {
    for (const Linear& edge : edges) {
      const double rest = edge.b * y + edge.c;
      if (edge.a == 0) {
        if (rest < 0) return false;
        continue;
      }
      const double meets = -rest / edge.a - 0.5;
      if (edge.a > 0 && meets > from) from = static_cast<int>(std::min(std::ceil(meets), to + 1.0));
      if (edge.a < 0 && meets < to) to = static_cast<int>(std::max(std::floor(meets), from - 1.0));
      if (from > to) return false;
    }
    return true;
  }

  bool fill(const Linear& nearness, int y, int from, int to, std::uint32_t id) {
    float* near = &nearness_[std::size_t{1} * y * lens_.width];
    std::uint32_t* shown = &shown_[std::size_t{1} * y * lens_.width];
    const auto slope = static_cast<float>(nearness.a);
    const auto start = static_cast<float>(nearness.at(from + 0.5, y + 0.5));
    const auto nearest = static_cast<float>(1 / lens_.near);
    bool is_shown = false;
    for (int x = from; x <= to; ++x) {
      const float value = start + slope * static_cast<float>(x - from);
      if (!(value > near[x]) || value > nearest) continue;
      near[x] = value;
      shown[x] = id;
      is_shown = true;
    }
    return is_shown;
  }

  Vector3 world_normal(const Seen& one, const Vector3& in_item) const {
    const Vector3 n = placed_[one.placed].turn(in_item.x, in_item.y, in_item.z);
    return (one.from_behind ? -1.0 : 1.0) / length(n) * n;
  }

  void find_even_color(Seen& one, const Lighting& lighting) const {
    const Corner* c = one.corners;
    for (int i = 1; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        if (c[i].normal[k] != c[0].normal[k]) return;
    if (lighting.has_local() || one.item->look.texture != nullptr) return;
    one.is_even = true;
    const Vector3 normal = world_normal(one, {c->normal[0], c->normal[1], c->normal[2]});
    one.color = bytes_of(lighting.shade(one.item->look, {1, 1, 1}, {}, normal));
  }

  static std::array<std::uint8_t, 3> bytes_of(const Vector3& color) {
    return {byte_of(color.x), byte_of(color.y), byte_of(color.z)};
  }

  std::array<std::uint8_t, 3> color_at(const Seen& one, const Lighting& lighting, int column,
                                       int row, std::size_t pixel) const {
    const double x = column + 0.5, y = row + 0.5;
    double share[3], sum = 0;
    for (int i = 0; i < 3; ++i) sum += share[i] = std::max(0.0, one.edges[i].at(x, y));
    Vector3 normal;
    double u = 0, v = 0;
    for (int i = 0; i < 3; ++i) {
      share[i] /= sum;
      const Corner& c = one.corners[i];
      normal = normal + share[i] * Vector3{c.normal[0], c.normal[1], c.normal[2]};
      u += share[i] * c.u;
      v += share[i] * c.v;
    }
    const double depth = 1.0 / nearness_[pixel];
    const Vector3 in_camera{depth, -depth * (x - lens_.cx) / lens_.fx,
                            -depth * (y - lens_.cy) / lens_.fy};
    const Vector3 at = pose_.position + rotate(pose_.orientation, in_camera);
    Vector3 texel_color{1, 1, 1};
    if (const Texture* texture = one.item->look.texture.get())
      texel_color = texel(level_of(one, *texture, depth), u, v);
    return bytes_of(lighting.shade(one.item->look, texel_color, at, world_normal(one, normal)));
  }

  /// The picture whose pixels are about as large as those of the camera at this depth.
  const Picture& level_of(const Seen& one, const Texture& texture, double depth) const {
    const Corner* c = one.corners;
    const auto at = [&](int i) {
      return Vector3{c[i].position[0], c[i].position[1], c[i].position[2]};
    };
    const double area = length(cross(at(1) - at(0), at(2) - at(0)));
    const double in_texture =
        std::abs((c[1].u - c[0].u) * (c[2].v - c[0].v) - (c[2].u - c[0].u) * (c[1].v - c[0].v));
    const Picture& whole = texture.levels.front();
    const double texels = in_texture * whole.width * whole.height;
    // Texels a pixel, along one side.
    const double ratio = depth / lens_.fx * std::sqrt(texels / std::max(area, 1e-12));
    const int level = ratio > 1 ? static_cast<int>(std::log2(ratio) + 0.5) : 0;
    return texture.levels[std::min<std::size_t>(level, texture.levels.size() - 1)];
  }

  Lens lens_;
  Pose pose_;
  std::vector<float> nearness_;       ///< 1 / depth of each pixel
  std::vector<std::uint32_t> shown_;  ///< which of `seen_`
  std::vector<Seen> seen_;
  std::vector<Transform> placed_;  ///< from items to the world
};

Camera::Camera(const Lens& lens) : lens_(lens), work_(std::make_unique<Work>(lens)) {
  picture_.width = lens.width;
  picture_.height = lens.height;
  picture_.rgb.resize(std::size_t{3} * lens.width * lens.height);
}

Camera::~Camera() = default;

void Camera::draw(RenderScene& scene, const Pose& pose) {
  const Color& sky = scene.settings().background;
  const std::array<std::uint8_t, 3> color{byte_of(sky.r), byte_of(sky.g), byte_of(sky.b)};
  for (std::size_t i = 0; i < picture_.rgb.size(); ++i) picture_.rgb[i] = color[i % 3];
  draw_depth(scene, pose);
  work_->color(scene, picture_);
  work_->forget();
  work_->place(scene, true);
  work_->color(scene, picture_);
}

void Camera::draw_depth(RenderScene& scene, const Pose& pose) {
  work_->begin(pose);
  work_->place(scene, false);
}

float Camera::depth(int column, int row) const {
  const float nearness = work_->nearness(std::size_t{1} * row * lens_.width + column);
  return nearness > static_cast<float>(1 / lens_.far) ? 1 / nearness
                                                      : static_cast<float>(kInfinity);
}

}  // namespace ros2wasm_sim
