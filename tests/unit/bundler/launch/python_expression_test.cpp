// Expressions against what CPython 3.12 makes of them.
#include "bundler/launch/python_expression.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

struct Case {
  const char* expression;
  const char* value;
};

constexpr Case kCases[] = {
    {"1 + 2", "3"},
    {"2 * 3 - 4", "2"},
    {"7 // 2", "3"},
    {"-7 // 2", "-4"},
    {"7 // -2", "-4"},
    {"-7 % 3", "2"},
    {"7 % -3", "-2"},
    {"7.5 // 2", "3.0"},
    {"-7.5 % 2", "0.5"},
    {"1 / 2", "0.5"},
    {"4 / 2", "2.0"},
    {"2 ** 10", "1024"},
    {"2 ** -1", "0.5"},
    {"-2 ** 2", "-4"},
    {"2 ** 3 ** 2", "512"},
    {"1e16", "1e+16"},
    {"1e15", "1000000000000000.0"},
    {"123456789.125", "123456789.125"},
    {"0.0001", "0.0001"},
    {"0.00001", "1e-05"},
    {"1e100", "1e+100"},
    {"1.0", "1.0"},
    {"-0.0", "-0.0"},
    {".5", "0.5"},
    {"3.", "3.0"},
    {"1e3", "1000.0"},
    {"0.1 + 0.2", "0.30000000000000004"},
    {"'a' + 'b'", "ab"},
    {"\"it's\"", "it's"},
    {"'ab' 'cd'", "abcd"},
    {"'a' * 3", "aaa"},
    {"3 * 'ab'", "ababab"},
    {"[1, 2.5, 'x', True, None]", "[1, 2.5, 'x', True, None]"},
    {"(1, 2) == (1, 2)", "True"},
    {"['a', \"it's\"]", "['a', \"it's\"]"},
    {"not True", "False"},
    {"not 0 or 1", "True"},
    {"1 and 'x'", "x"},
    {"0 or ''", ""},
    {"'' or 'default'", "default"},
    {"1 if True else 2", "1"},
    {"1 if False else 2 if False else 3", "3"},
    {"'yes' if 'r2' == \"r2\" and 3 > 2 else 'no'", "yes"},
    {"1 < 2 < 3", "True"},
    {"1 < 2 > 3", "False"},
    {"3 == 3.0", "True"},
    {"True == 1", "True"},
    {"'1' == 1", "False"},
    {"'a' < 'b'", "True"},
    {"'a' in 'cat'", "True"},
    {"2 in [1, 2]", "True"},
    {"3 not in [1, 2]", "True"},
    {"None is None", "True"},
    {"1 is not None", "True"},
    {"'true' == 'true'", "True"},
    {"'Ab'.lower()", "ab"},
    {"'ab'.upper() + '!'", "AB!"},
    {"' a '.strip()", "a"},
    {"'xxaxx'.strip('x')", "a"},
    {"'a,b,c'.split(',')", "['a', 'b', 'c']"},
    {"' a  b '.split()", "['a', 'b']"},
    {"'a-b'.replace('-', '_')", "a_b"},
    {"'robot1'.startswith('robot')", "True"},
    {"'x.yaml'.endswith('.xml')", "False"},
    {"'abc'.find('c')", "2"},
    {"'abc'.find('z')", "-1"},
    {"', '.join(['a', 'b'])", "a, b"},
    {"'12'.isdigit()", "True"},
    {"[1, 1, 2].count(1)", "2"},
    {"'abc'[1]", "b"},
    {"'abc'[-1]", "c"},
    {"[1, 2, 3][0]", "1"},
    {"len('héllo')", "5"},
    {"len([1, 2])", "2"},
    {"int('42') + 1", "43"},
    {"int(' 7 ')", "7"},
    {"int(3.9)", "3"},
    {"int(-3.9)", "-3"},
    {"float('2.5') * 2", "5.0"},
    {"float('1')", "1.0"},
    {"str(1.0) + 's'", "1.0s"},
    {"bool('')", "False"},
    {"abs(-3)", "3"},
    {"abs(-2.5)", "2.5"},
    {"min(3, 1, 2)", "1"},
    {"max([1, 5, 2])", "5"},
    {"round(2.5)", "2"},
    {"round(3.5)", "4"},
    {"round(2.675, 2)", "2.67"},
    {"sum([1, 2, 3.5])", "6.5"},
    {"any([0, 1])", "True"},
    {"all([1, 0])", "False"},
    {"pi", "3.141592653589793"},
    {"math.pi", "3.141592653589793"},
    {"math.sqrt(16)", "4.0"},
    {"sin(0)", "0.0"},
    {"cos(0.0)", "1.0"},
    {"floor(2.7)", "2"},
    {"ceil(2.1)", "3"},
    {"math.floor(-2.5)", "-3"},
    {"radians(180)", "3.141592653589793"},
    {"degrees(pi)", "180.0"},
    {"atan2(1, 1)", "0.7853981633974483"},
    {"hypot(3, 4)", "5.0"},
    {"pow(2, 3)", "8.0"},
    {"exp(0)", "1.0"},
    {"log(e)", "1.0"},
    {"log(8, 2)", "3.0"},
    {"fabs(-1)", "1.0"},
    {"1.5 * pi / 2", "2.356194490192345"},
    {"inf", "inf"},
    {"-1 + 2 * (3 - 1)", "3"},
    {"True + True", "2"},
    {"'%' * 2", "%%"},
    {"1 if 1 else undefined_name", "1"},
    {"True or undefined_name", "True"},
    {"9223372036854775807", "9223372036854775807"},
    {"'a\\nb'", "a\nb"},
    {"((((1))))", "1"},
    {"0.5 == .5", "True"},
};

