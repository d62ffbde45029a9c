// The signs of the commands of one axis: after a change of sign, only the new one is allowed. Knows
// nothing of ROS.
#pragma once

namespace dwb_critics {

class CommandTrend {
 public:
  void reset() { *this = CommandTrend(); }

  /// True when the sign changes. 0 leaves all as it is.
  bool update(double velocity) {
    const Sign sign = velocity < 0.0 ? Sign::NEGATIVE : Sign::POSITIVE;
    if (velocity == 0.0) return false;
    const bool has_flipped = sign_ != Sign::ZERO && sign_ != sign;
    sign_ = sign;
    positive_only_ = positive_only_ || (has_flipped && sign == Sign::POSITIVE);
    negative_only_ = negative_only_ || (has_flipped && sign == Sign::NEGATIVE);
    return has_flipped;
  }

  bool isOscillating(double velocity) const {
    return (positive_only_ && velocity < 0.0) || (negative_only_ && velocity > 0.0);
  }

  bool hasSignFlipped() const { return positive_only_ || negative_only_; }

 private:
  enum class Sign { ZERO, POSITIVE, NEGATIVE };
  Sign sign_ = Sign::ZERO;
  bool positive_only_ = false;
  bool negative_only_ = false;
};

}  // namespace dwb_critics
