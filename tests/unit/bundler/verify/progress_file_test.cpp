// Files that students hand in, whole and hostile. What the page writes:
// tests/unit/ui/progress_file.test.ts.
//
// Guarantee, hostile input: a file that a student hands in and that was changed, cut, put together
// by hand or made for another site is refused with a code; no cell of the CSV is a formula
#include "bundler/verify/progress_file.hpp"

#include <gtest/gtest.h>

#include "bundler/io/base64.hpp"
#include "bundler/io/ed25519.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

const std::string kHash(64, 'a');
const std::string kRecord =
    R"({"student":"Ada","exported_at":"2026-11-28T09:00:00.000Z","course":"Robots","labs":[)"
    R"({"title":"Drive","sha256":")" +
    kHash +
    R"(","tasks":[{"title":"=A1","done_at":"2026-11-28T08:00:00Z","hint_at":"2026-11-28T07:59:00.5Z"}]}]})";

std::string signed_file(const std::string& record, const std::string& change = {}) {
  const std::string seed(32, 's');
  const std::string public_key = ed25519_public(seed + std::string(32, '\0'));
  const std::string signature = ed25519_sign("ros2wasm progress 1\n" + record, seed + public_key);
  JsonWriter json;
  json.begin_object().field("format", "ros2wasm progress").field_integer("schema", 1);
  json.field("record", record + change).field("key", base64(public_key));
  json.field("signature", base64(signature)).end_object();
  return json.text();
}

std::string good_record() {
  std::string record = kRecord;
  return record.replace(record.find("07:59:00.5Z"), 11, "07:59:00.500Z");
}

std::string refused(const std::string& text) {
  const auto file = read_progress_file(text, "ada.json");
  return file ? "" : file.errors().front().code.text();
}

TEST(ProgressFile, IsReadWithItsKey) {
  const auto file = read_progress_file(signed_file(good_record()), "ada.json");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->student, "Ada");
  EXPECT_EQ(file->course, "Robots");
  EXPECT_EQ(file->key.size(), 16U);
  ASSERT_EQ(file->labs.size(), 1U);
  EXPECT_EQ(file->labs.front().tasks.front().done_at, "2026-11-28T08:00:00Z");
  EXPECT_EQ(file->labs.front().tasks.front().solution_at, "");
}

TEST(ProgressFile, OneOtherByteAndItIsRefused) {
  EXPECT_EQ(refused(signed_file(good_record(), " ")), "R2W0671");
  std::string other = signed_file(good_record());
  other.replace(other.find("Ada"), 3, "Bob");
  EXPECT_EQ(refused(other), "R2W0671");
}

