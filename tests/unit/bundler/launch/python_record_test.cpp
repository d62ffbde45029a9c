// Answers of Python that are asked for again.
#include <gtest/gtest.h>

#include "bundler/launch/python_record.hpp"

namespace ros2wasm {
namespace {

std::string call(int number, const std::string& robot, const std::string& speed) {
  return R"({"do":"call","configurations":{"robot":")" + robot + R"(","speed":")" + speed +
         R"("},"environment":{},"number":)" + std::to_string(number) + "}";
}

const auto kNoReply = [](const std::string&) { return std::string(); };

/// A function that reads `robot` and sets `made` to it.
LaunchPython python(int& asked) {
  return [&asked](const std::string& request, const auto& reply) -> Outcome<std::string> {
    ++asked;
    static_cast<void>(reply(R"({"ask": "log", "text": "said"})"));
    const bool is_a = request.find(R"("robot":"a")") != std::string::npos;
    const std::string robot = is_a ? "a" : "b";
    return R"({"configurations":{"robot":")" + robot + R"(","speed":"1","made":")" + robot +
           R"("},"reads":["robot"]})";
  };
}

TEST(PythonRecord, AnswersWhatTheFunctionReadWhateverElseIs) {
  int asked = 0;
  PythonRecord record;
  ASSERT_TRUE(record.recording(python(asked))(call(1, "a", "1"), kNoReply).ok());
  ASSERT_TRUE(record.recording(python(asked))(call(1, "b", "1"), kNoReply).ok());
  ASSERT_TRUE(record.recording(python(asked))(call(1, "b", "1"), kNoReply).ok());
  EXPECT_EQ(asked, 2) << "the third is known";

  PythonRecord kept(record.exchanges());
  int decided = 0;
  int said = 0;
  const auto count = [&](const std::string&) {
    ++said;
    return std::string();
  };
  const auto exact = kept.replaying([&] { ++decided; })(call(1, "b", "5"), count);
  ASSERT_TRUE(exact.ok());
  EXPECT_EQ(*exact, R"({"reads":["robot"],"configurations":{"made":"b","robot":"b","speed":"5"}})");
  EXPECT_EQ(decided, 0);
  EXPECT_EQ(said, 1) << "what it logged is said again";

  const auto other = kept.replaying([&] { ++decided; })(call(1, "c", "5"), count);
  ASSERT_TRUE(other.ok());
  EXPECT_EQ(decided, 1);
  EXPECT_NE(other->find(R"("made":"a")"), std::string::npos) << "as it was first";
  EXPECT_NE(other->find(R"("robot":"c")"), std::string::npos) << "which the function did not set";
}

TEST(PythonRecord, RefusesWhatWasNeverAsked) {
  int asked = 0;
  PythonRecord record;
  ASSERT_TRUE(record.recording(python(asked))(call(1, "a", "1"), kNoReply).ok());
  bool decided = false;
  const auto answer = record.replaying([&] { decided = true; })(call(2, "a", "1"), kNoReply);
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.errors().front().code.text(), "R2W0732");
  EXPECT_TRUE(decided);
}

TEST(PythonRecord, GivesTheSameQuestionOfOneEvaluationItsOwnAnswers) {
  int asked = 0;
  PythonRecord record;
  const LaunchPython first = record.recording(python(asked));
  ASSERT_TRUE(first(call(1, "a", "1"), kNoReply).ok());
  ASSERT_TRUE(first(call(1, "a", "1"), kNoReply).ok());
  EXPECT_EQ(asked, 2);
  const LaunchPython second = record.recording(python(asked));
  ASSERT_TRUE(second(call(1, "a", "1"), kNoReply).ok());
  ASSERT_TRUE(second(call(1, "a", "1"), kNoReply).ok());
  EXPECT_EQ(asked, 2);
}

TEST(PythonRecord, SurvivesJson) {
  int asked = 0;
  PythonRecord record;
  ASSERT_TRUE(record.recording(python(asked))(call(1, "a", "1"), kNoReply).ok());
  JsonWriter json;
  write_python_exchanges(json, record.exchanges());
  const auto parsed = parse_json(json.text(), "a test", "R2W0416");
  ASSERT_TRUE(parsed.ok());
  const auto read = read_python_exchanges(&*parsed);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].request, record.exchanges()[0].request);
  EXPECT_EQ(read[0].answer, record.exchanges()[0].answer);
  EXPECT_EQ(read[0].asked, record.exchanges()[0].asked);
  EXPECT_TRUE(read_python_exchanges(nullptr).empty());
}

}  // namespace
}  // namespace ros2wasm
