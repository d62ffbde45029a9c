// A queue of items by priority, the least first; of equal ones, the last that came.
#pragma once

#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace costmap_queue {

template <class item_t>
class MapBasedQueue {
 public:
  /// With `reset_bins` false, reset() leaves the bins of an empty queue in place.
  explicit MapBasedQueue(bool reset_bins = true) : reset_bins_(reset_bins) { reset(); }
  virtual ~MapBasedQueue() = default;

  virtual void reset() {
    if (reset_bins_ || item_count_ > 0) item_bins_.clear();
    item_count_ = 0;
    iter_ = last_insert_iter_ = item_bins_.end();
  }

  void enqueue(const double priority, item_t item) {
    // Neighbours have the same priority often.
    if (last_insert_iter_ == item_bins_.end() || last_insert_iter_->first != priority) {
      last_insert_iter_ = item_bins_.try_emplace(priority).first;
    }
    last_insert_iter_->second.push_back(std::move(item));
    ++item_count_;
    if (iter_ == item_bins_.end() || priority < iter_->first) iter_ = last_insert_iter_;
  }

  bool isEmpty() { return item_count_ == 0; }

  /// Throws std::out_of_range when the queue is empty.
  item_t& front() {
    if (iter_ == item_bins_.end()) {
      throw std::out_of_range("front() called on empty costmap_queue::MapBasedQueue!");
    }
    return iter_->second.back();
  }

  void pop() {
    if (iter_ == item_bins_.end()) return;
    iter_->second.pop_back();
    --item_count_;
    while (iter_ != item_bins_.end() && iter_->second.empty()) ++iter_;
  }

 protected:
  using ItemMap = std::map<double, std::vector<item_t>>;
  using ItemMapIterator = typename ItemMap::iterator;

  bool reset_bins_;
  ItemMap item_bins_;
  unsigned int item_count_ = 0;
  ItemMapIterator iter_;  // the bin of the first item, or the end
  ItemMapIterator last_insert_iter_;
};

}  // namespace costmap_queue
