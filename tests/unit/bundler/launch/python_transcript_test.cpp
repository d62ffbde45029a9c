// Talks with Python that go as one before, and that go another way.
#include "bundler/launch/host/python_transcript.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

using Reply = std::function<std::string(const std::string&)>;

/// Says what it is asked, after a question of its own for requests that begin with `?`.
struct Interpreter {
  std::vector<std::string> heard;

  LaunchPython live() {
    return [this](const std::string& request, const Reply& reply) -> Outcome<std::string> {
      heard.push_back(request);
      if (request == "fails") return Diagnostic{.code = "R2W0416", .message = "it fails"};
      if (!request.starts_with('?')) return "says " + request;
      const std::string who = reply("who");
      return "says " + request + " " + who + reply("where");
    };
  }
};

struct Told {
  std::string name;
  int count = 0;

  Reply reply() {
    return [this](const std::string& text) {
      ++count;
      return text == "who" ? name : std::string("here");
    };
  }
};

std::vector<PythonRemark> talk(const std::string& name) {
  Interpreter interpreter;
  PythonTranscript transcript({}, interpreter.live());
  Told told{name};
  for (const char* request : {"a", "?b", "c"}) EXPECT_TRUE(transcript.ask(request, told.reply()));
  EXPECT_TRUE(transcript.is_live());
  return transcript.remarks();
}

TEST(PythonTranscript, TheSameTalkAsksNobody) {
  Interpreter interpreter;
  PythonTranscript transcript(talk("x"), interpreter.live());
  Told told{"x"};
  EXPECT_EQ(*transcript.ask("a", told.reply()), "says a");
  EXPECT_EQ(*transcript.ask("?b", told.reply()), "says ?b xhere");
  EXPECT_EQ(told.count, 2);  // what it says in between is heard
  EXPECT_EQ(*transcript.ask("c", told.reply()), "says c");
  EXPECT_FALSE(transcript.is_live());
  EXPECT_TRUE(interpreter.heard.empty());
}

TEST(PythonTranscript, AShorterTalkIsLedToItsOwnEnd) {
  Interpreter interpreter;
  PythonTranscript transcript(talk("x"), interpreter.live());
  Told told{"x"};
  EXPECT_EQ(*transcript.ask("a", told.reply()), "says a");
  EXPECT_TRUE(transcript.end());
  EXPECT_TRUE(transcript.is_live());
  EXPECT_EQ(interpreter.heard, std::vector<std::string>{"a"});
  EXPECT_EQ(transcript.remarks().size(), 1U);
  EXPECT_TRUE(transcript.end());
}

TEST(PythonTranscript, AnotherRequestIsAskedAfterThoseBefore) {
  Interpreter interpreter;
  PythonTranscript transcript(talk("x"), interpreter.live());
  Told told{"x"};
  EXPECT_TRUE(transcript.ask("a", told.reply()));
  EXPECT_TRUE(transcript.ask("?b", told.reply()));
  EXPECT_EQ(*transcript.ask("d", told.reply()), "says d");
  EXPECT_EQ(interpreter.heard, (std::vector<std::string>{"a", "?b", "d"}));
  EXPECT_EQ(told.count, 2);  // not once more when it is led there
  ASSERT_EQ(transcript.remarks().size(), 3U);
  EXPECT_EQ(transcript.remarks()[2].request, "d");
}

TEST(PythonTranscript, AnotherReplyIsPassedOn) {
  Interpreter interpreter;
  PythonTranscript transcript(talk("x"), interpreter.live());
  Told told{"y"};
  EXPECT_TRUE(transcript.ask("a", told.reply()));
  EXPECT_EQ(*transcript.ask("?b", told.reply()), "says ?b yhere");
  EXPECT_EQ(told.count, 2);  // each question is answered once
  EXPECT_EQ(interpreter.heard, (std::vector<std::string>{"a", "?b"}));
  const std::vector<std::pair<std::string, std::string>> asked{{"who", "y"}, {"where", "here"}};
  EXPECT_EQ(transcript.remarks()[1].asked, asked);
}

TEST(PythonTranscript, MoreRequestsThanWereKept) {
  Interpreter interpreter;
  PythonTranscript transcript(talk("x"), interpreter.live());
  Told told{"x"};
  for (const char* request : {"a", "?b", "c"}) EXPECT_TRUE(transcript.ask(request, told.reply()));
  EXPECT_EQ(*transcript.ask("e", told.reply()), "says e");
  EXPECT_EQ(interpreter.heard, (std::vector<std::string>{"a", "?b", "c", "e"}));
}

TEST(PythonTranscript, WhoSaysSomethingElseNowIsNotBelieved) {
  auto known = talk("x");
  known[0].answer = "said something else";
  Interpreter interpreter;
  PythonTranscript transcript(known, interpreter.live());
  Told told{"x"};
  EXPECT_EQ(*transcript.ask("a", told.reply()), "said something else");
  const auto other = transcript.ask("d", told.reply());
  ASSERT_FALSE(other);
  EXPECT_EQ(other.errors().front().code.text(), "R2W0416");
  EXPECT_TRUE(transcript.has_failed());
}

TEST(PythonTranscript, FailuresAreKnown) {
  Interpreter interpreter;
  PythonTranscript transcript({}, interpreter.live());
  Told told{"x"};
  EXPECT_FALSE(transcript.ask("fails", told.reply()));
  EXPECT_TRUE(transcript.has_failed());
}

TEST(KeptPython, GoesThroughJson) {
  const KeptPython kept{.remarks = talk("\"x\"\n"), .seen = {{"/a", "none"}, {"/b", "file 3"}}};
  const auto back = read_kept_python(kept_python_json(kept));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->seen, kept.seen);
  ASSERT_EQ(back->remarks.size(), 3U);
  EXPECT_EQ(back->remarks[1].asked, kept.remarks[1].asked);
  EXPECT_EQ(back->remarks[1].answer, kept.remarks[1].answer);
  for (const char* text :
       {"", "[]", "{}", R"({"schema":2,"remarks":[],"seen":{}})",
        R"({"schema":1,"remarks":[{}],"seen":{}})", R"({"schema":1,"remarks":[],"seen":{"a":1}})"})
    EXPECT_FALSE(read_kept_python(text)) << text;
}

}  // namespace
}  // namespace ros2wasm
