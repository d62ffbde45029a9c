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
  const Item* item = nullptr;
  const Corner* corners = nullptr;
  std::uint32_t placed = 0;  ///< of the item
  bool from_behind = false;
  std::array<Linear, 3> edges;  ///< the share of each corner, times 1 / depth and a factor
  bool is_lit_evenly = false;   ///< the same light all over: glow and light hold
  bool is_even = false;         ///< and one colour: color holds
  Vector3 glow, light;          ///< the colour is glow + light * texel
  std::array<std::uint8_t, 3> color{};
  Linear share, u, v;  ///< of a texture: u / share and v / share are the place in it
  double texels = 0;   ///< that a pixel spans for each metre of depth
};

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
    for (Seen& one : seen_) prepare(one, lighting);
    std::uint8_t* rgb = picture.rgb.data();
    std::size_t pixel = 0;
    // Neighbours mostly show the same face, in one colour.
    std::uint32_t last = kNothing;
    std::array<std::uint8_t, 3> color{};
    for (int y = 0; y < lens_.height; ++y)
      for (int x = 0; x < lens_.width; ++x, ++pixel, rgb += 3) {
        const std::uint32_t id = shown_[pixel];
        if (id == kNothing) continue;
        if (id != last) {
          const Seen& one = seen_[id];
          if (!one.is_even || one.item->is_transparent()) {
            color_pixel(one, lighting, x, y, pixel, rgb);
            continue;
          }
          last = id;
          color = one.color;
        }
        rgb[0] = color[0];
        rgb[1] = color[1];
        rgb[2] = color[2];
      }
  }

  float nearness(std::size_t pixel) const { return nearness_[pixel]; }

 private:
  void color_pixel(const Seen& one, const Lighting& lighting, int x, int y, std::size_t pixel,
                   std::uint8_t* rgb) const {
    const double alpha = std::min(one.item->look.diffuse.a, 1.0);
    const auto color = one.is_even ? one.color : color_at(one, lighting, x, y, pixel);
    for (int c = 0; c < 3; ++c) rgb[c] = alpha < 1 ? mixed(rgb[c], color[c], alpha) : color[c];
  }

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
    Seen seen;
    seen.item = &item;
    seen.corners = corners;
    seen.placed = static_cast<std::uint32_t>(placed_.size() - 1);
    seen.from_behind = volume > 0;
    // A neighbour computes the same edge with the opposite sign and exactly the same digits, so
    // each pixel on the edge belongs to one of the two.
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

  /// Finds the values that all pixels of a triangle share.
  void prepare(Seen& one, const Lighting& lighting) const {
    const Corner* c = one.corners;
    const Look& look = one.item->look;
    if (look.texture != nullptr) prepare_texture(one);
    for (int i = 1; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        if (c[i].normal[k] != c[0].normal[k]) return;
    if (lighting.has_local()) return;
    const Vector3 normal = world_normal(one, {c->normal[0], c->normal[1], c->normal[2]});
    one.is_lit_evenly = true;
    one.glow = lighting.shade(look, {}, {}, normal);
    one.light = lighting.shade(look, {1, 1, 1}, {}, normal) - one.glow;
    one.is_even = look.texture == nullptr;
    one.color = bytes_of(one.glow + one.light);
  }

  void prepare_texture(Seen& one) const {
    const Corner* c = one.corners;
    for (int i = 0; i < 3; ++i) {
      add(one.share, one.edges[i], 1);
      add(one.u, one.edges[i], c[i].u);
      add(one.v, one.edges[i], c[i].v);
    }
    const auto at = [&](int i) {
      return Vector3{c[i].position[0], c[i].position[1], c[i].position[2]};
    };
    const double area = length(cross(at(1) - at(0), at(2) - at(0)));
    const double in_texture =
        std::abs((c[1].u - c[0].u) * (c[2].v - c[0].v) - (c[2].u - c[0].u) * (c[1].v - c[0].v));
    const Picture& whole = one.item->look.texture->whole();
    one.texels =
        std::sqrt(in_texture * whole.width * whole.height / std::max(area, 1e-12)) / lens_.fx;
  }

  static void add(Linear& sum, const Linear& one, double factor) {
    sum.a += factor * one.a;
    sum.b += factor * one.b;
    sum.c += factor * one.c;
  }

  Vector3 texel_at(const Seen& one, double x, double y, double depth) const {
    const double share = one.share.at(x, y);
    const Texture& texture = *one.item->look.texture;
    return texture.at(one.u.at(x, y) / share, one.v.at(x, y) / share, depth * one.texels);
  }

  static std::array<std::uint8_t, 3> bytes_of(const Vector3& color) {
    return {byte_of(color.x), byte_of(color.y), byte_of(color.z)};
  }

  std::array<std::uint8_t, 3> color_at(const Seen& one, const Lighting& lighting, int column,
                                       int row, std::size_t pixel) const {
    const double x = column + 0.5, y = row + 0.5, depth = 1.0 / nearness_[pixel];
    Vector3 own{1, 1, 1};
    if (one.item->look.texture != nullptr) own = texel_at(one, x, y, depth);
    if (one.is_lit_evenly)
      return bytes_of(one.glow +
                      Vector3{one.light.x * own.x, one.light.y * own.y, one.light.z * own.z});
    Vector3 normal;  // longer than 1, which world_normal() mends
    for (int i = 0; i < 3; ++i) {
      const float* n = one.corners[i].normal;
      normal = normal + std::max(0.0, one.edges[i].at(x, y)) * Vector3{n[0], n[1], n[2]};
    }
    const Vector3 in_camera{depth, -depth * (x - lens_.cx) / lens_.fx,
                            -depth * (y - lens_.cy) / lens_.fy};
    const Vector3 at = pose_.position + rotate(pose_.orientation, in_camera);
    return bytes_of(lighting.shade(one.item->look, own, at, world_normal(one, normal)));
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
  const auto row = picture_.rgb.begin() + std::ptrdiff_t{3} * lens_.width;
  for (auto at = picture_.rgb.begin(); at != row; at += 3)
    std::copy(color.begin(), color.end(), at);
  for (auto at = row; at != picture_.rgb.end(); at += row - picture_.rgb.begin())
    std::copy(picture_.rgb.begin(), row, at);
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
