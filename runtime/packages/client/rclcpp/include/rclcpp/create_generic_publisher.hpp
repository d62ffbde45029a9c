#pragma once
#include "rclcpp/generic_subscription.hpp"