TEST(ProgressFile, WhatIsNoneIsRefused) {
  EXPECT_EQ(refused(""), "R2W0670");
  EXPECT_EQ(refused("[]"), "R2W0670");
  EXPECT_EQ(refused(std::string(100'000, '[')), "R2W0670");
  EXPECT_EQ(refused(R"({"format":"ros2wasm progress","schema":2})"), "R2W0670");
  EXPECT_EQ(
      refused(
          R"({"format":"ros2wasm progress","schema":1,"record":"{}","key":"AA==","signature":""})"),
      "R2W0670");
  // Signed, but not of the page's form.
  EXPECT_EQ(refused(signed_file(kRecord)), "R2W0670") << "a fraction of one digit";
  for (const auto& [from, to] :
       {std::pair("\"Ada\"", "\"A\\u001b[2Jda\""), std::pair("\"Ada\"", "\"\""),
        std::pair("\"Ada\"", "7"), std::pair("\"Ada\"", "\"A\\u009bda\""),
        std::pair("\"labs\"", "\"lab\""), std::pair("aaaaaaaa", "xyz"),
        std::pair("2026-11-28T08", "yesterday!!!!"), std::pair("\"Ada\"", "\"A\u202eda\""),
        std::pair("\"Ada\"", "\"A\u2028da\""), std::pair("\"Ada\"", "\"\ufeff=1\"")}) {
    std::string record = good_record();
    record.replace(record.find(from), std::string_view(from).size(), to);
    EXPECT_EQ(refused(signed_file(record)), "R2W0670") << to;
  }
}

AskedTasks site_called(const std::string& name, const std::string& course = {}) {
  return {.sha256 = kHash, .titles = {"=A1"}, .names = {name}, .course = course};
}

std::string faults_of(const ProgressFile& file, const std::vector<AskedTasks>& sites) {
  std::string all;
  for (const Diagnostic& fault : check_progress(file, sites, "ada.json"))
    all += fault.code + " " + fault.message + "\n";
  return all;
}

TEST(ProgressFile, IsComparedWithSites) {
  const auto file = read_progress_file(signed_file(good_record()), "ada.json");
  ASSERT_TRUE(file);
  EXPECT_EQ(faults_of(*file, {site_called("Drive")}), "");
  AskedTasks other = site_called("Drive");
  other.sha256 = std::string(64, 'b');
  EXPECT_EQ(faults_of(*file, {other}), "R2W0672 `ada.json` is of another site: `Drive`\n");
  AskedTasks more = site_called("Drive");
  more.titles.push_back("more");
  EXPECT_EQ(faults_of(*file, {more}), "R2W0672 `ada.json` has other tasks than the site `Drive`\n");
  const std::string site =
      R"({"generator":"ros2wasm","name":"one","title":"Drive","tasks":[{"title":"=A1"}]})";
  const auto asked = asked_tasks(site, "site.json");
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->sha256, sha256_hex(site));
  EXPECT_EQ(asked->titles, std::vector<std::string>{"=A1"});
  EXPECT_EQ(asked->names, std::vector<std::string>{"Drive"});
  EXPECT_EQ(asked_tasks(R"({"name":"one"})", "site.json")->names, std::vector<std::string>{"one"});
}

TEST(ProgressFile, HasTheTitlesThatThePageWrites) {
  const auto file = read_progress_file(signed_file(good_record()), "ada.json");
  ASSERT_TRUE(file);
  EXPECT_EQ(faults_of(*file, {site_called("Fly")}),
            "R2W0672 `ada.json` has another title for the lab `Fly`\n");
  AskedTasks listed = site_called("Fly", "Robots");
  listed.names.emplace_back("Drive");
  EXPECT_EQ(faults_of(*file, {listed}), "") << "the course has a title of its own for it";
  EXPECT_EQ(faults_of(*file, {site_called("Fly"), site_called("Drive")}), "")
      << "one site in two places of a course";
  EXPECT_EQ(faults_of(*file, {site_called("Drive", "Boats")}),
            "R2W0672 `ada.json` is of another course: `Robots`\n");
  std::string record = good_record();
  record.replace(record.find("Drive"), 5, "Dri ve");
  const auto spaced = read_progress_file(signed_file(record), "ada.json");
  ASSERT_TRUE(spaced);
  EXPECT_EQ(faults_of(*spaced, {site_called("Dri\u202eve")}), "")
      << "the page writes a space for what steers a terminal";
}

TEST(ProgressFile, HasEachLabOnce) {
  std::string record = good_record();
  const std::size_t begin = record.find(R"({"title":"Drive")");
  record.insert(begin, record.substr(begin, record.rfind("]}") - begin) + ",");
  const auto file = read_progress_file(signed_file(record), "ada.json");
  ASSERT_TRUE(file);
  EXPECT_EQ(faults_of(*file, {site_called("Drive")}),
            "R2W0672 `ada.json` has the lab `Drive` more than once\n");
}

TEST(ProgressFile, LacksLabsOfItsCourse) {
  const auto file = read_progress_file(signed_file(good_record()), "ada.json");
  ASSERT_TRUE(file);
  AskedTasks fly = site_called("Fly", "Robots");
  fly.sha256 = std::string(64, 'b');
  const std::vector<AskedTasks> course{site_called("Drive", "Robots"), fly};
  const auto lacking = lacking_labs(*file, course, "ada.json");
  ASSERT_TRUE(lacking);
  EXPECT_EQ(lacking->code, "R2W0674");
  EXPECT_EQ(lacking->why, std::vector<std::string>{"Fly"});
  fly.names = {"Drive"};
  EXPECT_FALSE(lacking_labs(*file, {fly}, "ada.json")) << "another version of what it has";
  fly.names = {"Fly"};
  fly.titles.clear();
  EXPECT_FALSE(lacking_labs(*file, {fly}, "ada.json")) << "a lab without tasks";
  ProgressFile one = *file;
  one.course.clear();
  EXPECT_FALSE(lacking_labs(one, course, "ada.json")) << "from the page of one lab";
}

TEST(ProgressFile, NoCellIsAFormula) {
  const auto file = read_progress_file(signed_file(good_record()), "-ada.json");
  ASSERT_TRUE(file);
  EXPECT_EQ(progress_csv(*file, "-\"ada\".json"),
            "\"Ada\",\"Robots\",\"Drive\",\"'=A1\",\"2026-11-28T08:00:00Z\","
            "\"2026-11-28T07:59:00.500Z\",\"\",\"2026-11-28T09:00:00.000Z\",\"" +
                file->key + "\",\"" + kHash + "\",\"'-\"\"ada\"\".json\"\n");
}

TEST(ProgressFile, FormulasBehindSpacesAndInFullWidthAreNone) {
  for (const char* text : {" =1", "\u00A0=1", "\u3000+1", "\uFF1D1", "\uFF201"}) {
    std::string record = good_record();
    record.replace(record.find("Ada"), 3, text);
    const auto file = read_progress_file(signed_file(record), "ada.json");
    ASSERT_TRUE(file) << text;
    EXPECT_TRUE(progress_csv(*file, "ada.json").starts_with("\"'" + std::string(text))) << text;
  }
}

TEST(ProgressFile, TasksHaveALimitForTheWholeCourse) {
  const auto course = [](int labs) {
    std::string tasks;
    for (int i = 0; i < 100; ++i) tasks += std::string(i == 0 ? "" : ",") + R"({"title":"a"})";
    std::string record = R"({"student":"Ada","exported_at":"2026-11-28T09:00:00.000Z","labs":[)";
    for (int i = 0; i < labs; ++i)
      record += std::string(i == 0 ? "" : ",") + R"({"title":"l","sha256":")" + kHash +
                R"(","tasks":[)" + tasks + "]}";
    return signed_file(record + "]}");
  };
  EXPECT_TRUE(read_progress_file(course(50), "ada.json"));
  EXPECT_EQ(refused(course(51)), "R2W0670");
}

}  // namespace
}  // namespace ros2wasm
