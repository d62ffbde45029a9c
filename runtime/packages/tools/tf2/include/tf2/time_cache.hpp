// The transforms of one frame over time.
#pragma once

#include <chrono>
#include <list>
#include <memory>
#include <string>
#include <utility>

#include "tf2/exceptions.hpp"
#include "tf2/transform_storage.hpp"

namespace tf2 {

typedef std::pair<TimePoint, CompactFrameID> P_TimeAndFrameID;

class TimeCacheInterface {
 public:
  virtual ~TimeCacheInterface() = default;

  /// False when there is no data for the time; then the pointers, if given, tell why.
  virtual bool getData(TimePoint time, TransformStorage& data_out, std::string* error_str = nullptr,
                       TF2Error* error_code = nullptr) = 0;
  /// False when the data is too old to be kept.
  virtual bool insertData(const TransformStorage& new_data) = 0;
  virtual void clearList() = 0;
  /// The parent at a time; 0 as getData's false.
  virtual CompactFrameID getParent(TimePoint time, std::string* error_str = nullptr,
                                   TF2Error* error_code = nullptr) = 0;
  /// Time zero when empty or static.
  virtual P_TimeAndFrameID getLatestTimeAndParent() = 0;
  virtual unsigned int getListLength() = 0;
  virtual TimePoint getLatestTimestamp() = 0;
  virtual TimePoint getOldestTimestamp() = 0;
};

using TimeCacheInterfacePtr = std::shared_ptr<TimeCacheInterface>;

constexpr Duration TIMECACHE_DEFAULT_MAX_STORAGE_TIME = std::chrono::seconds(10);

/// Keeps what is not older than a limit, and interpolates.
class TimeCache : public TimeCacheInterface {
 public:
  explicit TimeCache(Duration max_storage_time = TIMECACHE_DEFAULT_MAX_STORAGE_TIME);

  bool getData(TimePoint time, TransformStorage& data_out, std::string* error_str = nullptr,
               TF2Error* error_code = nullptr) override;
  bool insertData(const TransformStorage& new_data) override;
  void clearList() override;
  CompactFrameID getParent(TimePoint time, std::string* error_str = nullptr,
                           TF2Error* error_code = nullptr) override;
  P_TimeAndFrameID getLatestTimeAndParent() override;
  unsigned int getListLength() override;
  TimePoint getLatestTimestamp() override;
  TimePoint getOldestTimestamp() override;

 protected:
  /// Newest first.
  const std::list<TransformStorage>& getAllItems() const { return storage_; }

 private:
  // The transforms around a time: the older one, and the newer one where the time is between two.
  struct Around {
    const TransformStorage* older = nullptr;
    const TransformStorage* newer = nullptr;
  };
  Around find(TimePoint time, std::string* error_str, TF2Error* error_code) const;

  std::list<TransformStorage> storage_;
  Duration max_storage_time_;
};

/// One transform that holds at all times.
class StaticCache : public TimeCacheInterface {
 public:
  bool getData(TimePoint time, TransformStorage& data_out, std::string* error_str = nullptr,
               TF2Error* error_code = nullptr) override;
  bool insertData(const TransformStorage& new_data) override;
  void clearList() override {}
  CompactFrameID getParent(TimePoint time, std::string* error_str = nullptr,
                           TF2Error* error_code = nullptr) override;
  P_TimeAndFrameID getLatestTimeAndParent() override;
  unsigned int getListLength() override { return 1; }
  TimePoint getLatestTimestamp() override { return TimePoint(); }
  TimePoint getOldestTimestamp() override { return TimePoint(); }

 private:
  TransformStorage storage_;
};

}  // namespace tf2