TEST(PythonExpression, GivesWhatPythonGives) {
  for (const auto& [expression, value] : kCases) {
    const auto result = evaluate_python(expression, {});
    ASSERT_TRUE(result.ok()) << expression << ": " << result.errors().front().message;
    EXPECT_EQ(*result, value) << expression;
  }
}

TEST(PythonExpression, FailsAsPythonDoes) {
  for (const auto& [expression, fault] : {
           Case{"1 / 0", "ZeroDivisionError"},
           Case{"1 // 0", "ZeroDivisionError"},
           Case{"1.0 % 0", "ZeroDivisionError"},
           Case{"'a' + 1", "TypeError"},
           Case{"1 < 'a'", "TypeError"},
           Case{"undefined", "NameError"},
           Case{"true", "NameError"},
           Case{"1 +", "SyntaxError"},
           Case{"1 2", "SyntaxError"},
           Case{"'a", "SyntaxError"},
           Case{"", "SyntaxError"},
           Case{"int('x')", "ValueError"},
           Case{"float('x')", "ValueError"},
           Case{"[1][2]", "IndexError"},
           Case{"'a'.fly()", "AttributeError"},
           Case{"sqrt(-1)", "ValueError"},
           Case{"len(1)", "TypeError"},
           Case{"1 if 2", "SyntaxError"},
           Case{"9223372036854775807 + 1", "OverflowError"},
       }) {
    const auto result = evaluate_python(expression, {});
    ASSERT_FALSE(result.ok()) << expression << " gives " << *result;
    EXPECT_EQ(result.errors().front().code, "R2W0411");
    EXPECT_NE(result.errors().front().message.find(fault), std::string::npos)
        << expression << ": " << result.errors().front().message;
  }
}

TEST(PythonExpression, ReachesNothing) {
  for (const char* expression :
       {"__import__('os')", "open('/etc/passwd')", "().__class__", "'a'.__class__", "lambda: 1",
        "[x for x in 'ab']", "exec('1')", "math.__dict__", "a := 1"}) {
    EXPECT_FALSE(evaluate_python(expression, {}).ok()) << expression;
  }
}

TEST(PythonExpression, HostileOnesEnd) {
  EXPECT_FALSE(evaluate_python(std::string(1000, '('), {}).ok());
  EXPECT_FALSE(evaluate_python(std::string(1000, '-') + "1", {}).ok());
  EXPECT_FALSE(evaluate_python(std::string(1'000'000, ' ') + "1", {}).ok());
  EXPECT_FALSE(evaluate_python("'a' * 9999999 * 9999999", {}).ok());
  EXPECT_FALSE(evaluate_python("9 ** 9999999", {}).ok());
  std::string sum = "1";
  for (int i = 0; i < 2000; ++i) sum += "+1";
  EXPECT_EQ(*evaluate_python(sum, {}), "2001");
}

}  // namespace
}  // namespace ros2wasm
