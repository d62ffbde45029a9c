// See session_file.hpp.
#include "core/session_file.hpp"

#include <cstring>
#include <stdexcept>

namespace slam_toolbox {
namespace {

constexpr char kMagic[] = "R2WSLAM1";
constexpr size_t kMagicSize = sizeof kMagic - 1;

class Writer {
 public:
  template <typename T>
  void put(T value) {
    const size_t size = bytes_.size();
    bytes_.resize(size + sizeof value);
    std::memcpy(&bytes_[size], &value, sizeof value);
  }
  void put(const Pose& pose) {
    put(pose.x);
    put(pose.y);
    put(pose.yaw);
  }
  void put(const std::vector<Point>& points) {
    put(static_cast<uint32_t>(points.size()));
    for (const Point& point : points) {
      put(static_cast<float>(point.x));
      put(static_cast<float>(point.y));
    }
  }
  std::string bytes_{kMagic};
};

class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {
    if (bytes.compare(0, kMagicSize, kMagic) != 0) {
      throw std::runtime_error("the file is not a session of this slam_toolbox");
    }
  }

  template <typename T>
  T get() {
    if (bytes_.size() - at_ < sizeof(T)) throw std::runtime_error("the file ends too early");
    T value;
    std::memcpy(&value, &bytes_[at_], sizeof value);
    at_ += sizeof value;
    return value;
  }
  double number() {
    const double value = get<double>();
    if (!std::isfinite(value)) throw std::runtime_error("the file has a number that is not finite");
    return value;
  }
  Pose pose() {
    const double x = number();
    const double y = number();
    const Pose pose{x, y, number()};
    if (!is_usable(pose)) throw std::runtime_error("the file has a pose that is too far away");
    return pose;
  }
  /// A count of things that have at least so many bytes each.
  uint32_t count(size_t size) {
    const auto value = get<uint32_t>();
    if (value > (bytes_.size() - at_) / size) throw std::runtime_error("the file ends too early");
    return value;
  }
  std::vector<Point> points() {
    std::vector<Point> result(count(2 * sizeof(float)));
    for (Point& point : result) {
      point.x = get<float>();
      point.y = get<float>();
      if (!std::isfinite(point.x + point.y)) {
        throw std::runtime_error("the file has a point that is not finite");
      }
    }
    return result;
  }
  bool is_at_end() const { return at_ == bytes_.size(); }

 private:
  const std::string& bytes_;
  size_t at_ = kMagicSize;
};

}  // namespace

std::string to_bytes(const std::vector<Scan>& scans, const std::vector<Edge>& edges) {
  Writer writer;
  writer.put(static_cast<uint32_t>(scans.size()));
  for (const Scan& scan : scans) {
    writer.put(scan.time_ns);
    writer.put(scan.odometry);
    writer.put(scan.corrected);
    writer.put(scan.sensor.x);
    writer.put(scan.sensor.y);
    writer.put(scan.max_range);
    writer.put(scan.rays);
    writer.put(scan.hits);
  }
  writer.put(static_cast<uint32_t>(edges.size()));
  for (const Edge& edge : edges) {
    writer.put(static_cast<uint32_t>(edge.from));
    writer.put(static_cast<uint32_t>(edge.to));
    writer.put(edge.way);
    for (int i = 0; i < 9; ++i) writer.put(edge.information(i / 3, i % 3));
  }
  return writer.bytes_;
}

Session session_of(const std::string& bytes) {
  constexpr size_t kScanSize = 10 * sizeof(double) + 2 * sizeof(uint32_t);
  constexpr size_t kEdgeSize = 2 * sizeof(uint32_t) + 12 * sizeof(double);
  Reader reader(bytes);
  Session session;
  session.scans.resize(reader.count(kScanSize));
  for (Scan& scan : session.scans) {
    scan.time_ns = reader.get<int64_t>();
    scan.odometry = reader.pose();
    scan.corrected = reader.pose();
    scan.sensor.x = reader.number();
    scan.sensor.y = reader.number();
    scan.max_range = reader.number();
    scan.rays = reader.get<uint32_t>();
    scan.hits = reader.points();
    find_middle(scan);
  }
  session.edges.resize(reader.count(kEdgeSize));
  for (Edge& edge : session.edges) {
    const auto from = reader.get<uint32_t>();
    const auto to = reader.get<uint32_t>();
    if (from >= session.scans.size() || to >= session.scans.size() || from == to) {
      throw std::runtime_error("the file has an edge without its scans");
    }
    edge.from = static_cast<int>(from);
    edge.to = static_cast<int>(to);
    edge.way = reader.pose();
    for (int i = 0; i < 9; ++i) edge.information(i / 3, i % 3) = reader.number();
  }
  if (!reader.is_at_end()) throw std::runtime_error("the file has more than a session");
  return session;
}

}  // namespace slam_toolbox
