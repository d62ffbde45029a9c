// How the transforms of a frame are kept, found and interpolated.
#include <algorithm>
#include <iterator>

#include "tf2/time_cache.hpp"

namespace tf2 {
namespace {

// Notes why there is no data, where one asks.
void fail(TF2Error code, std::string* error_str, TF2Error* error_code, const char* what,
          TimePoint asked, const char* but, TimePoint has, const char* end) {
  if (error_code != nullptr) {
    *error_code = code;
  }
  if (error_str != nullptr) {
    *error_str = what + displayTimePoint(asked) + but + displayTimePoint(has) + end;
  }
}

}  // namespace

TimeCache::TimeCache(Duration max_storage_time) : max_storage_time_(max_storage_time) {}

TimeCache::Around TimeCache::find(TimePoint time, std::string* error_str,
                                  TF2Error* error_code) const {
  if (error_code != nullptr) {
    *error_code =
        storage_.empty() ? TF2Error::TF2_NO_DATA_FOR_EXTRAPOLATION_ERROR : TF2Error::TF2_NO_ERROR;
  }
  if (storage_.empty()) {
    return {};
  }
  const TransformStorage& latest = storage_.front();
  const TransformStorage& earliest = storage_.back();
  if (time == TimePointZero || time == latest.stamp_) {
    return {&latest, nullptr};
  }
  if (storage_.size() == 1) {
    fail(TF2Error::TF2_NO_DATA_FOR_EXTRAPOLATION_ERROR, error_str, error_code,
         "Lookup would require extrapolation at time ", time, ", but only time ", latest.stamp_,
         " is in the buffer");
    return {};
  }
  if (time > latest.stamp_) {
    fail(TF2Error::TF2_FORWARD_EXTRAPOLATION_ERROR, error_str, error_code,
         "Lookup would require extrapolation into the future.  Requested time ", time,
         " but the latest data is at time ", latest.stamp_, "");
    return {};
  }
  if (time < earliest.stamp_) {
    fail(TF2Error::TF2_BACKWARD_EXTRAPOLATION_ERROR, error_str, error_code,
         "Lookup would require extrapolation into the past.  Requested time ", time,
         " but the earliest data is at time ", earliest.stamp_, "");
    return {};
  }
  if (time == earliest.stamp_) {
    return {&earliest, nullptr};
  }
  const auto older =
      std::find_if(storage_.begin(), storage_.end(),
                   [time](const TransformStorage& item) { return item.stamp_ <= time; });
  return {&*older, &*std::prev(older)};
}

bool TimeCache::getData(TimePoint time, TransformStorage& data_out, std::string* error_str,
                        TF2Error* error_code) {
  const Around around = find(time, error_str, error_code);
  if (around.older == nullptr) {
    return false;
  }
  data_out = *around.older;
  // Between two parents nothing can be interpolated: the older one still holds.
  if (around.newer != nullptr && around.newer->frame_id_ == around.older->frame_id_) {
    const tf2Scalar ratio =
        static_cast<tf2Scalar>((time - around.older->stamp_).count()) /
        static_cast<tf2Scalar>((around.newer->stamp_ - around.older->stamp_).count());
    data_out.translation_.setInterpolate3(around.older->translation_, around.newer->translation_,
                                          ratio);
    data_out.rotation_ = slerp(around.older->rotation_, around.newer->rotation_, ratio);
  }
  return true;
}

CompactFrameID TimeCache::getParent(TimePoint time, std::string* error_str, TF2Error* error_code) {
  const Around around = find(time, error_str, error_code);
  return around.older == nullptr ? 0 : around.older->frame_id_;
}

bool TimeCache::insertData(const TransformStorage& new_data) {
  const TimePoint oldest_kept = getLatestTimestamp() - max_storage_time_;
  while (!storage_.empty() && storage_.back().stamp_ < oldest_kept) {
    storage_.pop_back();
  }
  if (!storage_.empty() && new_data.stamp_ < oldest_kept) {
    return false;
  }
  const auto place =
      std::find_if(storage_.begin(), storage_.end(),
                   [&](const TransformStorage& item) { return item.stamp_ <= new_data.stamp_; });
  const auto older = std::find_if(place, storage_.end(), [&](const TransformStorage& item) {
    return item.stamp_ < new_data.stamp_;
  });
  if (std::find(place, older, new_data) == older) {
    storage_.insert(place, new_data);
  }
  return true;
}

void TimeCache::clearList() {
  storage_.clear();
}

P_TimeAndFrameID TimeCache::getLatestTimeAndParent() {
  return storage_.empty() ? P_TimeAndFrameID(TimePoint(), 0)
                          : P_TimeAndFrameID(storage_.front().stamp_, storage_.front().frame_id_);
}

unsigned int TimeCache::getListLength() {
  return static_cast<unsigned int>(storage_.size());
}

TimePoint TimeCache::getLatestTimestamp() {
  return storage_.empty() ? TimePoint() : storage_.front().stamp_;
}

TimePoint TimeCache::getOldestTimestamp() {
  return storage_.empty() ? TimePoint() : storage_.back().stamp_;
}

bool StaticCache::getData(TimePoint time, TransformStorage& data_out, std::string*,
                          TF2Error* error_code) {
  data_out = storage_;
  data_out.stamp_ = time;
  if (error_code != nullptr) {
    *error_code = TF2Error::TF2_NO_ERROR;
  }
  return true;
}

bool StaticCache::insertData(const TransformStorage& new_data) {
  storage_ = new_data;
  return true;
}

CompactFrameID StaticCache::getParent(TimePoint, std::string*, TF2Error* error_code) {
  if (error_code != nullptr) {
    *error_code = TF2Error::TF2_NO_ERROR;
  }
  return storage_.frame_id_;
}

P_TimeAndFrameID StaticCache::getLatestTimeAndParent() {
  return {TimePoint(), storage_.frame_id_};
}

}  // namespace tf2
