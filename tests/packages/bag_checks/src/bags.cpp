// What bags can do beside what the tutorials show: several files, filters, orders, snapshots,
// metadata, errors.
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "checks.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "rosbag2_cpp/info.hpp"
#include "rosbag2_cpp/reader.hpp"
#include "rosbag2_cpp/readers/sequential_reader.hpp"
#include "rosbag2_cpp/writer.hpp"
#include "rosbag2_storage/metadata_io.hpp"
#include "rosbag2_storage/qos.hpp"
#include "rosbag2_storage/ros_helper.hpp"
#include "std_msgs/msg/string.hpp"

namespace {

using rosbag2_storage::StorageOptions;
using std_msgs::msg::String;

constexpr int64_t kSecond = 1000000000;
constexpr int64_t kBegin = 1700000000 * kSecond;

String text(const std::string& data) {
  String message;
  message.data = data;
  return message;
}

rclcpp::Time at(int64_t seconds) {
  return rclcpp::Time(kBegin + seconds * kSecond);
}

/// What an exception says; empty: none was thrown.
template <typename Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> texts(rosbag2_cpp::Reader& reader) {
  std::vector<std::string> found;
  while (reader.has_next()) {
    found.push_back(reader.read_next<String>().data);
  }
  return found;
}

using Texts = std::vector<std::string>;

/// Messages on /a and /b each second, those of /b written before their time.
void write_two_topics(const StorageOptions& options, int seconds) {
  rosbag2_cpp::Writer writer;
  writer.open(options);
  rclcpp::QoS latched(7);
  latched.transient_local();
  writer.create_topic({0, "/a", "std_msgs/msg/String", "cdr", {latched}, "RIHS01_1"});
  for (int i = 0; i < seconds; ++i) {
    writer.write(text("b" + std::to_string(i)), "/b", at(i));
    writer.write(text("a" + std::to_string(i)), "/a", at(i));
  }
}

void check_reading(Checks& checks) {
  StorageOptions options;
  options.uri = "/tmp/two";
  options.custom_data["who"] = "a test: \"quoted\"";
  write_two_topics(options, 3);
  rosbag2_cpp::Reader reader;
  CHECK(refusal([&] { reader.has_next(); }) == "Bag is not open. Call open() before reading.");
  reader.open("/tmp/two");
  CHECK(texts(reader) == (Texts{"b0", "a0", "b1", "a1", "b2", "a2"}));
  CHECK(refusal([&] { reader.read_next(); }) == "Bag is at end. No next message.");
  reader.seek(kBegin + kSecond);
  CHECK(texts(reader) == (Texts{"b1", "a1", "b2", "a2"}));
  rosbag2_storage::StorageFilter filter;
  filter.topics = {"/a"};
  reader.seek(0);
  reader.set_filter(filter);
  CHECK(texts(reader) == (Texts{"a0", "a1", "a2"}));
  filter = {};
  filter.regex = "/[b-z]";
  reader.seek(0);
  reader.set_filter(filter);
  CHECK(reader.read_next<String>().data == "b0");
  // From the present place on.
  reader.reset_filter();
  CHECK(texts(reader) == (Texts{"a0", "b1", "a1", "b2", "a2"}));
  reader.seek(kBegin + 9 * kSecond);
  CHECK(reader.set_read_order({rosbag2_storage::ReadOrder::ReceivedTimestamp, true}));
  CHECK(texts(reader) == (Texts{"a2", "b2", "a1", "b1", "a0", "b0"}));
  CHECK(!reader.set_read_order({rosbag2_storage::ReadOrder::PublishedTimestamp, false}));

  const auto topics = reader.get_all_topics_and_types();
  CHECK(topics.size() == 2 && topics[0].name == "/a" && topics[0].type == "std_msgs/msg/String");
  CHECK(topics[0].offered_qos_profiles.size() == 1 &&
        topics[0].offered_qos_profiles[0].depth() == 7);
  CHECK(topics[0].offered_qos_profiles[0].durability() == rclcpp::DurabilityPolicy::TransientLocal);
  const auto& metadata = reader.get_metadata();
  CHECK(metadata.message_count == 6 && metadata.storage_identifier == "mcap");
  CHECK(metadata.duration == std::chrono::seconds(2) && metadata.ros_distro == "jazzy");
  CHECK(metadata.starting_time.time_since_epoch() == std::chrono::nanoseconds(kBegin));
  CHECK(metadata.custom_data.at("who") == options.custom_data["who"]);
  std::vector<rosbag2_storage::MessageDefinition> definitions;
  reader.get_all_message_definitions(definitions);
  CHECK(definitions.size() == 1 && definitions[0].encoding == "ros2msg");
  CHECK(definitions[0].encoded_message_definition.find("string data") != std::string::npos);
  reader.close();
  CHECK(!refusal([&] { reader.get_metadata(); }).empty());

  // The file by itself says the same.
  const auto alone = rosbag2_cpp::Info().read_metadata("/tmp/two/two_0.mcap");
  CHECK(alone.message_count == 6 && alone.topics_with_message_count.size() == 2);
  CHECK(alone.custom_data.at("who") == options.custom_data["who"]);
  rosbag2_storage::MetadataIo io;
  const auto again = io.deserialize_metadata(io.serialize_metadata(io.read_metadata("/tmp/two")));
  CHECK(again.files.size() == 1 && again.files[0].path == "two_0.mcap");
  CHECK(again.files[0].message_count == 6 && again.topics_with_message_count[0].message_count == 3);
}

void check_several_files(Checks& checks) {
  StorageOptions options;
  options.uri = "/tmp/parts";
  options.max_bagfile_duration = 2;
  int splits = 0;
  {
    rosbag2_cpp::Writer writer;
    rosbag2_cpp::bag_events::WriterEventCallbacks callbacks;
    callbacks.write_split_callback = [&](rosbag2_cpp::bag_events::BagSplitInfo& info) {
      splits += info.opened_file.empty() ? 0 : 1;
    };
    writer.add_event_callbacks(callbacks);
    writer.open(options);
    for (int i = 0; i < 7; ++i) {
      writer.write(text(std::to_string(i)), "/a", at(i));
    }
    writer.close();
  }
  CHECK(splits == 2 && std::filesystem::exists("/tmp/parts/parts_2.mcap"));
  rosbag2_cpp::Reader reader;
  reader.open("/tmp/parts");
  CHECK(texts(reader) == (Texts{"0", "1", "2", "3", "4", "5", "6"}));
  reader.seek(kBegin + kSecond);
  CHECK(reader.read_next<String>().data == "1");
  reader.seek(kBegin + 5 * kSecond);
  CHECK(texts(reader) == (Texts{"5", "6"}));
  CHECK(reader.get_metadata().files.size() == 3 && reader.get_metadata().message_count == 7);
}

void check_forms(Checks& checks) {
  StorageOptions options;
  options.uri = "/tmp/loose";
  options.storage_preset_profile = "fastwrite";
  write_two_topics(options, 2);
  rosbag2_cpp::Reader reader;
  reader.open("/tmp/loose");
  CHECK(texts(reader) == (Texts{"b0", "a0", "b1", "a1"}));

  options = {};
  options.uri = "/tmp/snapshot";
  options.snapshot_mode = true;
  options.max_cache_size = 40;
  rosbag2_cpp::Writer writer;
  writer.open(options);
  for (int i = 0; i < 9; ++i) {
    writer.write(text(std::to_string(i)), "/a", at(i));
  }
  CHECK(writer.take_snapshot());
  writer.write(text("too late"), "/a", at(9));
  writer.close();
  reader.open("/tmp/snapshot");
  const Texts kept = texts(reader);
  CHECK(kept.size() > 1 && kept.size() < 9 && kept.back() == "8");

  options = {};
  options.uri = "/tmp/between";
  options.start_time_ns = kBegin + kSecond;
  options.end_time_ns = kBegin + 2 * kSecond;
  write_two_topics(options, 5);
  reader.open("/tmp/between");
  CHECK(texts(reader) == (Texts{"b1", "a1", "b2", "a2"}));
}

void check_other_writes(Checks& checks) {
  rosbag2_cpp::Writer writer;
  CHECK(refusal([&] { writer.write(text("x"), "/a", at(0)); }) ==
        "Bag is not open. Call open() before writing.");
  writer.open("/tmp/other");
  geometry_msgs::msg::PoseStamped pose;
  pose.header.frame_id = "map";
  pose.pose.position.x = 1.5;
  writer.write(pose, "/pose", at(0));
  auto message = std::make_shared<rosbag2_storage::SerializedBagMessage>();
  message->topic_name = "/raw";
  message->recv_timestamp = kBegin + kSecond;
  message->send_timestamp = kBegin;
  message->serialized_data = rosbag2_storage::make_serialized_message("\0\1\0\0\2\0\0\0x\0", 10);
  CHECK(refusal([&] { writer.write(message); }) ==
        "Failed to write on topic '/raw'. Call create_topic() before first write.");
  CHECK(refusal([&] { writer.write(message, "/other", "std_msgs/msg/String"); }) ==
        "trying to write a message with mismatching topic information: (/raw) vs (/other)");
  writer.write(message, "/raw", "std_msgs/msg/String", "cdr");
  writer.create_topic({0, "/gone", "std_msgs/msg/String", "cdr", {}, ""});
  writer.remove_topic({0, "/gone", "std_msgs/msg/String", "cdr", {}, ""});
  CHECK(refusal([&] {
          writer.remove_topic({0, "/gone", "", "", {}, ""});
        }) == "Failed to remove the non-existing topic \"/gone\"!");
  CHECK(!writer.take_snapshot());
  writer.close();
  rosbag2_cpp::Reader reader(std::make_unique<rosbag2_cpp::readers::SequentialReader>());
  reader.open(StorageOptions{"/tmp/other", "mcap"}, {"cdr", "cdr"});
  CHECK(reader.get_all_topics_and_types().size() == 2);
  CHECK(reader.read_next<geometry_msgs::msg::PoseStamped>() == pose);
  const auto raw = reader.read_next();
  CHECK(raw->topic_name == "/raw" && raw->send_timestamp == kBegin);
  CHECK(raw->serialized_data->buffer_length == 10 && !reader.has_next());
  std::vector<rosbag2_storage::MessageDefinition> definitions;
  reader.get_all_message_definitions(definitions);
  bool is_whole = false;
  for (const auto& one : definitions) {
    const std::string& all = one.encoded_message_definition;
    is_whole = is_whole || (all.find("MSG: geometry_msgs/Quaternion\n") != std::string::npos &&
                            all.find("MSG: builtin_interfaces/Time\n") != std::string::npos);
  }
  CHECK(is_whole);
}

void check_refusals(Checks& checks) {
  const auto open_for_writing = [](const StorageOptions& options) {
    return refusal([&] { rosbag2_cpp::Writer().open(options); });
  };
  CHECK(open_for_writing({"/tmp/two", ""}) ==
        "Bag directory already exists (/tmp/two), can't overwrite existing bag");
  CHECK(open_for_writing({"/tmp/sql", "sqlite3"}).find("`ros2 bag convert`") != std::string::npos);
  CHECK(open_for_writing({"/tmp/strange", "strange"}) == "No storage could be initialized. Abort");
  StorageOptions small{"/tmp/small", ""};
  small.max_bagfile_size = 10;
  CHECK(!open_for_writing(small).empty());
  StorageOptions packed{"/tmp/packed", ""};
  packed.storage_preset_profile = "zstd_fast";
  CHECK(open_for_writing(packed) == "No storage could be initialized. Abort");
  CHECK(refusal([] {
          rosbag2_cpp::Writer().open({"/tmp/converted", ""}, {"cdr", "json"});
        }) == "Could not find converter for format json");

  const auto open_for_reading = [](const std::string& uri) {
    return refusal([&] { rosbag2_cpp::Reader().open(uri); });
  };
  CHECK(open_for_reading("/tmp/none") == "No storage could be initialized from the inputs.");
  CHECK(open_for_reading("/tmp/old.db3").find("sqlite3") != std::string::npos);
  std::ofstream("/tmp/no_bag.mcap") << "anything but a bag";
  CHECK(open_for_reading("/tmp/no_bag.mcap") == "No storage could be initialized from the inputs.");
  std::filesystem::create_directory("/tmp/bad");
  std::ofstream("/tmp/bad/metadata.yaml") << "rosbag2_bagfile_information: {version: x}\n";
  CHECK(open_for_reading("/tmp/bad").find("Exception on parsing info file: ") == 0);
  std::ofstream("/tmp/bad/metadata.yaml") << std::string(100000, '[');
  CHECK(open_for_reading("/tmp/bad").find("nested too deep") != std::string::npos);

  // Cut in the middle: what is whole is read.
  StorageOptions options{"/tmp/cut", ""};
  write_two_topics(options, 2000);
  std::filesystem::resize_file("/tmp/cut/cut_0.mcap",
                               std::filesystem::file_size("/tmp/cut/cut_0.mcap") - 100);
  rosbag2_cpp::Reader cut;
  cut.open("/tmp/cut/cut_0.mcap");
  CHECK(texts(cut).size() == 4000);
}

void check_qos(Checks& checks) {
  using rosbag2_storage::Rosbag2QoS;
  rclcpp::QoS endless(3);
  endless.deadline(rclcpp::Duration::from_seconds(2.5)).keep_all().best_effort();
  const auto text9 = rosbag2_storage::serialize_rclcpp_qos_vector({endless, rclcpp::QoS(1)});
  CHECK(rosbag2_storage::to_rclcpp_qos_vector(text9, 9) ==
        (std::vector<rclcpp::QoS>{endless, rclcpp::QoS(1)}));
  const auto text8 = rosbag2_storage::serialize_rclcpp_qos_vector({endless}, 8);
  CHECK(text8.find("history: 2\n") != std::string::npos);
  CHECK(rosbag2_storage::to_rclcpp_qos_vector(text8, 8)[0] == endless);
  CHECK(!refusal([] { rosbag2_storage::to_rclcpp_qos_vector("- history: 1", 9); }).empty());
  const auto mixed = Rosbag2QoS::adapt_offer_to_recorded_offers(
      "/a", {Rosbag2QoS(endless), Rosbag2QoS(rclcpp::QoS(1))});
  CHECK(mixed.reliability() == rclcpp::ReliabilityPolicy::Reliable);
}

/// A bag that the test put into the package's share.
void check_share(Checks& checks, const std::string& bag) {
  rosbag2_cpp::Reader reader;
  reader.open(bag);
  CHECK(texts(reader) == (Texts{"from the share", "compressed"}));
}

}  // namespace

int main(int argc, char* argv[]) {
  rclcpp::init(argc, argv);
  Checks checks("bags");
  check_reading(checks);
  check_several_files(checks);
  check_forms(checks);
  check_other_writes(checks);
  check_refusals(checks);
  check_qos(checks);
  if (argc > 1) {
    check_share(checks, argv[1]);
  }
  return checks.finish();
}
