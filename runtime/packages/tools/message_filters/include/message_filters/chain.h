// Filters one after the other, as one filter whose parts need not be known.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "message_filters/pass_through.h"
#include "message_filters/simple_filter.h"

namespace message_filters {

class ChainBase {
 public:
  virtual ~ChainBase() = default;

  /// The filter with that index, which must be of type F; null when there is none.
  template <typename F>
  std::shared_ptr<F> getFilter(size_t index) const {
    return std::static_pointer_cast<F>(getFilterForIndex(index));
  }

 protected:
  virtual std::shared_ptr<void> getFilterForIndex(size_t index) const = 0;
};
using ChainBasePtr = std::shared_ptr<ChainBase>;

template <typename M>
class Chain : public ChainBase, public SimpleFilter<M> {
 public:
  using MConstPtr = std::shared_ptr<const M>;
  using EventType = MessageEvent<const M>;

  struct NullDeleter {
    void operator()(const void*) const {}
  };

  Chain() = default;
  template <typename F>
  explicit Chain(F& f) {
    connectInput(f);
  }
  ~Chain() override {
    incoming_.disconnect();
    outgoing_.disconnect();
  }

  /// Both return the filter's index. A filter given by pointer must outlive the chain.
  template <class F>
  size_t addFilter(F* filter) {
    return addFilter(std::shared_ptr<F>(filter, NullDeleter()));
  }
  template <class F>
  size_t addFilter(const std::shared_ptr<F>& filter) {
    auto output = std::make_shared<PassThrough<M>>(*filter);
    outgoing_.disconnect();
    outgoing_ =
        output->registerCallback([this](const EventType& event) { this->signalMessage(event); });
    if (!links_.empty()) {
      filter->connectInput(*links_.back().output);
    }
    links_.push_back({[filter](const EventType& event) { filter->add(event); }, filter, output});
    return links_.size() - 1;
  }

  template <class F>
  void connectInput(F& f) {
    incoming_.disconnect();
    incoming_ = f.registerCallback([this](const EventType& event) { add(event); });
  }

  void add(const MConstPtr& msg) { add(EventType(msg)); }
  void add(const EventType& evt) {
    if (!links_.empty()) {
      links_.front().add(evt);
    }
  }

 protected:
  std::shared_ptr<void> getFilterForIndex(size_t index) const override {
    return index < links_.size() ? links_[index].filter : nullptr;
  }

 private:
  struct Link {
    std::function<void(const EventType&)> add;
    std::shared_ptr<void> filter;
    std::shared_ptr<PassThrough<M>> output;
  };
  std::vector<Link> links_;
  Connection incoming_;
  Connection outgoing_;
};

}  // namespace message_filters
