// Documents of xacro that are wrong, that mean harm, and command lines.
#include <gtest/gtest.h>

#include "bundler/launch/xacro/xacro.hpp"
#include "tests/unit/bundler/support/xacro_documents.hpp"

namespace ros2wasm {
namespace {

using xacro_documents::expand;
using xacro_documents::robot;

struct Case {
  const char* what;
  const char* document;  ///< inside of the root element
  const char* message;
};

TEST(Xacro, FaultsNameWhatIsWrong) {
  for (const auto& [what, document, message] : {
           Case{"no name", "${nothing}", "name 'nothing' is not defined"},
           Case{"no macro", "<xacro:weel/>", "there is no macro `weel`"},
           Case{"no macro to call", "<xacro:call macro=\"x\"/>", "there is no macro `x`"},
           Case{"no namespace", "<xacro:a.b/>", "there is no macro `a.b`"},
           Case{"a parameter too few", "<xacro:macro name=\"m\" params=\"a b\"/><xacro:m a=\"1\"/>",
                "needs the parameter `b`"},
           Case{"a parameter too many", "<xacro:macro name=\"m\"/><xacro:m a=\"1\"/>",
                "has no parameter `a`"},
           Case{"a block too few", "<xacro:macro name=\"m\" params=\"*b\"/><xacro:m/>",
                "needs an element for `*b`"},
           Case{"a block too many", "<xacro:macro name=\"m\"/><xacro:m><a/></xacro:m>",
                "has no use for the element `a`"},
           Case{"nothing to forward", "<xacro:macro name=\"m\" params=\"a:=^\"/><xacro:m/>",
                "no property `a` to be forwarded"},
           Case{"no block", "<xacro:insert_block name=\"b\"/>", "there is no block `b`"},
           Case{"a name of macros", "<xacro:macro name=\"a.b\"/>", "have no `.`"},
           Case{"another", "<xacro:macro name=\"call\"/>", "cannot have the name `call`"},
           Case{"names of properties", "<xacro:property name=\"a-b\" value=\"1\"/>",
                "`a-b` is not a valid name for a property"},
           Case{"keywords", "<xacro:property name=\"if\" value=\"1\"/>",
                "`if` is not a valid name"},
           Case{"hidden names", "<xacro:property name=\"__a\" value=\"1\"/>", "do not begin with"},
           Case{"two values", "<xacro:property name=\"a\" value=\"\" default=\"\"/>",
                "exclude each other"},
           Case{"no scope around", "<xacro:property name=\"a\" value=\"1\" scope=\"parent\"/>",
                "no scope around"},
           Case{"a circle",
                "<xacro:property name=\"a\" value=\"${b}\"/><xacro:property name=\"b\" "
                "value=\"${a}\"/>${a}",
                "`a` is defined by itself"},
           Case{"no condition", "<xacro:if value=\"maybe\"/>", "`maybe` is not a condition"},
           Case{"nor this", "<xacro:if value=\"1.0\"/>", "`1.0` is not a condition"},
           Case{"no value", "<xacro:if/>", "`xacro:if` needs the attribute `value`"},
           Case{"a name of elements", "<xacro:element xacro:name=\"a b\"/>",
                "`a b` is not a valid name for an element"},
           Case{"no name", "<xacro:element xacro:name=\"${''}\"/>", "`` is not a valid name"},
           Case{"a name of attributes", "<xacro:attribute name=\"1\" value=\"\"/>",
                "`1` is not a valid name for an attribute"},
           Case{"an open expression", "a${b", "is not closed"},
           Case{"an open substitution", "$(arg b", "is not closed"},
           Case{"dollars", "$$ x", "`$$` can only"},
           Case{"no expression", "${1 +}", "SyntaxError"},
           Case{"a division", "<xacro:property name=\"z\" value=\"0\"/>${1/z}",
                "ZeroDivisionError"},
           Case{"no argument", "$(arg size)", "there is no argument `size`"},
           Case{"no package", "$(find nowhere)", "there is no package `nowhere`"},
           Case{"no variable", "$(env NOTHING)", "there is no environment variable `NOTHING`"},
           Case{"no substitution", "$(anon x)", "there is no substitution `$(anon x)`"},
           Case{"no file", "<xacro:include filename=\"none.xacro\"/>",
                "`none.xacro` cannot be read"},
           Case{"no YAML", "${xacro.load_yaml('none.yaml')}", "`none.yaml` cannot be read"},
           Case{"no unit", "${xacro.load_yaml('bad_unit.yaml')}", "__import__"},
           Case{"no key", "${xacro.load_yaml('arms.yaml').middle}", "no attribute 'middle'"},
           Case{"an own fault", "${xacro.fatal('too', 'small')}", "too small"},
           Case{"built-in names that are not let in", "${abs(-1)}", "name 'abs'"},
           Case{"nothing beyond", "${__import__('os')}", "__import__"},
           Case{"nor so", "${''.__class__}", "__class__"},
       }) {
    const auto expanded = expand(robot(document));
    ASSERT_FALSE(expanded.ok()) << what << " gives " << *expanded;
    const Diagnostic& error = expanded.errors().front();
    EXPECT_EQ(error.code, "R2W0418") << what;
    EXPECT_NE(error.message.find(message), std::string::npos) << what << ": " << error.message;
    ASSERT_TRUE(error.span.has_value()) << what;
    EXPECT_EQ(error.span->file, "robot.xacro") << what;
    EXPECT_EQ(error.span->line, 1U) << what;
  }
}

TEST(Xacro, FaultsNameTheirPlaceAndTheWayThere) {
  const auto expanded = expand(
      "<r xmlns:xacro=\"x\">\n<xacro:include filename=\"late.xacro\"/>\n<xacro:macro name=\"m\">\n"
      "<xacro:bad/>\n</xacro:macro>\n<xacro:m/></r>");
  ASSERT_FALSE(expanded.ok());
  const Diagnostic& error = expanded.errors().front();
  EXPECT_EQ(error.message,
            "`robot.xacro` cannot be expanded: NameError: name 'nothing' is not defined");
  EXPECT_EQ(error.span->file, "late.xacro");
  EXPECT_EQ(error.span->line, 3U);
  EXPECT_EQ(error.span->column, 3U);
  EXPECT_EQ(error.why, (std::vector<std::string>{"the expression is: nothing",
                                                 "in the macro `bad`, called at robot.xacro:4",
                                                 "in the macro `m`, called at robot.xacro:6"}));
}

TEST(Xacro, FilesThatAreNoXmlAreTold) {
  const auto broken = expand(robot("\n<xacro:include filename=\"broken.xacro\"/>"));
  ASSERT_FALSE(broken.ok());
  EXPECT_EQ(broken.errors().front().code.text(), "R2W0120");
  EXPECT_EQ(broken.errors().front().span->file, "broken.xacro");
  const auto undeclared = expand("<r>\n <xacro:property name=\"a\" value=\"1\"/></r>");
  ASSERT_FALSE(undeclared.ok());
  EXPECT_EQ(undeclared.errors().front().code.text(), "R2W0120");
  EXPECT_EQ(undeclared.errors().front().span->line, 2U);
  EXPECT_NE(undeclared.errors().front().label.find("xmlns:xacro"), std::string::npos);
  for (const char* document : {"<a b='1' b='2'/>", "<a/><b/>", "", "text", "<a><b></a>"})
    EXPECT_FALSE(expand(document).ok()) << document;
}

// Guarantee, hostile input: xacro files that call, include or define themselves, double each time
// or ask for texts and lists without end are refused, within bounds of time and memory
TEST(Xacro, HostileDocumentsEnd) {
  const auto refused = [](const std::string& content, const std::string& message) {
    const auto expanded = expand(robot(content));
    ASSERT_FALSE(expanded.ok()) << content.substr(0, 200);
    EXPECT_NE(expanded.errors().front().message.find(message), std::string::npos)
        << expanded.errors().front().message;
  };
  refused("<xacro:include filename=\"loop.xacro\"/>", "too many files include each other");
  refused("<xacro:macro name=\"m\"><xacro:m/></xacro:macro><xacro:m/>", "too deep");
  refused(
      "<xacro:macro name=\"m\"><a><xacro:m/></a></xacro:macro><xacro:element "
      "xacro:name=\"xacro:m\"/>",
      "too deep");
  // Each macro calls the next one twice: no element comes of it, but it would take for ever.
  std::string twice = "<xacro:macro name=\"m0\"/>";
  for (int i = 1; i < 60; ++i) {
    const std::string call = "<xacro:m" + std::to_string(i - 1) + "/>";
    twice += "<xacro:macro name=\"m" + std::to_string(i) + "\">" + call + call + "</xacro:macro>";
  }
  refused(twice + "<xacro:m59/>", "too large");
  std::string large =
      "<xacro:macro name=\"m0\"><a b=\"" + std::string(1000, 'x') + "\"/></xacro:macro>";
  for (int i = 1; i < 30; ++i) {
    const std::string call = "<xacro:m" + std::to_string(i - 1) + "/>";
    large += "<xacro:macro name=\"m" + std::to_string(i) + "\">" + call + call + "</xacro:macro>";
  }
  refused(large + "<xacro:m29/>", "too large");
  std::string chain;
  for (int i = 0; i < 5000; ++i)
    chain += "<xacro:property name=\"p" + std::to_string(i) + "\" value=\"${p" +
             std::to_string(i + 1) + " + 1}\"/>";
  refused(chain + "<xacro:property name=\"p5000\" value=\"1\"/>${p0}", "too deep");
  std::string deep = "<xacro:property name=\"l\" value=\"${[]}\"/>";
  for (int i = 0; i < 100; ++i)
    deep += "<xacro:property name=\"l\" value=\"${[l]}\" lazy_eval=\"false\"/>";
  refused(deep, "too deep");
  refused("${[a for a in range(99999) for b in range(99999)]}", "too much work");
  refused("${'a' * 99999999}", "MemoryError");
  refused("${[0] * 9999999999}", "MemoryError");
  refused("${[[0] * 100000] * 100000}", "MemoryError");
  refused("${[['a' * 1000000]] * 100000}", "MemoryError");
  refused("${range(999999999)}", "MemoryError");
  refused("${9**9**9}", "OverflowError");
  refused("${'%999999999d' % 1}", "too large");
  refused("${" + std::string(3000, '(') + "}", "RecursionError");
  refused("${x" + std::string(2000, '.') + "}", "SyntaxError");
  std::string nested;
  for (int i = 0; i < 300; ++i) nested += "<a>";
  EXPECT_FALSE(expand(robot(nested)).ok());
}

TEST(Xacro, CommandLines) {
  const auto request = [](const std::string& line) { return xacro_command(line, "/w", {}); };
  const auto plain = request("xacro robot.xacro a:=1 'b:=x y' \"c:= 2 \" d:=");
  ASSERT_TRUE(plain && plain->ok());
  EXPECT_EQ((*plain)->path, "/w/robot.xacro");
  EXPECT_EQ((*plain)->arguments,
            (std::map<std::string, std::string>{{"a", "1"}, {"b", "x y"}, {"c", "2"}}));
  for (const char* line :
       {"/opt/ros/jazzy/bin/xacro /a/b.xacro", " ros2 run xacro xacro /a/b.xacro",
        "xacro -q --inorder /a/b.xacro", "xacro --verbosity 0 /a/b.xacro"}) {
    const auto one = request(line);
    ASSERT_TRUE(one && one->ok()) << line;
    EXPECT_EQ((*one)->path, "/a/b.xacro");
  }
  for (const char* line : {"cat xacro", "", "ros2 run xacro other", "xacro 'open", "xacrow a"})
    EXPECT_FALSE(request(line).has_value()) << line;
  for (const char* line : {"xacro", "xacro a:=1", "xacro a b", "xacro a -o b", "xacro --deps a"}) {
    const auto one = request(line);
    ASSERT_TRUE(one.has_value()) << line;
    ASSERT_FALSE(one->ok()) << line;
    EXPECT_EQ(one->errors().front().code.text(), "R2W0418") << line;
  }
}

}  // namespace
}  // namespace ros2wasm
