// Opens the one storage that there is.
#include "rosbag2_storage/storage_factory.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>

#include "mcap_storage.hpp"
#include "rcutils/logging_macros.h"
#include "rosbag2_storage/default_storage_id.hpp"

namespace rosbag2_storage {
namespace {

using storage_interfaces::IOFlag;

constexpr char kLog[] = "rosbag2_storage";
constexpr char kSqlite[] = "sqlite3";

std::shared_ptr<McapStorage> open(const StorageOptions& options, IOFlag flag) {
  const bool is_sqlite =
      options.storage_id == kSqlite || (flag == IOFlag::READ_ONLY && options.storage_id.empty() &&
                                        std::filesystem::path(options.uri).extension() == ".db3");
  if (is_sqlite) {
    throw std::runtime_error(
        "bags of the storage 'sqlite3' (.db3) are neither read nor written in a site: use the "
        "storage 'mcap', and convert bags that you have with `ros2 bag convert`");
  }
  const std::string& id = options.storage_id;
  if (!id.empty() && id != get_default_storage_id()) {
    RCUTILS_LOG_ERROR_NAMED(kLog, "Could not load/open plugin with storage id '%s'", id.c_str());
    return nullptr;
  }
  try {
    auto storage = std::make_shared<McapStorage>();
    storage->open(options, flag);
    return storage;
  } catch (const std::runtime_error& reason) {
    RCUTILS_LOG_ERROR_NAMED(kLog, "Could not open '%s' with '%s'. Error: %s", options.uri.c_str(),
                            get_default_storage_id().c_str(), reason.what());
    return nullptr;
  }
}

}  // namespace

std::string get_default_storage_id() {
  return "mcap";
}

std::shared_ptr<storage_interfaces::ReadOnlyInterface> StorageFactory::open_read_only(
    const StorageOptions& storage_options) {
  return open(storage_options, IOFlag::READ_ONLY);
}

std::shared_ptr<storage_interfaces::ReadWriteInterface> StorageFactory::open_read_write(
    const StorageOptions& storage_options) {
  return open(storage_options, IOFlag::READ_WRITE);
}

}  // namespace rosbag2_storage
